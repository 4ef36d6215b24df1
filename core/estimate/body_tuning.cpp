#include "estimate/body_tuning.h"

#include <algorithm>
#include <cmath>

#include "estimate/body_smoother.h"

namespace limbwave::estimate {
namespace {

using P = BodyFilterParameters;

struct Noise {
  const char* what;
  std::vector<double P::*> members;
};

std::vector<Noise> noises_of(const P& p) {
  std::vector<Noise> noises{{"movement", {&P::acceleration_walk, &P::root_acceleration_walk}}};
  if (p.use_gyroscopes || p.use_accelerometers) {
    noises.push_back(
        {"inertial",
         {&P::gyroscope_noise, &P::gyroscope_relative, &P::accelerometer_noise, &P::accelerometer_relative}});
  }
  if (p.use_ranges) {
    noises.push_back({"ranges", {&P::range_noise, &P::range_model}});
  }
  return noises;
}

BodyReadings beginning(const BodyReadings& readings, double seconds) {
  BodyReadings part;
  const double from = std::min(readings.inertial.empty() ? INFINITY : readings.inertial.front().time_s,
                               readings.ranges.empty() ? INFINITY : readings.ranges.front().time_s);
  const auto take = [&](const auto& all, auto& some) {
    for (const auto& reading : all) {
      if (reading.time_s <= from + seconds) {
        some.push_back(reading);
      }
    }
  };
  take(readings.inertial, part.inertial);
  take(readings.ranges, part.ranges);
  part.root = readings.root;
  return part;
}

// A gated reading speaks against the noises as much as one at the gate, for otherwise the likelihood would grow by
// gating. Half of the gate's χ² and the logarithm of a usual density.
constexpr double kGated = 20.0;

double score(const BodyRun& run, double settles_s) {
  double all = run.log_likelihood;
  const std::vector<double>& times = run.track.times;
  if (!times.empty() && times.back() - times.front() > 2.0 * settles_s) {
    const auto settled = std::lower_bound(times.begin(), times.end(), times.front() + settles_s);
    all -= run.log_likelihoods[static_cast<std::size_t>(settled - times.begin())];
  }
  for (const auto* counts : {&run.gyroscopes, &run.accelerometers, &run.ranges}) {
    for (const ReadingCount& count : *counts) {
      all -= kGated * static_cast<double>(count.gated);
    }
  }
  return all;
}

}  // namespace

Result<BodyTuning> tune_body(const BodyModel& model, const BodyFilterParameters& parameters,
                             const BodyReadings& readings, const BodyTuningSettings& settings, const Progress& progress,
                             const std::function<std::unique_ptr<BodyStepHook>()>& hook) {
  const BodyReadings part = beginning(readings, settings.seconds);
  const std::vector<Noise> noises = noises_of(parameters);
  const double end = std::log2(settings.most);
  std::vector<double> octaves(noises.size(), 0.0);
  const auto scaled = [&](const std::vector<double>& by) {
    P p = parameters;
    for (std::size_t i = 0; i < noises.size(); ++i) {
      for (double P::*member : noises[i].members) {
        p.*member *= std::exp2(by[i]);
      }
    }
    return p;
  };
  constexpr int kUsualRuns = 30;
  int runs = 0;
  Error failed;
  // Log likelihood; NaN where it cannot be had.
  const auto likelihood = [&](const std::vector<double>& by) {
    const auto at = [](int n) { return 1.0 - std::exp(-2.0 * n / kUsualRuns); };
    const std::unique_ptr<BodyStepHook> around = hook ? hook() : nullptr;
    const Progress of_run = progress.part(at(runs), at(runs + 1));
    ++runs;
    const Result<BodyRun> run = filter_body(model, scaled(by), part, 10.0, of_run, around.get());
    if (!run) {
      failed = run.error();
      return std::nan("");
    }
    return score(*run, settings.settles_s);
  };
  double best = likelihood(octaves);
  BodyTuning tuning;
  tuning.before = best;
  double step = 1.0;
  // One noise after the other, up or down as long as it helps; then by smaller steps.
  while (std::isfinite(best) && step >= settings.accuracy) {
    bool moved = false;
    for (std::size_t i = 0; i < noises.size() && std::isfinite(best); ++i) {
      for (const double by : {-step, step}) {
        while (std::abs(octaves[i] + by) <= end + 1e-9) {
          std::vector<double> there = octaves;
          there[i] += by;
          const double value = likelihood(there);
          if (!std::isfinite(value)) {
            return failed;
          }
          if (value <= best) {
            break;
          }
          best = value;
          octaves = there;
          moved = true;
        }
      }
    }
    if (!moved) {
      step *= 0.5;
    }
  }
  if (!std::isfinite(best)) {
    return failed;
  }
  tuning.after = best;
  tuning.parameters = scaled(octaves);
  for (std::size_t i = 0; i < noises.size(); ++i) {
    tuning.noises.push_back({noises[i].what, std::exp2(octaves[i])});
  }
  const auto& inertial = part.inertial;
  tuning.seconds = inertial.size() > 1 ? inertial.back().time_s - inertial.front().time_s : settings.seconds;
  return tuning;
}

}  // namespace limbwave::estimate
