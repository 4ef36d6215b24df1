#include "calibrate/range_calibration.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/units.h"

namespace limbwave::calibrate {
namespace {

constexpr int kFolds = 5;
constexpr double kFoldSeconds = 2.0;
// Neighbours within the low pass's window say the same; one reading in 0.1 s is enough for the ellipsoid.
constexpr double kThinningSeconds = 0.1;
// Longer steps between readings are gaps, not steady time.
constexpr double kLongestStep = 0.1;

std::vector<RangeObservation> thinned(const std::vector<RangeObservation>& steady) {
  std::vector<RangeObservation> few;
  for (const RangeObservation& observation : steady) {
    if (few.empty() || observation.time_s - few.back().time_s >= kThinningSeconds - 1e-9) {
      few.push_back(observation);
    }
  }
  return few;
}

double seconds_of(const std::vector<RangeObservation>& steady, std::size_t index) {
  const double step = index == 0 ? 0.0 : steady[index].time_s - steady[index - 1].time_s;
  return step <= kLongestStep ? step : 0.0;
}

std::string axis_name(int axis) {
  return std::string(1, "xyz"[axis]);
}

struct Spread {
  double low = 0.0, high = 0.0, mean = 0.0, sd = 0.0;
};

template <typename Value>
Spread spread_of(const std::vector<RangeObservation>& steady, const Value& value) {
  Spread spread{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), 0.0, 0.0};
  for (const RangeObservation& observation : steady) {
    const double v = value(observation.x);
    spread.low = std::min(spread.low, v);
    spread.high = std::max(spread.high, v);
    spread.mean += v;
    spread.sd += v * v;
  }
  const auto n = static_cast<double>(steady.size());
  spread.mean /= n;
  spread.sd = std::sqrt(std::max(0.0, spread.sd / n - spread.mean * spread.mean));
  return spread;
}

}  // namespace

double held_out_residual(const std::vector<RangeObservation>& steady) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  double square = 0.0;
  std::size_t count = 0;
  const auto fold_of = [&](const RangeObservation& observation) {
    return static_cast<int>((observation.time_s - steady.front().time_s) / kFoldSeconds) % kFolds;
  };
  for (int fold = 0; fold < kFolds; ++fold) {
    std::vector<RangeObservation> training;
    std::vector<RangeObservation> held_out;
    for (const RangeObservation& observation : steady) {
      (fold_of(observation) == fold ? held_out : training).push_back(observation);
    }
    if (held_out.empty()) {
      continue;
    }
    const std::optional<EllipsoidFit> ellipsoid =
        fit_ellipsoid(thinned(training), fit_extremes(training).value_or(RangeModel{}));
    for (const RangeObservation& observation : held_out) {
      square += ellipsoid ? std::pow(ellipsoid->model.residual(observation.x), 2) : kNone;
      ++count;
    }
  }
  return count > 0 ? std::sqrt(square / static_cast<double>(count)) : kNone;
}

double rms_residual(const std::vector<RangeObservation>& steady, const RangeModel& model) {
  double square = 0.0;
  for (const RangeObservation& observation : steady) {
    square += std::pow(model.residual(observation.x), 2);
  }
  return std::sqrt(square / static_cast<double>(steady.size()));
}

RangeCalibrator::RangeCalibrator(const body::LineInSignal& signal, std::string serial,
                                 const RangeParameters& parameters)
    : signal_(signal), serial_(std::move(serial)), parameters_(parameters), filter_(parameters.steadiness) {}

void RangeCalibrator::push(double time_s, const Vector3d& volts, bool usable) {
  if (!std::isfinite(time_s) || (readings_ > 0 && time_s <= last_time_s_)) {
    return;
  }
  if (readings_ == 0) {
    first_time_s_ = time_s;
  }
  last_time_s_ = time_s;
  ++readings_;
  usable = usable && volts.allFinite();
  const double zero = signal_.zero_g_volts - signal_.reference_volts;
  const Vector3d x = (volts - Vector3d::Constant(zero)) / signal_.volts_per_g;
  if (!usable) {
    ++unusable_;
  } else if (x.cwiseAbs().maxCoeff() > 0.97 * signal_.range_g) {
    ++saturated_;
  }
  filter_.push(time_s, x, usable);
  consume(filter_.take());
}

void RangeCalibrator::push(const SensorSeries& series) {
  for (std::size_t i = 0; i < series.size(); ++i) {
    push(series.times[i], series.volts[i], series.usable[i] != 0);
  }
}

