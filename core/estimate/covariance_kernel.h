/// Inner loops over covariance matrices. All matrices are row-major, 64-byte aligned, with n a multiple of 32 columns
/// (`subtract`: of 8).
#pragma once

namespace limbwave::estimate {

struct CovarianceKernel {
  /// P −= WᵀW, P n × n symmetric (both triangles kept), W m × n.
  void (*downdate)(double* P, long n, const double* W, long m);
  /// y = h P for one row, and Y = H P for three: H[s · rows + r] belongs to row index[s] of P.
  void (*multiply1)(const double* P, long n, const int* index, long count, const double* H, double* Y);
  void (*multiply3)(const double* P, long n, const int* index, long count, const double* H, double* Y);
  /// y −= c x.
  void (*subtract)(double* y, const double* x, double c, long n);
  /// Three rows θ ← A θ + B rate + C second (3 × 3, row-major).
  void (*mix_rows)(double* theta, const double* rate, const double* second, const double* A, const double* B,
                   const double* C, long n);
};

/// The best for this processor. On one processor results are always the same; between processors they agree to
/// rounding.
const CovarianceKernel& covariance_kernel();
/// The one for every processor.
const CovarianceKernel& portable_covariance_kernel();

}  // namespace limbwave::estimate
