#include "solve/solve.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/units.h"
#include "calibrate/gain_check.h"
#include "estimate/chain_smoother.h"
#include "solve/compose.h"
#include "solve/decoded_take.h"
#include "solve/limb_forces.h"
#include "solve/take_calibration.h"

namespace limbwave::solve {
namespace {

using Frames = std::span<const decode::AccelerationFrame>;

// Undoes a volume or balance that is not the one of the day of calibration, where gravity at rest shows it.
void correct_gain(Frames frames, calibrate::RigCalibration& calibration, Diagnostics& diagnostics) {
  const std::vector<calibrate::StillReading> readings = calibrate::still_readings(frames, calibration.sensors);
  const Result<calibrate::GainResult> gain = calibrate::estimate_gain(readings, calibration.sensors);
  if (!gain || !gain->moved) {
    return;  // too little rest to tell, or nothing to correct
  }
  for (calibrate::SensorCalibration& sensor : calibration.sensors) {
    sensor = calibrate::with_gain(sensor, gain->gain);
  }
  diagnostics.push_back(
      {std::abs(gain->gain - 1.0) > 0.05 ? Severity::kWarning : Severity::kInfo, "gain.corrected",
       fmt::format(
           "the line is {:.2f} ± {:.2f} % {} than on the day of calibration; gravity at rest showed it and it was "
           "corrected",
           100.0 * std::abs(gain->gain - 1.0), 100.0 * gain->standard_error, gain->gain > 1.0 ? "quieter" : "louder"),
       "", "", -1.0});
}

SensorQuality quality(const std::string& name, const std::vector<estimate::ForceSample>& samples,
                      const std::vector<estimate::Inclination>& inclinations) {
  SensorQuality result;
  result.sensor = name;
  double norms = 0.0;
  std::size_t still = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    result.usable += samples[i].usable ? 1.0 : 0.0;
    result.trusted += inclinations[i].trust > 0.5 ? 1.0 : 0.0;
    // At rest: this reading and its neighbours of a quarter of a second agree to 0.02 g.
    constexpr std::size_t kReach = 8;
    if (i >= kReach && i + kReach < samples.size() && samples[i].usable &&
        (samples[i + kReach].f_L - samples[i].f_L).norm() < 0.02 * kStandardGravity &&
        (samples[i - kReach].f_L - samples[i].f_L).norm() < 0.02 * kStandardGravity) {
      norms += samples[i].f_L.norm() / kStandardGravity;
      ++still;
    }
  }
  const auto count = static_cast<double>(std::max<std::size_t>(samples.size(), 1));
  result.usable /= count;
  result.trusted /= count;
  result.mean_norm_g = still > 0 ? norms / static_cast<double>(still) : 0.0;
  return result;
}

}  // namespace

Result<Solve> solve_take(const take::Take& take, const SolveSettings& settings, const Progress& progress) {
  const Result<DecodedTake> decoded = decode_take(take, settings.line_in, progress.part(0.0, 0.6));
  if (!decoded) {
    return decoded.error();
  }
  const auto start = std::chrono::steady_clock::now();
  Result<ChosenCalibration> chosen = choose_calibration(take, *decoded, settings.calibration, progress.part(0.6, 0.65));
  if (!chosen) {
    return chosen.error();
  }
  const take::TakeSegment capture = take.info.capture();
  const Frames frames = decoded->of(take, capture);
  if (frames.empty()) {
    return Error{"has no decoded reading within its capture", take.folder.string(),
                 "check the events of the take: limbwave info TAKE"};
  }
  Solve solve;
  solve.settings = settings;
  solve.report.diagnostics = decoded->diagnostics;
  solve.report.diagnostics.insert(solve.report.diagnostics.end(), chosen->diagnostics.begin(),
                                  chosen->diagnostics.end());
  solve.report.calibration = chosen->explanation;
  solve.report.used_calibration = chosen->calibration;
  if (chosen->source == "snapshot" || chosen->source == "library") {
    correct_gain(frames, chosen->calibration, solve.report.diagnostics);
  }

  const double origin = take.info.format.rate.seconds(capture.first).value;
  std::vector<double> times;
  times.reserve(frames.size());
  for (const decode::AccelerationFrame& frame : frames) {
    times.push_back(frame.time_s - origin);
  }
  const body::Skeleton& skeleton = take.info.skeleton;
  const std::vector<int> segments = sensor_segments(take.info.rig, skeleton);
  std::vector<std::vector<Eigen::Quaterniond>> inclined(skeleton.segments.size());
  estimate::InclinationParameters parameters;
  parameters.smoothing_s = settings.smoothing_s;
  std::vector<std::vector<estimate::ForceSample>> samples;
  std::vector<std::vector<estimate::Inclination>> inclinations;
  const double share = 0.2 / static_cast<double>(segments.size());
  for (std::size_t s = 0; s < segments.size(); ++s) {
    samples.push_back(limb_forces(frames, s, take.info.rig.line_in, chosen->calibration));
    inclinations.push_back(estimate::estimate_inclinations(
        samples.back(), settings.smoothing, parameters,
        progress.part(0.65 + share * static_cast<double>(s), 0.65 + share * static_cast<double>(s + 1))));
    if (inclinations.back().size() != samples.back().size()) {
      return cancelled();
    }
  }
  if (settings.smoothing == Smoothing::kChain) {
    auto together = estimate::smooth_chain(estimate::limb_chain(take.info.rig, skeleton), samples, inclinations, {},
                                           progress.part(0.85, 0.97));
    if (!together) {
      return together.error();
    }
    inclinations = *std::move(together);
  }
  for (std::size_t s = 0; s < segments.size(); ++s) {
    std::vector<float>& trust = solve.trust.emplace_back();
    const body::Accelerometer& accelerometer = take.info.rig.accelerometers[s];
    if (segments[s] < 0) {
      solve.report.diagnostics.push_back(
          {Severity::kWarning, "solve.no-segment",
           fmt::format("sits on \"{}\", which is no segment of the skeleton, and is left out", accelerometer.segment),
           "correct the rig in take.json", accelerometer.name, -1.0});
      continue;
    }
    Result<std::vector<Eigen::Quaterniond>> orientations = limb_orientations(inclinations[s], accelerometer.name);
    if (!orientations) {
      return orientations.error();
    }
    inclined[static_cast<std::size_t>(segments[s])] = *std::move(orientations);
    for (const estimate::Inclination& inclination : inclinations[s]) {
      trust.push_back(static_cast<float>(inclination.trust));
    }
    solve.report.sensors.push_back(quality(accelerometer.name, samples[s], inclinations[s]));
  }
  solve.clip =
      compose_clip(skeleton, times, inclined, settings.headings, std::round(decoded->line.cycle_rate_hz * 1e3) / 1e3);
  solve.clip.name = take.folder.stem().string();
  solve.report.line = decoded->line;
  solve.report.take_seconds = take.info.format.rate.seconds(capture.count).value;
  solve.report.decode_seconds = decoded->seconds;
  solve.report.solve_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  (void)progress.report(1.0, "done");
  return solve;
}

}  // namespace limbwave::solve
