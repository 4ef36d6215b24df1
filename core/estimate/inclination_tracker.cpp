#include "estimate/inclination_tracker.h"

#include <cmath>
#include <vector>

#include "base/units.h"
#include "estimate/adaptive_filter.h"
#include "estimate/deviation.h"
#include "estimate/inclination_filter.h"
#include "estimate/inclination_parts.h"
#include "estimate/lever_bank.h"

namespace limbwave::estimate {

struct InclinationTracker::Impl {
  Impl(Smoothing smoothing_, const InclinationParameters& parameters_)
      : smoothing(smoothing_),
        parameters(parameters_),
        noise(parameters_.sensor_noise),
        recent(parameters_.burst_s),
        adaptive_filter(parameters_) {
    for (const double lever : kLevers) {
      bridging_filters.emplace_back(parameters_, lever);
    }
  }

  Smoothing smoothing;
  InclinationParameters parameters;
  NoiseFloor noise;
  RecentSamples recent;
  AdaptiveFilter adaptive_filter;
  std::vector<InclinationFilter> bridging_filters;
  Logs evidence{};
  Inclination last;
  bool any = false;
};

InclinationTracker::InclinationTracker(Smoothing smoothing, const InclinationParameters& parameters)
    : impl_(std::make_unique<Impl>(smoothing, parameters)) {}
InclinationTracker::~InclinationTracker() = default;
InclinationTracker::InclinationTracker(const InclinationTracker& other) : impl_(std::make_unique<Impl>(*other.impl_)) {}
InclinationTracker& InclinationTracker::operator=(const InclinationTracker& other) {
  *impl_ = *other.impl_;
  return *this;
}
InclinationTracker::InclinationTracker(InclinationTracker&&) noexcept = default;
InclinationTracker& InclinationTracker::operator=(InclinationTracker&&) noexcept = default;

Inclination InclinationTracker::push(const ForceSample& given) {
  Impl& my = *impl_;
  if (!std::isfinite(given.time_s) || (my.any && given.time_s <= my.last.time_s)) {
    return my.last;
  }
  ForceSample sample = given;
  sample.usable = given.usable && given.f_L.allFinite();
  const double dt = my.any ? sample.time_s - my.last.time_s : 0.0;
  my.any = true;
  my.noise.push(sample);
  my.recent.push(sample);
  const double deviation = my.recent.deviation();
  const double noise = my.noise.noise();
  const double acceleration = acceleration_sd(deviation, noise, my.parameters);
  switch (my.smoothing) {
    case Smoothing::kNone:
      my.last = raw_inclination(sample, my.last, deviation, noise, my.parameters);
      break;
    case Smoothing::kAdaptive:
    case Smoothing::kChain: {
      const AdaptiveFilter::Sum& sum = my.adaptive_filter.step(sample, dt, acceleration, noise);
      my.last.time_s = sample.time_s;
      my.last.trust = usable_trust(sample, my.parameters);
      if (sum.weight > 0.0 && sum.direction.norm() > 0.0) {
        my.last.up_L = sum.direction.normalized();
        my.last.sd_rad = std::hypot(std::sqrt(1.0 / sum.weight), acceleration / kStandardGravity * 0.7);
        my.last.known = true;
      }
      break;
    }
    case Smoothing::kBridging: {
      std::vector<Inclination> each;
      Logs logs{};
      const AccelerationStep step = acceleration_step(dt);
      for (std::size_t k = 0; k < my.bridging_filters.size(); ++k) {
        InclinationFilter& filter = my.bridging_filters[k];
        filter.step(sample, step, acceleration, noise);
        logs[k] = filter.log_likelihood();
        if (filter.started()) {
          each.push_back(inclination_of(filter.record().updated, sample, deviation, my.parameters));
        }
      }
      add_faded(my.evidence, logs, dt);
      my.last.time_s = sample.time_s;
      if (!each.empty()) {
        my.last = mixed(each, weights_of(my.evidence));
      }
      break;
    }
  }
  return my.last;
}

}  // namespace limbwave::estimate
