// Compiled for AVX2 with fused operations.
#include "estimate/covariance_kernel.h"

namespace limbwave::estimate {
namespace {
#define LIMBWAVE_LANES 4
#include "estimate/covariance_kernel.inc"
}  // namespace

const CovarianceKernel& avx2_covariance_kernel();
const CovarianceKernel& avx2_covariance_kernel() {
  return kKernel;
}

}  // namespace limbwave::estimate
