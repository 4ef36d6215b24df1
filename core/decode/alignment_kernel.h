/// Weights that take one axis from its own instants to the common one of a cycle.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace limbwave::decode {

/// Minimum-variance interpolation of a band-limited signal in white noise, from seven cycles before to two after. The
/// signal's assumed spectrum is flat to kPassband (power kPassPower times the noise's), weaker to kEdge, and weak but
/// well above the noise up to half the cycle rate; frequencies are per cycle. The last part is there although nothing
/// in it is of use: what a sensor feels beyond half the cycle rate (vibration, knocks) is folded down over all
/// frequencies, and the estimator tells how far to trust the readings by what it sees of that above the motion. An
/// interpolation that took it out up there would hide the rest of it, which lies within the motion. At 60 cycles a
/// second: errors below 2e-5 of the amplitude to 5 Hz and 2 % at 10 Hz, 0.65 to 0.95 of it at 20 Hz, and noise of
/// variance 0.85 (a polynomial through six points: 0.93).
class AlignmentKernel {
 public:
  static constexpr std::size_t kBefore = 7;
  static constexpr std::size_t kAfter = 2;
  static constexpr std::size_t kTaps = kBefore + 1 + kAfter;
  using Values = std::array<double, kTaps>;

  AlignmentKernel();
  /// The value at instant 0 of a signal with `values` at `instants` (in cycles, increasing by about 1, the one of tap
  /// kBefore within ±0.5 of 0). Instants need not be even: small deviations are corrected to first order.
  [[nodiscard]] double at_zero(const Values& instants, const Values& values) const;

 private:
  static constexpr double kPassband = 5.5 / 60.0;
  static constexpr double kPassPower = 1e8;
  static constexpr double kEdge = 9.0 / 60.0;
  static constexpr double kEdgePower = 1e4;
  static constexpr double kRestPower = 10.0;
  static constexpr int kSteps = 1024;  // of the offset, per cycle

  std::vector<Values> weights_;  // by offset of tap kBefore from -0.5 to 0.5
};

}  // namespace limbwave::decode
