#include "interchange/half_angles.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "base/units.h"

namespace limbwave::interchange {
namespace {

// So many at once, in loops without branches that compilers turn into vector instructions.
constexpr std::size_t kBlock = 16;
using Block = std::array<double, kBlock>;

// Larger angles are brought near zero first.
constexpr double kLargest = 1e8;
// Adding and taking away 1.5 * 2^52 rounds to a whole number.
constexpr double kRounder = 6755399441055744.0;

inline __attribute__((always_inline)) void kernel(const Block& __restrict degrees, Block& __restrict sines,
                                                  Block& __restrict cosines) {
  for (std::size_t i = 0; i < kBlock; ++i) {
    const double half = 0.5 * degrees[i];
    // Quarters of a turn and what is left, at most half a quarter; exact in degrees.
    const double quarters = (half * (1.0 / 90.0) + kRounder) - kRounder;
    const double x = (half - quarters * 90.0) * (kPi / 180.0);
    // Taylor polynomials up to 45 degrees: the first terms left out are below 1e-17.
    const double z = x * x;
    const double s =
        x +
        x * z *
            (-1.0 / 6 +
             z * (1.0 / 120 +
                  z * (-1.0 / 5040 + z * (1.0 / 362880 + z * (-1.0 / 39916800 + z * (1.0 / 6227020800.0 +
                                                                                     z * (-1.0 / 1307674368000.0)))))));
    const double c =
        1.0 +
        z * (-0.5 + z * (1.0 / 24 +
                         z * (-1.0 / 720 +
                              z * (1.0 / 40320 + z * (-1.0 / 3628800 +
                                                      z * (1.0 / 479001600 + z * (-1.0 / 87178291200.0 +
                                                                                  z * (1.0 / 20922789888000.0))))))));
    // -2 to 2; odd ones swap sine and cosine. Products with 0, 1 and -1 are exact.
    const double turn = quarters - 4.0 * ((0.25 * quarters + kRounder) - kRounder);
    const double off = 0.5 * quarters - ((0.5 * quarters + kRounder) - kRounder);
    const double odd = 4.0 * off * off;
    const double even_sign = (1.0 - odd) * (1.0 - 0.5 * turn * turn);
    const double odd_sign = odd * turn;
    sines[i] = even_sign * s + odd_sign * c;
    cosines[i] = even_sign * c - odd_sign * s;
  }
}

// Wider vectors, the same results: no product and sum are fused.
#if defined(__x86_64__)
__attribute__((target("avx2"))) void wide(const Block& __restrict degrees, Block& __restrict sines,
                                          Block& __restrict cosines) {
  kernel(degrees, sines, cosines);
}
bool has_wide() {
  static const bool kHas = __builtin_cpu_supports("avx2") != 0;
  return kHas;
}
#else
void wide(const Block& __restrict degrees, Block& __restrict sines, Block& __restrict cosines) {
  kernel(degrees, sines, cosines);
}
bool has_wide() {
  return false;
}
#endif
void narrow(const Block& __restrict degrees, Block& __restrict sines, Block& __restrict cosines) {
  kernel(degrees, sines, cosines);
}

}  // namespace

void half_angles(std::span<const double> degrees, std::span<double> sines, std::span<double> cosines) {
  assert(degrees.size() == sines.size() && degrees.size() == cosines.size());
  const bool is_wide = has_wide();
  Block angles{};
  Block s{};
  Block c{};
  for (std::size_t i = 0; i < degrees.size(); i += kBlock) {
    const std::size_t n = std::min(kBlock, degrees.size() - i);
    double largest = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
      angles[k] = degrees[i + k];
      largest = std::max(largest, std::abs(angles[k]));
    }
    if (largest > kLargest) {
      for (double& angle : angles) {
        angle = std::fmod(angle, 720.0);
      }
    }
    is_wide ? wide(angles, s, c) : narrow(angles, s, c);
    std::copy_n(s.begin(), n, sines.begin() + static_cast<std::ptrdiff_t>(i));
    std::copy_n(c.begin(), n, cosines.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

}  // namespace limbwave::interchange
