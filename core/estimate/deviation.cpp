#include "estimate/deviation.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace limbwave::estimate {
namespace {

constexpr std::array<double, 7> kSixthDifference = {1.0, -6.0, 15.0, -20.0, 15.0, -6.0, 1.0};
constexpr double kSixthDifferenceGain = 30.397368307141327;  // √924, the root of the sum of squares
constexpr double kMedianOfNormal = 0.6744897501960817;
// Differences need even spacing; a lost cycle starts them anew.
constexpr double kLargestStep = 0.05;

}  // namespace

void NoiseFloor::push(const ForceSample& sample) {
  if (!sample.usable || sample.time_s - last_time_s_ > kLargestStep) {
    filled_ = 0;
  }
  last_time_s_ = sample.time_s;
  if (!sample.usable) {
    return;
  }
  std::shift_left(taps_.begin(), taps_.end(), 1);
  taps_.back() = sample.f_L;
  filled_ = std::min(filled_ + 1, kTaps);
  if (filled_ < kTaps) {
    return;
  }
  Vector3d difference = Vector3d::Zero();
  for (std::size_t i = 0; i < kTaps; ++i) {
    difference += kSixthDifference[i] * taps_[i];
  }
  // A running median: up by a small factor when the size is above it, down when below. 1 % a step and axis follows a
  // change by a factor of e in half a second, and a burst of 0.3 s moves it by less than 2.
  for (int axis = 0; axis < 3; ++axis) {
    const double size = std::abs(difference[axis]) / (kSixthDifferenceGain * kMedianOfNormal);
    noise_ *= size > noise_ ? 1.01 : 1.0 / 1.01;
  }
  noise_ = std::max(noise_, kFloor);
}

double noise_floor_of(std::span<const ForceSample> samples, double otherwise) {
  std::vector<double> sizes;
  for (std::size_t i = 6; i < samples.size(); ++i) {
    Vector3d difference = Vector3d::Zero();
    bool whole = true;
    for (std::size_t k = 0; k < 7 && whole; ++k) {
      const ForceSample& sample = samples[i - 6 + k];
      whole = sample.usable && (k == 0 || sample.time_s - samples[i - 7 + k].time_s <= kLargestStep);
      difference += kSixthDifference[k] * sample.f_L;
    }
    if (whole) {
      for (int axis = 0; axis < 3; ++axis) {
        sizes.push_back(std::abs(difference[axis]));
      }
    }
  }
  if (sizes.size() < 60) {
    return otherwise;
  }
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return std::max(NoiseFloor::kFloor, *middle / (kSixthDifferenceGain * kMedianOfNormal));
}

double deviation_around(std::span<const ForceSample> samples, std::size_t index, double burst_s, double ahead_s) {
  const double middle = samples[index].time_s;
  double square = 0.0;
  int count = 0;
  const auto add = [&](const ForceSample& sample) {
    if (sample.usable) {
      square += std::pow(sample.f_L.norm() - kStandardGravity, 2);
      ++count;
    }
  };
  for (std::size_t i = index + 1; i-- > 0 && middle - samples[i].time_s <= burst_s;) {
    add(samples[i]);
  }
  for (std::size_t i = index + 1; i < samples.size() && samples[i].time_s - middle <= ahead_s; ++i) {
    add(samples[i]);
  }
  const double around = count > 0 ? std::sqrt(square / count) : 0.0;
  const double own = samples[index].usable ? std::abs(samples[index].f_L.norm() - kStandardGravity) : 0.0;
  return std::max(around, own);
}

double acceleration_sd(double deviation, const InclinationParameters& parameters) {
  const double free = parameters.free_deviation;
  return parameters.across_ratio * std::sqrt(std::max(0.0, deviation * deviation - free * free));
}

void RecentSamples::push(const ForceSample& sample) {
  samples_.push_back(sample);
  const auto fresh = std::find_if(samples_.begin(), samples_.end(),
                                  [&](const ForceSample& old) { return sample.time_s - old.time_s <= seconds_; });
  samples_.erase(samples_.begin(), fresh);
}

double RecentSamples::deviation() const {
  return samples_.empty() ? 0.0 : deviation_around(samples_, samples_.size() - 1, seconds_, 0.0);
}

}  // namespace limbwave::estimate
