#include "estimate/inclination_parts.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "estimate/deviation.h"
#include "geometry/so3.h"

namespace limbwave::estimate {

double usable_trust(const ForceSample& sample, const InclinationParameters& parameters) {
  return sample.usable ? trust_of(sample.f_L, parameters) : 0.0;
}

Inclination raw_inclination(const ForceSample& sample, const Inclination& last, double deviation, double noise,
                            const InclinationParameters& parameters) {
  Inclination inclination = last;
  inclination.time_s = sample.time_s;
  inclination.trust = usable_trust(sample, parameters);
  if (sample.usable && sample.f_L.norm() > 1e-3) {
    inclination.up_L = sample.f_L.normalized();
    inclination.sd_rad = (acceleration_sd(deviation, noise, parameters) +
                          std::hypot(std::min(deviation, parameters.free_deviation), noise)) /
                         kStandardGravity;
    inclination.known = true;
  }
  return inclination;
}

Inclination inclination_of(const InclinationFilter::State& state, const ForceSample& sample, double deviation,
                           const InclinationParameters& parameters) {
  Inclination inclination;
  inclination.time_s = sample.time_s;
  inclination.up_L = InclinationFilter::up_L(state).normalized();
  inclination.trust = usable_trust(sample, parameters);
  inclination.known = true;
  // What the free deviation let pass may also lie across gravity.
  const double let_pass = std::min(deviation, parameters.free_deviation) / kStandardGravity;
  inclination.sd_rad = std::hypot(InclinationFilter::direction_sd(state), let_pass);
  return inclination;
}

Inclination mixed(std::span<const Inclination> each, const Logs& weights) {
  Inclination mean = each.front();
  Vector3d direction = Vector3d::Zero();
  for (std::size_t k = 0; k < each.size(); ++k) {
    direction += weights[k] * each[k].up_L;
  }
  if (!mean.known || !(direction.norm() > 1e-6)) {
    return mean;
  }
  mean.up_L = direction.normalized();
  double variance = 0.0;
  for (std::size_t k = 0; k < each.size(); ++k) {
    const double away = geometry::angle_between(each[k].up_L, mean.up_L);
    variance += weights[k] * (each[k].sd_rad * each[k].sd_rad + 0.5 * away * away);
  }
  mean.sd_rad = std::sqrt(variance);
  return mean;
}

}  // namespace limbwave::estimate
