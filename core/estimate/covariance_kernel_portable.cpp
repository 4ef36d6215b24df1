#include "estimate/covariance_kernel.h"

namespace limbwave::estimate {
namespace {
#define LIMBWAVE_LANES 4
#include "estimate/covariance_kernel.inc"
}  // namespace

const CovarianceKernel& portable_covariance_kernel() {
  return kKernel;
}

#ifdef LIMBWAVE_AVX2_KERNEL
const CovarianceKernel& avx2_covariance_kernel();
const CovarianceKernel& avx512_covariance_kernel();
#endif

const CovarianceKernel& covariance_kernel() {
#ifdef LIMBWAVE_AVX2_KERNEL
  static const bool avx512 = __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
                             __builtin_cpu_supports("avx512vl") != 0;
  if (avx512) {
    return avx512_covariance_kernel();
  }
  static const bool avx2 = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
  if (avx2) {
    return avx2_covariance_kernel();
  }
#endif
  return portable_covariance_kernel();
}

}  // namespace limbwave::estimate
