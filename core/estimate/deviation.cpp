#include "estimate/deviation.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace limbwave::estimate {
namespace {

constexpr std::array<double, 7> kSixthDifference = {1.0, -6.0, 15.0, -20.0, 15.0, -6.0, 1.0};
constexpr double kSixthDifferenceSquare = 924.0;  // sum of their squares
// Differences need even spacing; a lost cycle starts them anew.
constexpr double kLargestStep = 0.05;
// Over which the mean square is taken to either side, seconds, and the memory of the live form.
constexpr double kNoiseSeconds = 0.5;

// Mean square over the three axes of what seven samples hold of white noise.
template <typename Samples>
double noise_square(const Samples& samples) {
  Vector3d difference = Vector3d::Zero();
  for (std::size_t k = 0; k < kSixthDifference.size(); ++k) {
    difference += kSixthDifference[k] * samples(k);
  }
  return difference.squaredNorm() / (3.0 * kSixthDifferenceSquare);
}

}  // namespace

void NoiseFloor::push(const ForceSample& sample) {
  if (!sample.usable || sample.time_s - last_time_s_ > kLargestStep) {
    filled_ = 0;
  }
  const double dt = sample.time_s - last_time_s_;
  last_time_s_ = sample.time_s;
  if (!sample.usable) {
    return;
  }
  std::shift_left(taps_.begin(), taps_.end(), 1);
  taps_.back() = sample.f_L;
  filled_ = std::min(filled_ + 1, kTaps);
  if (filled_ == kTaps) {
    const double now = noise_square([&](std::size_t k) -> const Vector3d& { return taps_[k]; });
    square_ += (1.0 - std::exp(-dt / kNoiseSeconds)) * (now - square_);
  }
}

double NoiseFloor::noise() const {
  return std::max(kFloor, std::sqrt(square_));
}

std::vector<double> noise_around(std::span<const ForceSample> samples, double otherwise) {
  constexpr std::size_t kMiddle = 3;
  // Prefix sums of the squares, each placed at the middle of its seven samples.
  std::vector<double> sum(samples.size() + 1, 0.0);
  std::vector<int> count(samples.size() + 1, 0);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    double square = 0.0;
    bool whole = i >= kMiddle && i + kMiddle < samples.size();
    for (std::size_t k = 0; k < 7 && whole; ++k) {
      whole = samples[i + k - kMiddle].usable &&
              (k == 0 || samples[i + k - kMiddle].time_s - samples[i + k - kMiddle - 1].time_s <= kLargestStep);
    }
    if (whole) {
      square = noise_square([&](std::size_t k) -> const Vector3d& { return samples[i + k - kMiddle].f_L; });
    }
    sum[i + 1] = sum[i] + square;
    count[i + 1] = count[i] + (whole ? 1 : 0);
  }
  std::vector<double> noise;
  noise.reserve(samples.size());
  std::size_t begin = 0;
  std::size_t end = 0;
  for (const ForceSample& sample : samples) {
    while (sample.time_s - samples[begin].time_s > kNoiseSeconds) {
      ++begin;
    }
    while (end < samples.size() && samples[end].time_s - sample.time_s <= kNoiseSeconds) {
      ++end;
    }
    const int n = count[end] - count[begin];
    noise.push_back(n < 10 ? otherwise
                           : std::max(NoiseFloor::kFloor, std::sqrt(std::max(0.0, sum[end] - sum[begin]) / n)));
  }
  return noise;
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

double acceleration_sd(double deviation, double noise, const InclinationParameters& parameters) {
  const double explained = std::max(parameters.free_deviation, noise);
  return std::sqrt(std::max(0.0, deviation * deviation - explained * explained));
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
