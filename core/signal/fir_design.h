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

/// A linear-phase filter over a long signal: taps that are equal are added before they are multiplied, and several
/// outputs are made at once, each on a lane of its own.
class SymmetricFir {
 public:
  /// An odd number of taps, symmetric to rounding; asserts both.
  explicit SymmetricFir(const std::vector<float>& taps);
  [[nodiscard]] std::size_t taps() const { return 2 * half_.size() - 1; }
  /// out[i] = sum of taps[k] · x[i + k]; x has count + taps() − 1 samples.
  void run(const float* x, std::size_t count, float* out) const;

 private:
  std::vector<float> half_;  // half_[0] is the middle one
};

}  // namespace limbwave::signal
