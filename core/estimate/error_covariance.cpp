#include "estimate/error_covariance.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace limbwave::estimate {

void AlignedRows::resize(long rows, long columns) {
  constexpr std::size_t kSlack = 8;
  const auto needed = static_cast<std::size_t>(rows * columns) + kSlack;
  if (memory_.size() < needed) {
    memory_.resize(needed);
  }
  const auto address = reinterpret_cast<std::uintptr_t>(memory_.data());
  data_ = memory_.data() + (64 - address % 64) % 64 / sizeof(double);
  rows_ = rows;
  columns_ = columns;
}

AlignedRows& AlignedRows::operator=(const AlignedRows& other) {
  if (this != &other) {
    resize(other.rows_, other.columns_);
    std::copy_n(other.data_, other.rows_ * other.columns_, data_);
  }
  return *this;
}

AlignedRows& AlignedRows::operator=(AlignedRows&& other) noexcept {
  memory_ = std::move(other.memory_);
  data_ = other.data_;
  rows_ = other.rows_;
  columns_ = other.columns_;
  other.data_ = nullptr;
  other.rows_ = other.columns_ = 0;
  return *this;
}

ErrorCovariance::ErrorCovariance(int size) : size_(size), kernel_(&covariance_kernel()) {
  const long padded = (size + 31) / 32 * 32;
  P_.resize(padded, padded);
  std::fill_n(P_.row(0), padded * padded, 0.0);
}

void ErrorCovariance::set_variance(int i, double variance) {
  for (int j = 0; j < size_; ++j) {
    P_.row(i)[j] = P_.row(j)[i] = 0.0;
  }
  P_.row(i)[i] = variance;
}

Eigen::MatrixXd ErrorCovariance::dense() const {
  Eigen::MatrixXd P(size_, size_);
  for (int i = 0; i < size_; ++i) {
    for (int j = 0; j < size_; ++j) {
      P(i, j) = (*this)(i, j);
    }
  }
  return P;
}

void ErrorCovariance::set_dense(const Eigen::MatrixXd& P) {
  assert(P.rows() == size_ && P.cols() == size_);
  for (int i = 0; i < size_; ++i) {
    for (int j = 0; j < size_; ++j) {
      P_.row(i)[j] = 0.5 * (P(i, j) + P(j, i));
    }
  }
}