void RangeCalibrator::consume(const std::vector<SteadySample>& samples) {
  for (const SteadySample& sample : samples) {
    newest_ = sample;
    if (sample.steady) {
      const double step = sample.time_s - last_judged_s_;
      const double seconds = last_judged_s_ >= 0.0 && step <= kLongestStep ? step : 0.0;
      steady_.push_back({sample.time_s, sample.value});
      steady_s_ += seconds;
      live_.add(sample.value, seconds);
    }
    last_judged_s_ = sample.time_s;
  }
}

RangeProgress RangeCalibrator::progress() const {
  RangeProgress progress;
  progress.seconds = last_time_s_ - first_time_s_;
  progress.steady_s = steady_s_;
  progress.coverage = live_.fraction();
  progress.steady_now = newest_.steady;
  progress.unsteadiness_g = newest_.unsteadiness;
  progress.rate_g_per_s = newest_.rate;
  if (newest_.whole && newest_.value.norm() > 0.0) {
    progress.up_S = newest_.value.normalized();
  }
  progress.missing = live_.missing();
  progress.enough = progress.coverage >= parameters_.required_coverage &&
                    live_.largest_hole() <= parameters_.largest_hole && steady_s_ >= parameters_.required_steady_s;
  if (readings_ > 60 && unusable_ * 2 > readings_) {
    progress.hint = "no usable signal: check the plug and the level";
  } else if (newest_.whole && newest_.rate > parameters_.steadiness.largest_rate) {
    progress.hint = "turn it more slowly";
  } else if (newest_.whole && !newest_.steady) {
    progress.hint = "move it smoothly, without jerks";
  } else if (progress.enough && progress.coverage >= 0.9) {
    progress.hint = "enough: every direction was seen";
  } else if (!progress.missing.empty()) {
    progress.hint = "turn it until " + direction_words(progress.missing.front());
  }
  return progress;
}

Error RangeCalibrator::refuse(const std::string& message, const std::string& remedy) const {
  return {message, serial_.empty() ? "sensor" : "sensor " + serial_, remedy};
}

SensorCalibration RangeCalibrator::in_volts(const RangeModel& model, const char* method) const {
  SensorCalibration calibration;
  calibration.serial = serial_;
  calibration.method = method;
  calibration.M = model.A * (kStandardGravity / signal_.volts_per_g);
  calibration.offset =
      Vector3d::Constant(signal_.zero_g_volts - signal_.reference_volts) + model.b * signal_.volts_per_g;
  return calibration;
}

Status RangeCalibrator::check_signal(const std::vector<RangeObservation>& steady, Diagnostics& diagnostics) const {
  const auto n = static_cast<double>(readings_);
  if (readings_ == 0) {
    return refuse("there are no readings", "record the sensor while turning it slowly about all its axes");
  }
  const double lost = static_cast<double>(unusable_) / n;
  if (lost > 0.3) {
    return refuse(fmt::format("the signal was clipped or lost in {:.0f} % of the time", 100.0 * lost),
                  "lower the recording level until nothing clips, check the plug, and repeat");
  }
  if (lost > 0.02) {
    diagnostics.push_back({Severity::kWarning, "range.clipping",
                           fmt::format("{:.1f} % of the readings were clipped or lost", 100.0 * lost),
                           "lower the recording level", serial_, -1.0});
  }
  const double saturated = static_cast<double>(saturated_) / n;
  if (saturated > 0.005) {
    diagnostics.push_back({Severity::kWarning, "range.saturated",
                           fmt::format("the sensor reached its range of {:.1f} g in {:.1f} % of the readings",
                                       signal_.range_g, 100.0 * saturated),
                           "turn it more gently", serial_, -1.0});
  }
  double steady_s = 0.0;
  for (std::size_t i = 0; i < steady.size(); ++i) {
    steady_s += seconds_of(steady, i);
  }
  if (steady_s < parameters_.required_steady_s) {
    return refuse(fmt::format("the sensor was steady for only {:.1f} s; {:.0f} s are needed", steady_s,
                              parameters_.required_steady_s),
                  "turn it slowly, about ten seconds per full turn, without jerks");
  }
  return {};
}

