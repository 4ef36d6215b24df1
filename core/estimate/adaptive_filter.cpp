#include "estimate/adaptive_filter.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace limbwave::estimate {
namespace {

// Direction noise at which the memory is half of smoothing_s: about one degree.
constexpr double kHalfMemoryNoise = 0.02;
// The best reading counts as no better than this, radians: the limb turns meanwhile.
constexpr double kLeastDirectionSd = 0.05;
// However long a burst lasts, what was before it is worth less and less.
constexpr double kLongestMemory = 0.25;

}  // namespace

AdaptiveFilter::Sum AdaptiveFilter::alone(const ForceSample& sample, double acceleration_sd, double noise) {
  const double norm = sample.f_L.norm();
  if (!sample.usable || !(norm > 1e-3) || !std::isfinite(norm)) {
    return {};
  }
  const double variance = (acceleration_sd * acceleration_sd + noise * noise) / (kStandardGravity * kStandardGravity) +
                          kLeastDirectionSd * kLeastDirectionSd;
  return {sample.f_L / (norm * variance), 1.0 / variance};
}

const AdaptiveFilter::Sum& AdaptiveFilter::step(const ForceSample& sample, double dt, double acceleration_sd,
                                                double noise) {
  // Memory comes from noise and from mistrust; with neither it is nil and the reading goes through as it is.
  const double noise_angle = noise / kStandardGravity;
  const double memory_of_noise = parameters_.smoothing_s * noise_angle / (noise_angle + kHalfMemoryNoise);
  const double mistrust = acceleration_sd / parameters_.half_trust_deviation;
  double memory = std::min(kLongestMemory, memory_of_noise + parameters_.smoothing_s * mistrust * mistrust);
  const Sum own = alone(sample, acceleration_sd, noise);
  if (own.weight <= 0.0) {
    memory = kLongestMemory;
  }
  const double kept = memory > 0.0 ? std::exp(-dt / memory) : 0.0;
  sum_.direction = kept * sum_.direction + own.direction;
  sum_.weight = kept * sum_.weight + own.weight;
  return sum_;
}

}  // namespace limbwave::estimate