double ErrorCovariance::update(MeasurementGroup* first, MeasurementGroup* last, Eigen::VectorXd& correction,
                               UpdateRecord* record) {
  const long n = P_.columns();
  long rows = 0;
  for (const MeasurementGroup* g = first; g != last; ++g) {
    rows += g->rows;
  }
  Y_.resize(rows, n);
  S_.resize(rows, rows);
  // Y = H P and each group's own S; rejected groups leave no rows behind.
  long m = 0;
  for (MeasurementGroup* g = first; g != last; ++g) {
    const auto count = static_cast<long>(g->support.size());
    assert(g->rows == 1 || g->rows == 3);
    (g->rows == 1 ? kernel_->multiply1 : kernel_->multiply3)(P_.row(0), n, g->support.data(), count, g->H.data(),
                                                             Y_.row(m));
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3> own(g->rows, g->rows);
    const auto innovation_product = [&](const MeasurementGroup& of, int r, const double* y) {
      double sum = 0.0;
      for (std::size_t s = 0; s < of.support.size(); ++s) {
        sum += of.H[s * static_cast<std::size_t>(of.rows) + static_cast<std::size_t>(r)] * y[of.support[s]];
      }
      return sum;
    };
    for (int r = 0; r < g->rows; ++r) {
      for (int c = 0; c <= r; ++c) {
        own(r, c) = own(c, r) = innovation_product(*g, r, Y_.row(m + c));
      }
      own(r, r) += g->variance[r];
    }
    const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>> nu(g->innovation, g->rows);
    const auto solved = own.llt().solve(nu).eval();
    g->nis = nu.dot(solved);
    g->accepted = std::isfinite(g->nis) && g->nis >= 0.0 && (g->gate <= 0.0 || g->nis <= g->gate);
    if (!g->accepted && g->softened && std::isfinite(g->nis) && g->nis > 0.0) {
      own *= std::sqrt(g->nis / g->gate);
      g->accepted = true;
    }
    if (!g->accepted) {
      continue;
    }
    S_.block(m, m, g->rows, g->rows) = own;
    long before = 0;
    for (const MeasurementGroup* other = first; other != g; ++other) {
      if (!other->accepted) {
        continue;
      }
      for (int r = 0; r < g->rows; ++r) {
        for (int c = 0; c < other->rows; ++c) {
          S_(m + r, before + c) = innovation_product(*g, r, Y_.row(before + c));
        }
      }
      before += other->rows;
    }
    m += g->rows;
  }
  if (m == 0) {
    return 0.0;
  }
  // S = L Lᵀ in place, W = L⁻¹ Y in place, e = L⁻¹ ν.
  std::vector<double> e;
  e.reserve(static_cast<std::size_t>(m));
  for (const MeasurementGroup* g = first; g != last; ++g) {
    e.insert(e.end(), g->innovation, g->innovation + (g->accepted ? g->rows : 0));
  }
  double log_likelihood = 0.0;
  for (long i = 0; i < m; ++i) {
    for (long k = 0; k < i; ++k) {
      double value = S_(i, k);
      for (long l = 0; l < k; ++l) {
        value -= S_(i, l) * S_(k, l);
      }
      S_(i, k) = value / S_(k, k);
      kernel_->subtract(Y_.row(i), Y_.row(k), S_(i, k), n);
      e[static_cast<std::size_t>(i)] -= S_(i, k) * e[static_cast<std::size_t>(k)];
      S_(i, i) -= S_(i, k) * S_(i, k);
    }
    S_(i, i) = std::sqrt(std::max(S_(i, i), 1e-30));
    const double scale = 1.0 / S_(i, i);
    double* y = Y_.row(i);
    for (long j = 0; j < n; ++j) {
      y[j] *= scale;
    }
    double& whitened = e[static_cast<std::size_t>(i)];
    whitened *= scale;
    log_likelihood -= 0.5 * whitened * whitened + std::log(S_(i, i)) + 0.918938533204672742;
  }
  for (long i = 0; i < m; ++i) {
    const double* w = Y_.row(i);
    for (int j = 0; j < size_; ++j) {
      correction[j] += w[j] * e[static_cast<std::size_t>(i)];
    }
  }
  kernel_->downdate(P_.row(0), n, Y_.row(0), m);
  if (record != nullptr) {
    // The union of the supports, and G = L⁻¹ H on it.
    record->support.clear();
    for (const MeasurementGroup* g = first; g != last; ++g) {
      if (g->accepted) {
        record->support.insert(record->support.end(), g->support.begin(), g->support.end());
      }
    }
    std::sort(record->support.begin(), record->support.end());
    record->support.erase(std::unique(record->support.begin(), record->support.end()), record->support.end());
    const auto columns = static_cast<long>(record->support.size() + 7) / 8 * 8;
    record->G.resize(m, columns);
    std::fill_n(record->G.row(0), m * columns, 0.0);
    long i = 0;
    for (const MeasurementGroup* g = first; g != last; ++g) {
      for (int r = 0; g->accepted && r < g->rows; ++r, ++i) {
        for (std::size_t s = 0; s < g->support.size(); ++s) {
          const auto at = std::lower_bound(record->support.begin(), record->support.end(), g->support[s]);
          record->G.row(i)[at - record->support.begin()] +=
              g->H[s * static_cast<std::size_t>(g->rows) + static_cast<std::size_t>(r)];
        }
        for (long k = 0; k < i; ++k) {
          kernel_->subtract(record->G.row(i), record->G.row(k), S_(i, k), columns);
        }
        for (long c = 0; c < columns; ++c) {
          record->G.row(i)[c] /= S_(i, i);
        }
      }
    }
    record->W.resize(m, n);
    std::copy_n(Y_.row(0), m * n, record->W.row(0));
    record->e = std::move(e);
  }
  return log_likelihood;
}

}  // namespace limbwave::estimate