Status RangeCalibrator::check_axes(const std::vector<RangeObservation>& steady) const {
  const Spread norm = spread_of(steady, [](const Vector3d& x) { return x.norm(); });
  // A right sensor keeps |x| within its 10 % errors of 1. Only when it does not is an axis under suspicion; otherwise
  // the sensor just has not been turned about it yet.
  const bool suspicious = norm.sd > 0.15;
  for (int axis = 0; axis < 3; ++axis) {
    const Spread spread = spread_of(steady, [axis](const Vector3d& x) { return x[axis]; });
    if (suspicious && spread.high - spread.low < 0.25) {
      return refuse(fmt::format("axis {} is stuck: it moved by only {:.2f} g while the others turned", axis_name(axis),
                                spread.high - spread.low),
                    "check this axis's wire and solder joint");
    }
    const int other = (axis + 1) % 3;
    const Spread second = spread_of(steady, [other](const Vector3d& x) { return x[other]; });
    double product = 0.0;
    for (const RangeObservation& observation : steady) {
      product += (observation.x[axis] - spread.mean) * (observation.x[other] - second.mean);
    }
    const double correlation = product / (static_cast<double>(steady.size()) * spread.sd * second.sd);
    if (suspicious && spread.sd > 0.1 && second.sd > 0.1 && std::abs(correlation) > 0.97) {
      return refuse(fmt::format("axes {} and {} show the same signal", axis_name(axis), axis_name(other)),
                    "check the wiring of these two axes for a short circuit or a doubled slot");
    }
    // Clipped somewhere before the decoder could see it: the axis stays at one end while the others go on turning.
    for (const double end : {spread.low, spread.high}) {
      std::vector<RangeObservation> at_end;
      std::copy_if(steady.begin(), steady.end(), std::back_inserter(at_end),
                   [&](const RangeObservation& observation) { return std::abs(observation.x[axis] - end) < 0.01; });
      // The length then varies as the clipped axis should; a sensor's own errors do that by less.
      if (spread.high - spread.low > 0.6 && at_end.size() * 20 > steady.size()) {
        const Spread length = spread_of(at_end, [](const Vector3d& x) { return x.norm(); });
        if (length.high - length.low > 0.33) {
          return refuse(fmt::format("axis {} stops at {:+.2f} g: its signal is clipped", axis_name(axis), end),
                        "lower the recording level, or check the sensor's supply");
        }
      }
    }
  }
  return {};
}

Status RangeCalibrator::check_gain(const std::vector<RangeObservation>& few, const EllipsoidFit& fit) const {
  // Only a fit that is poor can hide a step; below 0.4 % even one would not matter.
  if (fit.sigma < 0.004 && parameters_.good_residual_g > 0.004) {
    double rms = 0.0;
    for (const RangeObservation& observation : few) {
      rms += std::pow(fit.model.residual(observation.x), 2);
    }
    if (std::sqrt(rms / static_cast<double>(few.size())) < parameters_.good_residual_g) {
      return {};
    }
  }
  const Vector3d zero = Vector3d::Constant((signal_.zero_g_volts - signal_.reference_volts) / signal_.volts_per_g);
  const auto rms_with = [&](const EllipsoidFit& candidate, double time_s) {
    double sum = 0.0;
    for (const RangeObservation& observation : few) {
      const double gain = observation.time_s > time_s ? candidate.gain_after : 1.0;
      const double r = candidate.model.residual((observation.x + zero) / gain - zero);
      sum += std::min(r * r, 0.01);  // a left-over jerk must not decide
    }
    return std::sqrt(sum / static_cast<double>(few.size()));
  };
  const double before = rms_with(fit, std::numeric_limits<double>::infinity());
  double best = before;
  double best_time = 0.0;
  double best_gain = 1.0;
  const double begin = few.front().time_s;
  const double length = few.back().time_s - begin;
  for (int i = 1; i < 32; ++i) {
    const double time_s = begin + length * i / 32.0;
    const std::optional<EllipsoidFit> stepped = fit_ellipsoid(few, fit.model, GainStep{time_s, zero});
    if (stepped && rms_with(*stepped, time_s) < best) {
      best = rms_with(*stepped, time_s);
      best_time = time_s;
      best_gain = stepped->gain_after;
    }
  }
  if (best < 0.5 * before && std::abs(best_gain - 1.0) > 0.01) {
    return refuse(fmt::format("the volume was moved by {:+.1f} % about {:.0f} s after the start",
                              100.0 * (best_gain - 1.0), best_time - first_time_s_),
                  "leave the volume and the balance alone and repeat");
  }
  return {};
}

