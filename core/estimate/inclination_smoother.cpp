#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "estimate/adaptive_filter.h"
#include "estimate/deviation.h"
#include "estimate/inclination.h"
#include "estimate/inclination_filter.h"
#include "estimate/inclination_tracker.h"

namespace limbwave::estimate {
namespace {

// The backward pass keeps this many steps at a time, and as many seconds ahead of what it gives out as its memory
// reaches; a whole hour would take gigabytes.
constexpr std::size_t kChunk = 4096;
constexpr std::size_t kAhead = 600;

double usable_trust(const ForceSample& sample, const InclinationParameters& parameters) {
  return sample.usable ? trust_of(sample.f_L, parameters) : 0.0;
}

// What is known of the limb's acceleration at every sample, looking to both sides.
struct Surroundings {
  std::vector<double> acceleration_sd;
  std::vector<double> deviation;
  double noise = 0.0;
};

Surroundings surroundings_of(std::span<const ForceSample> samples, const InclinationParameters& parameters) {
  Surroundings surroundings;
  surroundings.noise = noise_floor_of(samples, parameters.sensor_noise);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double deviation = deviation_around(samples, i, parameters.burst_s, parameters.burst_s);
    surroundings.deviation.push_back(deviation);
    surroundings.acceleration_sd.push_back(acceleration_sd(deviation, parameters));
  }
  return surroundings;
}

std::vector<Inclination> adaptive(std::span<const ForceSample> samples, const InclinationParameters& parameters) {
  const Surroundings around = surroundings_of(samples, parameters);
  std::vector<Inclination> result(samples.size());
  std::vector<AdaptiveFilter::Sum> forward;
  AdaptiveFilter filter(parameters);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double dt = i == 0 ? 0.0 : samples[i].time_s - samples[i - 1].time_s;
    forward.push_back(filter.step(samples[i], dt, around.acceleration_sd[i], around.noise));
  }
  AdaptiveFilter backward(parameters);
  for (std::size_t i = samples.size(); i-- > 0;) {
    const double dt = i + 1 == samples.size() ? 0.0 : samples[i + 1].time_s - samples[i].time_s;
    const AdaptiveFilter::Sum& later = backward.step(samples[i], dt, around.acceleration_sd[i], around.noise);
    const AdaptiveFilter::Sum own = AdaptiveFilter::alone(samples[i], around.acceleration_sd[i], around.noise);
    const Vector3d direction = forward[i].direction + later.direction - own.direction;
    const double weight = forward[i].weight + later.weight - own.weight;
    result[i].time_s = samples[i].time_s;
    result[i].trust = usable_trust(samples[i], parameters);
    result[i].known = weight > 0.0 && direction.norm() > 0.0;
    if (result[i].known) {
      result[i].up_L = direction.normalized();
      // Neighbouring accelerations agree with each other, so averaging them gains little.
      result[i].sd_rad = std::hypot(std::sqrt(1.0 / weight), around.acceleration_sd[i] / kStandardGravity * 0.7);
    }
  }
  return result;
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

std::vector<Inclination> bridging(std::span<const ForceSample> samples, const InclinationParameters& parameters) {
  const Surroundings around = surroundings_of(samples, parameters);
  std::vector<Inclination> result(samples.size());
  InclinationFilter filter(parameters);
  std::vector<InclinationFilter::Record> records;
  std::size_t first = 0;  // sample of records[0]
  const auto give_out = [&](std::size_t count) {
    const std::vector<InclinationFilter::State> states = InclinationFilter::smooth(records);
    for (std::size_t k = 0; k < count; ++k) {
      result[first + k] = inclination_of(states[k], samples[first + k], around.deviation[first + k], parameters);
    }
    records.erase(records.begin(), records.begin() + static_cast<std::ptrdiff_t>(count));
    first += count;
  };
  for (std::size_t i = 0; i < samples.size(); ++i) {
    filter.step(samples[i], around.acceleration_sd[i], around.noise);
    if (!filter.started()) {
      result[i].time_s = samples[i].time_s;
      first = i + 1;
      continue;
    }
    records.push_back(filter.record());
    if (records.size() >= kChunk + kAhead) {
      give_out(kChunk);
    }
  }
  give_out(records.size());
  return result;
}

Inclination raw_inclination(const ForceSample& sample, const Inclination& last, double deviation, double noise,
                            const InclinationParameters& parameters) {
  Inclination inclination = last;
  inclination.time_s = sample.time_s;
  inclination.trust = usable_trust(sample, parameters);
  if (sample.usable && sample.f_L.norm() > 1e-3) {
    inclination.up_L = sample.f_L.normalized();
    inclination.sd_rad =
        (acceleration_sd(deviation, parameters) + std::hypot(std::min(deviation, parameters.free_deviation), noise)) /
        kStandardGravity;
    inclination.known = true;
  }
  return inclination;
}

}  // namespace

std::vector<Inclination> estimate_inclinations(std::span<const ForceSample> samples, Smoothing smoothing,
                                               const InclinationParameters& parameters) {
  // Only samples that go on in time are estimated; the others repeat what was there.
  std::vector<ForceSample> ordered;
  std::vector<std::size_t> place;
  for (const ForceSample& sample : samples) {
    if (std::isfinite(sample.time_s) && (ordered.empty() || sample.time_s > ordered.back().time_s)) {
      ordered.push_back(sample);
      ordered.back().usable = sample.usable && sample.f_L.allFinite();
    }
    place.push_back(ordered.empty() ? 0 : ordered.size() - 1);
  }
  std::vector<Inclination> result;
  if (ordered.empty()) {
    result.resize(samples.size());
    return result;
  }
  switch (smoothing) {
    case Smoothing::kNone: {
      const Surroundings around = surroundings_of(ordered, parameters);
      for (std::size_t i = 0; i < ordered.size(); ++i) {
        result.push_back(raw_inclination(ordered[i], result.empty() ? Inclination{} : result.back(),
                                         around.deviation[i], around.noise, parameters));
      }
      break;
    }
    case Smoothing::kAdaptive:
      result = adaptive(ordered, parameters);
      break;
    case Smoothing::kBridging:
      result = bridging(ordered, parameters);
      break;
  }
  if (ordered.size() == samples.size()) {
    return result;
  }
  std::vector<Inclination> all;
  all.reserve(samples.size());
  for (const std::size_t index : place) {
    all.push_back(result[index]);
  }
  return all;
}

struct InclinationTracker::Impl {
  Impl(Smoothing smoothing_, const InclinationParameters& parameters_)
      : smoothing(smoothing_),
        parameters(parameters_),
        noise(parameters_.sensor_noise),
        recent(parameters_.burst_s),
        adaptive_filter(parameters_),
        bridging_filter(parameters_) {}

  Smoothing smoothing;
  InclinationParameters parameters;
  NoiseFloor noise;
  RecentSamples recent;
  AdaptiveFilter adaptive_filter;
  InclinationFilter bridging_filter;
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
  const double acceleration = acceleration_sd(deviation, my.parameters);
  const double noise = my.noise.noise();
  switch (my.smoothing) {
    case Smoothing::kNone:
      my.last = raw_inclination(sample, my.last, deviation, noise, my.parameters);
      break;
    case Smoothing::kAdaptive: {
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
    case Smoothing::kBridging:
      my.bridging_filter.step(sample, acceleration, noise);
      my.last.time_s = sample.time_s;
      if (my.bridging_filter.started()) {
        my.last = inclination_of(my.bridging_filter.record().updated, sample, deviation, my.parameters);
      }
      break;
  }
  return my.last;
}

}  // namespace limbwave::estimate
