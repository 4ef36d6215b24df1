/// What a series of readings says about itself: its noise floor, and how strongly the limb accelerates.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "estimate/inclination.h"

namespace limbwave::estimate {

/// Tracks how rough a series is, m/s² RMS per axis, by its sixth differences: motion of limbs is far too smooth at
/// 60 Hz to leave anything in them (5 Hz is damped by 50), white noise is multiplied by √924. What is left is sensor
/// noise, and vibration and knocks too fast to be followed.
class NoiseFloor {
 public:
  explicit NoiseFloor(double initial) : square_(initial * initial) {}
  void push(const ForceSample& sample);
  [[nodiscard]] double noise() const;

  /// Least noise that is ever reported, m/s²: 1e-5 g, the resolution of 16 bits.
  static constexpr double kFloor = 1e-4;

 private:
  static constexpr std::size_t kTaps = 7;
  std::array<Vector3d, kTaps> taps_{};
  std::size_t filled_ = 0;
  double last_time_s_ = 0.0;
  double square_;
};

/// The noise around every sample of a whole series, m/s² per axis: the root of the mean square over half a second to
/// either side; `otherwise` where gaps leave too little to tell.
std::vector<double> noise_around(std::span<const ForceSample> samples, double otherwise);

/// RMS of | |f| − g | over the neighbourhood of sample `index`, burst_s back and `ahead_s` forward, m/s²; at least the
/// sample's own. Unusable samples do not count; 0 when none is usable.
double deviation_around(std::span<const ForceSample> samples, std::size_t index, double burst_s, double ahead_s);

/// Standard deviation of limb acceleration per axis that a deviation stands for beyond what `noise` explains, m/s²;
/// 0 up to free_deviation. Its direction is unknown, so it is taken to be as strong across gravity as along.
double acceleration_sd(double deviation, double noise, const InclinationParameters& parameters);

/// The last burst_s of a live series, for `deviation_around` without looking ahead.
class RecentSamples {
 public:
  explicit RecentSamples(double seconds) : seconds_(seconds) {}
  void push(const ForceSample& sample);
  [[nodiscard]] double deviation() const;

 private:
  double seconds_;
  std::vector<ForceSample> samples_;
};

}  // namespace limbwave::estimate
