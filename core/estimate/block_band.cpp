#include "estimate/block_band.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace limbwave::estimate {

using Eigen::MatrixXd;
using Eigen::VectorXd;

BlockBand::BlockBand(std::size_t blocks, Eigen::Index size, std::size_t reach)
    : blocks_(blocks),
      size_(size),
      reach_(reach),
      lower_(blocks * (reach + 1), MatrixXd::Zero(size, size)),
      right_(blocks, VectorXd::Zero(size)) {}

void BlockBand::set_zero() {
  for (MatrixXd& block : lower_) {
    block.setZero();
  }
  for (VectorXd& block : right_) {
    block.setZero();
  }
}

bool BlockBand::factor() {
  for (std::size_t k = 0; k < blocks_; ++k) {
    MatrixXd& diagonal = at(k, k);
    const Eigen::LLT<MatrixXd> llt(diagonal.selfadjointView<Eigen::Lower>());
    if (llt.info() != Eigen::Success) {
      return false;
    }
    diagonal = llt.matrixL();
    const std::size_t last = std::min(blocks_ - 1, k + reach_);
    for (std::size_t i = k + 1; i <= last; ++i) {
      MatrixXd& block = at(i, k);
      diagonal.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(block);
    }
    for (std::size_t j = k + 1; j <= last; ++j) {
      for (std::size_t i = j; i <= last; ++i) {
        at(i, j).noalias() -= at(i, k) * at(j, k).transpose();
      }
    }
  }
  return true;
}

std::vector<VectorXd> BlockBand::solve() const {
  std::vector<VectorXd> x = right_;
  for (std::size_t k = 0; k < blocks_; ++k) {
    for (std::size_t j = k - std::min(k, reach_); j < k; ++j) {
      x[k].noalias() -= lower(k, j) * x[j];
    }
    lower(k, k).triangularView<Eigen::Lower>().solveInPlace(x[k]);
  }
  for (std::size_t k = blocks_; k-- > 0;) {
    for (std::size_t i = k + 1; i <= std::min(blocks_ - 1, k + reach_); ++i) {
      x[k].noalias() -= lower(i, k).transpose() * x[i];
    }
    lower(k, k).triangularView<Eigen::Lower>().transpose().solveInPlace(x[k]);
  }
  return x;
}

std::vector<MatrixXd> BlockBand::covariances() const {
  // Z = H⁻¹ obeys Z L = L⁻ᵀ: from the last column of blocks to the first, what is below the diagonal follows from what
  // is to its right. Only the band is kept: inverse[i][j] = Z(i, i + j).
  std::vector<MatrixXd> diagonal(blocks_);
  std::vector<std::vector<MatrixXd>> kept(blocks_);
  const MatrixXd identity = MatrixXd::Identity(size_, size_);
  const auto Z = [&](std::size_t i, std::size_t j) -> MatrixXd {
    return i <= j ? kept[i][j - i] : MatrixXd(kept[j][i - j].transpose());
  };
  for (std::size_t k = blocks_; k-- > 0;) {
    const std::size_t last = std::min(blocks_ - 1, k + reach_);
    const MatrixXd inverse = lower(k, k).triangularView<Eigen::Lower>().solve(identity);
    std::vector<MatrixXd>& row = kept[k];
    row.assign(last - k + 1, MatrixXd());
    std::vector<MatrixXd> scaled;  // L(i, k) L(k, k)⁻¹
    for (std::size_t i = k + 1; i <= last; ++i) {
      scaled.emplace_back(lower(i, k) * inverse);
    }
    for (std::size_t j = k + 1; j <= last; ++j) {
      MatrixXd sum = MatrixXd::Zero(size_, size_);  // Z(j, k)
      for (std::size_t i = k + 1; i <= last; ++i) {
        sum.noalias() -= Z(j, i) * scaled[i - k - 1];
      }
      row[j - k] = sum.transpose();
    }
    MatrixXd own = inverse.transpose() * inverse;
    for (std::size_t i = k + 1; i <= last; ++i) {
      own.noalias() -= row[i - k] * scaled[i - k - 1];
    }
    row[0] = 0.5 * (own + own.transpose());
    diagonal[k] = row[0];
    if (k + reach_ + 1 < blocks_) {
      kept[k + reach_ + 1].clear();  // out of everyone's reach
    }
  }
  return diagonal;
}

}  // namespace limbwave::estimate
