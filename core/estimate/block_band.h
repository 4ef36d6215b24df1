/// Normal equations of a smoother: symmetric, positive definite, and only neighbouring instants have to do with each
/// other.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace limbwave::estimate {

/// H x = b with H of blocks × blocks square blocks of `size`; H(i, j) = 0 for |i − j| > reach. Cholesky and the part of
/// the inverse within the band, both in time and memory proportional to the number of blocks.
class BlockBand {
 public:
  BlockBand(std::size_t blocks, Eigen::Index size, std::size_t reach);

  [[nodiscard]] std::size_t blocks() const { return blocks_; }
  [[nodiscard]] Eigen::Index size() const { return size_; }
  [[nodiscard]] std::size_t reach() const { return reach_; }

  void set_zero();
  /// H(row, column) for column <= row <= column + reach; of the blocks on the diagonal only the lower half counts.
  Eigen::MatrixXd& at(std::size_t row, std::size_t column) { return lower_[column * (reach_ + 1) + row - column]; }
  Eigen::VectorXd& right(std::size_t block) { return right_[block]; }
  [[nodiscard]] const Eigen::VectorXd& right(std::size_t block) const { return right_[block]; }

  /// H = L Lᵀ in place. False when H is not positive definite.
  bool factor();
  /// x for the right side; after `factor`.
  [[nodiscard]] std::vector<Eigen::VectorXd> solve() const;
  /// The diagonal blocks of H⁻¹; after `factor`. (Takahashi, Fagan & Chen 1973, by blocks.)
  [[nodiscard]] std::vector<Eigen::MatrixXd> covariances() const;

 private:
  [[nodiscard]] const Eigen::MatrixXd& lower(std::size_t row, std::size_t column) const {
    return lower_[column * (reach_ + 1) + row - column];
  }
  std::size_t blocks_;
  Eigen::Index size_;
  std::size_t reach_;
  std::vector<Eigen::MatrixXd> lower_;
  std::vector<Eigen::VectorXd> right_;
};

}  // namespace limbwave::estimate
