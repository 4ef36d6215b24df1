/// What a series of readings says about itself: its noise floor, and how strongly the limb accelerates.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "estimate/inclination.h"

namespace limbwave::estimate {

/// Tracks the sensor noise, m/s² RMS per axis, by the median of sixth differences: motion of limbs is far too smooth
/// at 60 Hz to leave anything in them (5 Hz is damped by 50), noise is multiplied by √924.
class NoiseFloor {
 public:
  explicit NoiseFloor(double initial) : noise_(initial) {}
  void push(const ForceSample& sample);
  [[nodiscard]] double noise() const { return noise_; }

  /// Least noise that is ever reported, m/s²: 1e-5 g, the resolution of 16 bits.
  static constexpr double kFloor = 1e-4;

 private:
  static constexpr std::size_t kTaps = 7;
  std::array<Vector3d, kTaps> taps_{};
  std::size_t filled_ = 0;
  double last_time_s_ = 0.0;
  double noise_;
};

/// The noise floor of a whole series, m/s² per axis; `otherwise` when it is too short to tell.
double noise_floor_of(std::span<const ForceSample> samples, double otherwise);

/// RMS of | |f| − g | over the neighbourhood of sample `index`, burst_s back and `ahead_s` forward, m/s²; at least the
/// sample's own. Unusable samples do not count; 0 when none is usable.
double deviation_around(std::span<const ForceSample> samples, std::size_t index, double burst_s, double ahead_s);

/// Standard deviation of limb acceleration per axis that a deviation stands for, m/s²; 0 up to free_deviation.
double acceleration_sd(double deviation, const InclinationParameters& parameters);

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
