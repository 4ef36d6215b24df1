/// Smooth functions of time that motions are made of: at least three continuous derivatives.
#pragma once

#include <vector>

#include "simulate/jets.h"

namespace limbwave::simulate {

/// Moves from key to key, each at rest with vanishing acceleration and jerk (smooth_step), plus oscillations.
class Curve {
 public:
  /// A value reached at a time; times must not decrease. Before the first and after the last key it is held.
  Curve& key(double time_s, double value);
  /// Adds amplitude · sin(2π f (t − start) + phase), faded in after `start` and out before `end` within `fade_s`.
  Curve& oscillate(double start_s, double end_s, double fade_s, double frequency_hz, double amplitude,
                   double phase = 0.0);

  [[nodiscard]] Jet at(double time_s) const;
  [[nodiscard]] double end() const;  ///< Time after which nothing moves.

 private:
  struct Key {
    double time, value;
  };
  struct Oscillation {
    double start, end, fade, frequency, amplitude, phase;
  };
  std::vector<Key> keys_;
  std::vector<Oscillation> oscillations_;
};

/// Evenly sampled numbers as a curve with four continuous derivatives: a quintic B-spline that passes through the
/// samples after a linear-phase low pass (flat to `pass_hz`, closed from 2 · pass_hz). Optical motion capture needs the
/// low pass: its noise would become accelerations that no limb has.
class SampledCurve {
 public:
  SampledCurve() = default;
  /// At least two samples; pass_hz is lowered to what the rate allows.
  SampledCurve(const std::vector<double>& samples, double rate_hz, double pass_hz);
  /// Also before the first and after the last sample, where the samples go on as their point reflection at the end.
  [[nodiscard]] Jet at(double time_s) const;

 private:
  [[nodiscard]] double coefficient(std::ptrdiff_t index) const;
  double rate_ = 1.0;
  std::vector<double> coefficients_;
};

}  // namespace limbwave::simulate
