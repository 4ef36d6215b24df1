/// Design of finite impulse responses, and the sum of products that runs them.
#pragma once

#include <cstddef>
#include <vector>

namespace limbwave::signal {

/// Kaiser-windowed low pass of `taps` coefficients with its −6 dB point at `cutoff` (fraction of the sample rate), gain
/// 1 at zero frequency. Linear phase: delay (taps − 1) / 2. Stop-band attenuation is `attenuation_db` where the length
/// allows (Kaiser 1974).
std::vector<double> low_pass(std::size_t taps, double cutoff, double attenuation_db);

/// Taps that such a low pass needs for a transition of `width` (fraction of the sample rate).
std::size_t kaiser_taps(double width, double attenuation_db);

/// The same moved to `center` (fraction of the sample rate) as a real band pass with gain 1 there.
std::vector<double> band_pass(std::size_t taps, double center, double half_width, double attenuation_db);

/// Lengths of filters are rounded up to a multiple of this, with zeros.
inline constexpr std::size_t kDotMultiple = 8;

/// Sum of a[i] · b[i]; `count` is a multiple of kDotMultiple. The order of additions is fixed.
float dot(const float* a, const float* b, std::size_t count);

/// Real and imaginary sum at once: x against two sets of taps.
struct DotPair {
  float first = 0.0F, second = 0.0F;
};
DotPair dot_pair(const float* x, const float* taps_first, const float* taps_second, std::size_t count);

}  // namespace limbwave::signal
