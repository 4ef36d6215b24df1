/// Inner loops over covariance matrices. All matrices are row-major, 64-byte aligned, rows a multiple of 8 doubles
/// apart. Widths are multiples of 32, unless said otherwise.
#pragma once

namespace limbwave::estimate {

struct CovarianceKernel {
  /// P −= WᵀW, P n × n symmetric (both triangles kept), W m × n packed as by `solve`.
  void (*downdate)(double* P, long stride, long n, const double* W, long m);
  /// y = h P for one row, and Y = H P for three: H[s · rows + r] belongs to row index[s] of P.
  void (*multiply1)(const double* P, long stride, long width, const int* index, long count, const double* H, double* Y,
                    long y_stride);
  void (*multiply3)(const double* P, long stride, long width, const int* index, long count, const double* H, double* Y,
                    long y_stride);
  /// y −= c x; n a multiple of 8.
  void (*subtract)(double* y, const double* x, double c, long n);
  /// y = a y + b x; n a multiple of 8.
  void (*blend)(double* y, const double* x, double a, double b, long n);
  /// Three rows θ ← A θ + B rate + C second (3 × 3, row-major); n a multiple of 8.
  void (*mix_rows)(double* theta, const double* rate, const double* second, const double* A, const double* B,
                   const double* C, long stride, long n);
  /// to = fromᵀ; rows a multiple of 4, columns of 8.
  void (*transpose)(const double* from, long rows, long columns, long stride, double* to, long to_stride);
  /// P = Pᵀ in place, n × n, n a multiple of 8.
  void (*transpose_square)(double* P, long stride, long n);
  /// The upper triangle of n × n, copied to the lower; n a multiple of 8.
  void (*mirror)(double* P, long stride, long n);
  /// S = UᵀU (Cholesky) in place, from and to the upper triangle of m rows; the rest of the rows is overwritten.
  /// `inverse`: 1 / U(i, i). A pivot that is not positive is taken as tiny.
  void (*factor)(double* S, long m, long stride, double* inverse);
  /// Y = U⁻ᵀ Y, m × n; also to `packed`, m · n doubles: eight columns after the other, all rows of each.
  void (*solve)(const double* U, long u_stride, const double* inverse, double* Y, long y_stride, long m, long n,
                double* packed);
  /// C = A B; A rows × inner, B inner × width, C rows × width, their rows without gaps.
  void (*product)(const double* A, long stride, long rows, long inner, const double* B, double* C, long width);
  /// Y = U⁻¹ Y, m × width, its rows without gaps.
  void (*solve_upper)(const double* U, long u_stride, const double* inverse, double* Y, long m, long width);
  /// X −= Hᵀ Y: rows index[s] of X lose H[s · rows + r] times row r of Y; rows of both without gaps.
  void (*take_off)(double* X, const int* index, long count, const double* H, long rows, const double* Y, long width);
};

/// The best for this processor. On one processor results are always the same; between processors they agree to
/// rounding.
const CovarianceKernel& covariance_kernel();
/// The one for every processor.
const CovarianceKernel& portable_covariance_kernel();

}  // namespace limbwave::estimate