Result<RangeResult> RangeCalibrator::finish(const std::string& date) const {
  // What still waits in the low pass counts too; on a copy, so that pushing may go on.
  RangeCalibrator whole = *this;
  whole.filter_.finish();
  whole.consume(whole.filter_.take());
  const std::vector<RangeObservation>& steady = whole.steady_;

  RangeResult result;
  result.steady_s = whole.steady_s_;
  for (const Status& check :
       {check_signal(steady, result.diagnostics), steady.empty() ? Status{} : check_axes(steady)}) {
    if (!check) {
      return check.error();
    }
  }
  if (whole.live_.fraction() < 0.6 * parameters_.required_coverage) {
    return refuse(fmt::format("only {:.0f} % of all directions were covered; {:.0f} % are needed",
                              100.0 * whole.live_.fraction(), 100.0 * parameters_.required_coverage),
                  "go on turning it slowly, for example until " + direction_words(whole.live_.missing().front()));
  }
  const std::vector<RangeObservation> few = thinned(steady);
  const std::optional<RangeModel> extremes = fit_extremes(steady);
  const std::optional<EllipsoidFit> ellipsoid = fit_ellipsoid(few, extremes.value_or(RangeModel{}));
  if (!extremes || !ellipsoid) {
    return refuse("the readings do not form an ellipsoid", "turn it slowly about all its axes, through all directions");
  }
  if (const Status gain = check_gain(few, *ellipsoid); !gain) {
    return gain.error();
  }
  // With the calibration itself the directions are known well; the nominal one may be 10° off.
  SphereCoverage coverage;
  for (std::size_t i = 0; i < steady.size(); ++i) {
    coverage.add(ellipsoid->model.A * (steady[i].x - ellipsoid->model.b), seconds_of(steady, i));
  }
  if (coverage.fraction() < parameters_.required_coverage || coverage.largest_hole() > parameters_.largest_hole) {
    return refuse(fmt::format("{:.0f} % of all directions were covered, the largest hole is {:.0f}° wide",
                              100.0 * coverage.fraction(), 2.0 * degrees(coverage.largest_hole())),
                  "go on turning it slowly, for example until " + direction_words(coverage.missing().front()));
  }
  const double extremes_residual = rms_residual(steady, *extremes);
  const double ellipsoid_residual = held_out_residual(steady);
  result.extremes = in_volts(*extremes, "extremes");
  result.ellipsoid = in_volts(ellipsoid->model, "ellipsoid");
  result.extremes.residual_g = extremes_residual;
  result.ellipsoid.residual_g = ellipsoid_residual;
  result.offset_sd_g = ellipsoid->offset_sd;
  for (SensorCalibration* calibration : {&result.extremes, &result.ellipsoid}) {
    calibration->date = date;
    calibration->coverage = coverage.fraction();
  }
  const bool ellipsoid_better = ellipsoid_residual <= extremes_residual || !std::isfinite(extremes_residual);
  result.calibration = ellipsoid_better ? result.ellipsoid : result.extremes;
  const double residual = result.calibration.residual_g;
  if (!std::isfinite(residual)) {
    return refuse("the readings are too few to be checked against each other", "turn it for longer, a minute or so");
  }
  const RangeModel& chosen = ellipsoid_better ? ellipsoid->model : *extremes;
  if (chosen.b.cwiseAbs().maxCoeff() > 0.7 || chosen.A.diagonal().minCoeff() < 0.5 ||
      chosen.A.diagonal().maxCoeff() > 2.0) {
    return refuse(
        fmt::format("offset {:.2f} g and scale {:.2f} to {:.2f} are not those of this sensor",
                    chosen.b.cwiseAbs().maxCoeff(), chosen.A.diagonal().minCoeff(), chosen.A.diagonal().maxCoeff()),
        "check the rig's sensitivity and zero, the volume and the balance");
  }
  result.verdict = residual <= parameters_.good_residual_g     ? Verdict::kGood
                   : residual <= parameters_.usable_residual_g ? Verdict::kUsable
                                                               : Verdict::kRepeat;
  result.text = fmt::format(
      "{}: {:.1f} mg left over ({}; extremes {:.1f} mg, ellipsoid {:.1f} mg), {:.0f} % of all directions covered",
      name(result.verdict), 1e3 * residual, result.calibration.method, 1e3 * extremes_residual,
      1e3 * ellipsoid_residual, 100.0 * coverage.fraction());
  if (result.verdict == Verdict::kRepeat) {
    result.text += "; turn it more slowly and without jerks, and hold it at the box, not at the cable";
  }
  return result;
}

}  // namespace limbwave::calibrate
