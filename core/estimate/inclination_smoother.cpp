#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/units.h"
#include "estimate/adaptive_filter.h"
#include "estimate/deviation.h"
#include "estimate/inclination.h"
#include "estimate/inclination_filter.h"
#include "estimate/inclination_parts.h"
#include "estimate/lever_bank.h"

namespace limbwave::estimate {
namespace {

// The backward pass keeps this many steps at a time, and as many seconds ahead of what it gives out as its memory
// reaches; a whole hour would take gigabytes.
constexpr std::size_t kChunk = 4096;
constexpr std::size_t kAhead = 600;
constexpr std::string_view kStage = "estimating";

// What is known of the limb's acceleration at every sample, looking to both sides.
struct Surroundings {
  std::vector<double> acceleration_sd;
  std::vector<double> deviation;
  std::vector<double> noise;
};

Surroundings surroundings_of(std::span<const ForceSample> samples, const InclinationParameters& parameters) {
  Surroundings surroundings;
  surroundings.noise = noise_around(samples, parameters.sensor_noise);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double deviation = deviation_around(samples, i, parameters.burst_s, parameters.burst_s);
    surroundings.deviation.push_back(deviation);
    surroundings.acceleration_sd.push_back(acceleration_sd(deviation, surroundings.noise[i], parameters));
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
    forward.push_back(filter.step(samples[i], dt, around.acceleration_sd[i], around.noise[i]));
  }
  AdaptiveFilter backward(parameters);
  for (std::size_t i = samples.size(); i-- > 0;) {
    const double dt = i + 1 == samples.size() ? 0.0 : samples[i + 1].time_s - samples[i].time_s;
    const AdaptiveFilter::Sum& later = backward.step(samples[i], dt, around.acceleration_sd[i], around.noise[i]);
    const AdaptiveFilter::Sum own = AdaptiveFilter::alone(samples[i], around.acceleration_sd[i], around.noise[i]);
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

// One filter forward, then backward.
struct Pass {
  std::vector<Inclination> inclinations;
  std::vector<double> log_likelihoods;
};

Pass bridging_pass(std::span<const ForceSample> samples, const Surroundings& around,
                   std::span<const AccelerationStep> steps, double lever, const InclinationParameters& parameters,
                   const Progress& progress) {
  Pass pass;
  pass.inclinations.resize(samples.size());
  pass.log_likelihoods.resize(samples.size());
  InclinationFilter filter(parameters, lever);
  std::vector<InclinationFilter::Record> records;
  std::size_t first = 0;  // sample of records[0]
  const auto give_out = [&](std::size_t count) {
    const std::vector<InclinationFilter::State> states = InclinationFilter::smooth(records);
    for (std::size_t k = 0; k < count; ++k) {
      pass.inclinations[first + k] =
          inclination_of(states[k], samples[first + k], around.deviation[first + k], parameters);
    }
    records.erase(records.begin(), records.begin() + static_cast<std::ptrdiff_t>(count));
    first += count;
  };
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (i % kChunk == 0 && !progress.report(static_cast<double>(i) / static_cast<double>(samples.size()), kStage)) {
      return {};
    }
    filter.step(samples[i], steps[i], around.acceleration_sd[i], around.noise[i]);
    pass.log_likelihoods[i] = filter.log_likelihood();
    if (!filter.started()) {
      pass.inclinations[i].time_s = samples[i].time_s;
      first = i + 1;
      continue;
    }
    records.push_back(filter.record());
    if (records.size() >= kChunk + kAhead) {
      give_out(kChunk);
    }
  }
  give_out(records.size());
  return pass;
}

std::vector<Inclination> bridging(std::span<const ForceSample> samples, const InclinationParameters& parameters,
                                  const Progress& progress) {
  const Surroundings around = surroundings_of(samples, parameters);
  std::vector<Pass> passes;
  passes.reserve(kLevers.size());
  std::vector<AccelerationStep> steps;
  steps.reserve(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    steps.push_back(acceleration_step(i == 0 ? 0.0 : samples[i].time_s - samples[i - 1].time_s));
  }
  for (const double lever : kLevers) {
    const double share = 1.0 / static_cast<double>(kLevers.size());
    const double done = share * static_cast<double>(passes.size());
    passes.push_back(
        bridging_pass(samples, around, steps, lever, parameters, progress.part(done, std::min(1.0, done + share))));
    if (passes.back().inclinations.empty()) {
      return {};
    }
  }
  const auto logs_at = [&](std::size_t i) {
    Logs logs{};
    for (std::size_t k = 0; k < passes.size(); ++k) {
      logs[k] = passes[k].log_likelihoods[i];
    }
    return logs;
  };
  // Likelihoods of the seconds before and after every sample.
  std::vector<Logs> evidence(samples.size());
  Logs sum{};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    add_faded(sum, logs_at(i), i == 0 ? 0.0 : samples[i].time_s - samples[i - 1].time_s);
    evidence[i] = sum;
  }
  sum = Logs{};
  std::vector<Inclination> result(samples.size());
  std::vector<Inclination> each(kLevers.size());
  for (std::size_t i = samples.size(); i-- > 0;) {
    // The sample's own likelihood is in the forward sum already.
    for (std::size_t k = 0; k < sum.size(); ++k) {
      each[k] = passes[k].inclinations[i];
      evidence[i][k] += sum[k];
    }
    result[i] = mixed(each, weights_of(evidence[i]));
    add_faded(sum, logs_at(i), i == 0 ? 0.0 : samples[i].time_s - samples[i - 1].time_s);
  }
  return result;
}

}  // namespace

std::vector<Inclination> estimate_inclinations(std::span<const ForceSample> samples, Smoothing smoothing,
                                               const InclinationParameters& parameters, const Progress& progress) {
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
  if (!progress.report(0.0, kStage)) {
    return result;
  }
  switch (smoothing) {
    case Smoothing::kNone: {
      const Surroundings around = surroundings_of(ordered, parameters);
      for (std::size_t i = 0; i < ordered.size(); ++i) {
        result.push_back(raw_inclination(ordered[i], result.empty() ? Inclination{} : result.back(),
                                         around.deviation[i], around.noise[i], parameters));
      }
      break;
    }
    case Smoothing::kAdaptive:
      result = adaptive(ordered, parameters);
      break;
    case Smoothing::kBridging:
      result = bridging(ordered, parameters, progress);
      break;
  }
  if (result.empty()) {
    return result;  // told to stop
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

}  // namespace limbwave::estimate
