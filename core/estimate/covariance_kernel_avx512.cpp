// Compiled for AVX-512 with fused operations.
#include "estimate/covariance_kernel.h"

namespace limbwave::estimate {
namespace {
#define LIMBWAVE_LANES 8
#include "estimate/covariance_kernel.inc"
}  // namespace

const CovarianceKernel& avx512_covariance_kernel();
const CovarianceKernel& avx512_covariance_kernel() {
  return kKernel;
}

}  // namespace limbwave::estimate
