/// Covariance of an error state and its exact Kalman update for sparse measurement rows, taken in chunks.
///
/// P stays symmetric by construction: P⁺ = P − WᵀW with W = U⁻ᵀ H P and S = H P Hᵀ + R = UᵀU, so that there is no
/// gain whose rounding could make it asymmetric; the sum that is subtracted never exceeds P by more than rounding.
///
/// P does not fit the caches next to a core, so it is passed over as rarely as can be: once for H P, once for P⁺.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "estimate/covariance_kernel.h"

namespace limbwave::estimate {

/// Doubles aligned for the kernels.
class AlignedRows {
 public:
  /// Keeps its memory when it shrinks. Content is undefined.
  void resize(long rows, long columns);
  /// So many columns at least that rows do not get into each other's way in the caches: an odd number of lines.
  [[nodiscard]] static long spread(long columns) { return ((columns + 7) / 8 | 1) * 8; }
  [[nodiscard]] double* row(long i) { return data_ + i * columns_; }
  [[nodiscard]] const double* row(long i) const { return data_ + i * columns_; }
  [[nodiscard]] long rows() const { return rows_; }
  [[nodiscard]] long columns() const { return columns_; }

  AlignedRows() = default;
  AlignedRows(const AlignedRows& other) { *this = other; }
  AlignedRows& operator=(const AlignedRows& other);
  AlignedRows(AlignedRows&& other) noexcept { *this = std::move(other); }
  AlignedRows& operator=(AlignedRows&& other) noexcept;
  ~AlignedRows() = default;

 private:
  std::vector<double> memory_;
  double* data_ = nullptr;
  long rows_ = 0, columns_ = 0;
};

/// One to three scalar measurements that are accepted or rejected together: ν = z − h(x̂), Jacobian rows on `support`.
struct MeasurementGroup {
  int rows = 0;
  std::vector<int> support;  ///< Indices of error states.
  std::vector<double> H;     ///< H[s * rows + r].
  double innovation[3] = {0, 0, 0};
  double variance[3] = {0, 0, 0};
  double gate = 0.0;  ///< Largest normalised innovation squared νᵀ S⁻¹ ν; 0: no gate.
  /// Beyond the gate the group is not rejected but counts less (Huber): one that never errs grossly shall not be locked
  /// out by a filter that is too sure of itself.
  bool softened = false;
  int tag = 0;  ///< The caller's.
  // Results:
  double nis = 0.0;
  double inflation = 1.0;  ///< Of the innovation's covariance, where the group counts less.
  bool accepted = false;
};

/// What an update did, for the smoother: with S = H P Hᵀ + R = UᵀU, W = U⁻ᵀ H P and e = U⁻ᵀ ν.
struct UpdateRecord {
  struct Rows {
    int rows, support;  ///< How many there are.
  };
  std::vector<Rows> groups;  ///< Accepted ones, with H as in MeasurementGroup, one behind the other.
  std::vector<int> support;
  std::vector<double> H;
  AlignedRows U;                ///< m × m, padded; its upper triangle.
  std::vector<double> inverse;  ///< 1 / U(i, i).
  AlignedRows W;                ///< m × n.
  std::vector<double> e;
};

class ErrorCovariance {
 public:
  explicit ErrorCovariance(int size);

  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] long stride() const { return P_.columns(); }
  [[nodiscard]] long width() const { return width_; }  ///< Of a row: size() and what fills it up to a multiple of 32.
  [[nodiscard]] double* row(int i) { return P_.row(i); }
  [[nodiscard]] const double* row(int i) const { return P_.row(i); }
  [[nodiscard]] double operator()(int i, int j) const { return P_.row(i)[j]; }
  [[nodiscard]] const CovarianceKernel& kernel() const { return *kernel_; }
  void use(const CovarianceKernel& kernel) { kernel_ = &kernel; }

  /// Sets a variance and clears the correlations of that state.
  void set_variance(int i, double variance);
  void add_variance(int i, double variance) { P_.row(i)[i] += variance; }
  [[nodiscard]] Eigen::MatrixXd dense() const;
  void set_dense(const Eigen::MatrixXd& P);

  /// Updates by all accepted groups of [first, last) at once and adds the correction to `correction` (size()). Gates
  /// every group by its own innovation. Returns the log likelihood of the accepted innovations.
  double update(MeasurementGroup* first, MeasurementGroup* last, Eigen::VectorXd& correction,
                UpdateRecord* record = nullptr);

 private:
  long accept(MeasurementGroup* first, MeasurementGroup* last);
  void innovation_covariance(const MeasurementGroup* first, const MeasurementGroup* last, long m);
  void keep(const MeasurementGroup* first, const MeasurementGroup* last, UpdateRecord& record);

  int size_;
  long width_;  // of P, a multiple of what the kernels take at once
  AlignedRows P_, Y_, Y_transposed_, S_, packed_, x_;
  std::vector<double> inverse_, e_;
  const CovarianceKernel* kernel_;
};

}  // namespace limbwave::estimate
