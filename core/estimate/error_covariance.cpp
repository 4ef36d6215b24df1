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

ErrorCovariance::ErrorCovariance(int size) : size_(size), width_((size + 31) / 32 * 32), kernel_(&covariance_kernel()) {
  P_.resize(width_, AlignedRows::spread(width_));
  std::fill_n(P_.row(0), P_.rows() * P_.columns(), 0.0);
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

// Y = H P of the groups that are accepted, each judged by its own innovation; rejected ones leave no rows behind.
// Returns how many rows there are.
long ErrorCovariance::accept(MeasurementGroup* first, MeasurementGroup* last) {
  const long stride = P_.columns();
  long m = 0;
  for (MeasurementGroup* g = first; g != last; ++g) {
    const auto count = static_cast<long>(g->support.size());
    assert(g->rows == 1 || g->rows == 3);
    (g->rows == 1 ? kernel_->multiply1 : kernel_->multiply3)(P_.row(0), stride, width_, g->support.data(), count,
                                                             g->H.data(), Y_.row(m), stride);
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3> own(g->rows, g->rows);
    for (int r = 0; r < g->rows; ++r) {
      for (int c = 0; c <= r; ++c) {
        const double* y = Y_.row(m + c);
        double sum = 0.0;
        for (std::size_t s = 0; s < g->support.size(); ++s) {
          sum += g->H[s * static_cast<std::size_t>(g->rows) + static_cast<std::size_t>(r)] * y[g->support[s]];
        }
        own(r, c) = own(c, r) = sum;
      }
      own(r, r) += g->variance[r];
    }
    const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>> nu(g->innovation, g->rows);
    g->nis = nu.dot(own.llt().solve(nu));
    g->inflation = 1.0;
    g->accepted = std::isfinite(g->nis) && g->nis >= 0.0 && (g->gate <= 0.0 || g->nis <= g->gate);
    if (!g->accepted && g->softened && std::isfinite(g->nis) && g->nis > 0.0) {
      g->inflation = std::sqrt(g->nis / g->gate);
      g->accepted = true;
    }
    m += g->accepted ? g->rows : 0;
  }
  return m;
}

// The upper triangle of S = H P Hᵀ + R, by rows of Yᵀ.
void ErrorCovariance::innovation_covariance(const MeasurementGroup* first, const MeasurementGroup* last, long m) {
  constexpr long kWidth = 32;
  const long stride = S_.columns();
  const long width = (m + kWidth - 1) / kWidth * kWidth;
  kernel_->transpose(Y_.row(0), (m + 3) / 4 * 4, width_, P_.columns(), Y_transposed_.row(0), stride);
  long at = 0;
  for (const MeasurementGroup* g = first; g != last; ++g) {
    if (!g->accepted) {
      continue;
    }
    const long from = at / kWidth * kWidth;
    (g->rows == 1 ? kernel_->multiply1 : kernel_->multiply3)(Y_transposed_.row(0) + from, stride, width - from,
                                                             g->support.data(), static_cast<long>(g->support.size()),
                                                             g->H.data(), S_.row(at) + from, stride);
    for (int r = 0; r < g->rows; ++r) {
      double* block = S_.row(at + r) + at;
      block[r] += g->variance[r];
      for (int c = r; c < g->rows; ++c) {
        block[c] *= g->inflation;
      }
    }
    at += g->rows;
  }
}

void ErrorCovariance::keep(const MeasurementGroup* first, const MeasurementGroup* last, UpdateRecord& record) {
  record.groups.clear();
  record.support.clear();
  record.H.clear();
  for (const MeasurementGroup* g = first; g != last; ++g) {
    if (g->accepted) {
      record.groups.push_back({g->rows, static_cast<int>(g->support.size())});
      record.support.insert(record.support.end(), g->support.begin(), g->support.end());
      record.H.insert(record.H.end(), g->H.begin(), g->H.end());
    }
  }
  // What was of use is given away, and what the record had before is used next.
  std::swap(record.U, S_);
  std::swap(record.W, Y_);
  record.inverse = inverse_;
  record.e = e_;
}

double ErrorCovariance::update(MeasurementGroup* first, MeasurementGroup* last, Eigen::VectorXd& correction,
                               UpdateRecord* record) {
  const long stride = P_.columns();
  long rows = 0;
  for (const MeasurementGroup* g = first; g != last; ++g) {
    rows += g->rows;
  }
  Y_.resize((rows + 3) / 4 * 4, stride);
  const long m = accept(first, last);
  if (m == 0) {
    return 0.0;
  }
  constexpr long kWidth = 32;
  const long padded = AlignedRows::spread((m + kWidth - 1) / kWidth * kWidth);
  S_.resize(m, padded);
  Y_transposed_.resize(width_, padded);
  packed_.resize(m, width_);
  innovation_covariance(first, last, m);
  inverse_.resize(static_cast<std::size_t>(m));
  kernel_->factor(S_.row(0), m, padded, inverse_.data());
  Y_.resize(m, stride);
  kernel_->solve(S_.row(0), padded, inverse_.data(), Y_.row(0), stride, m, width_, packed_.row(0));
  e_.clear();
  for (const MeasurementGroup* g = first; g != last; ++g) {
    e_.insert(e_.end(), g->innovation, g->innovation + (g->accepted ? g->rows : 0));
  }
  double log_likelihood = 0.0;
  x_.resize(1, width_);
  std::fill_n(x_.row(0), width_, 0.0);
  for (long i = 0; i < m; ++i) {
    double& e = e_[static_cast<std::size_t>(i)];
    e *= inverse_[static_cast<std::size_t>(i)];
    const double* u = S_.row(i);
    for (long k = i + 1; k < m; ++k) {
      e_[static_cast<std::size_t>(k)] -= u[k] * e;
    }
    kernel_->subtract(x_.row(0), Y_.row(i), -e, width_);
    log_likelihood -= 0.5 * e * e + std::log(u[i]) + 0.918938533204672742;
  }
  correction += Eigen::Map<const Eigen::VectorXd>(x_.row(0), size_);
  kernel_->downdate(P_.row(0), stride, width_, packed_.row(0), m);
  if (record != nullptr) {
    keep(first, last, *record);
  }
  return log_likelihood;
}

}  // namespace limbwave::estimate
