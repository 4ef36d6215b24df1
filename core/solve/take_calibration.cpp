#include "solve/take_calibration.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "base/units.h"
#include "calibrate/gain_check.h"
#include "take/calibration_library.h"

namespace limbwave::solve {
namespace {

constexpr const char* kNominal = "nominal";
constexpr const char* kStage = "calibrating";

const take::TakeSegment* find_segment(const take::Take& take, const std::string& name) {
  const auto found = std::find_if(take.info.segments.begin(), take.info.segments.end(),
                                  [&](const take::TakeSegment& segment) { return segment.name == name; });
  return found == take.info.segments.end() ? nullptr : &*found;
}

// Sensors whose range is known from the data sheet alone.
std::vector<int> nominal_sensors(const calibrate::RigCalibration& calibration) {
  std::vector<int> sensors;
  for (std::size_t s = 0; s < calibration.sensors.size(); ++s) {
    if (calibration.sensors[s].method == kNominal) {
      sensors.push_back(static_cast<int>(s));
    }
  }
  return sensors;
}

// Those of a group whose mounting is known from the rig file alone.
std::vector<int> nominal_mounts(const calibrate::RigCalibration& calibration, const body::CalibrationGroup& group) {
  std::vector<int> sensors;
  std::copy_if(group.sensors.begin(), group.sensors.end(), std::back_inserter(sensors),
               [&](int s) { return calibration.mounts[static_cast<std::size_t>(s)].method == kNominal; });
  return sensors;
}

constexpr const char* kTurnAgain = "turn this sensor slowly about all axes again: limbwave calibrate range";
constexpr const char* kHoldAgain = "hold the poses again, still and exact: limbwave calibrate limb";

// A result that its own procedure would not keep is better than none, but not without a word.
Diagnostic poor(const char* code, const char* procedure, const std::string& verdict, const std::string& sensor,
                const char* remedy) {
  return {Severity::kWarning,
          code,
          fmt::format("the take's own {} calibration is poor: {}", procedure, verdict),
          remedy,
          sensor,
          -1.0};
}

void add(Diagnostics& to, const Diagnostics& from) {
  to.insert(to.end(), from.begin(), from.end());
}

// What `base` has only from the data sheet, from the take's own "range" and "pose:..." segments; empty when they give
// nothing, and `failed` tells why. Fails when it is told to stop.
Result<std::optional<ChosenCalibration>> from_segments(const take::Take& take, const DecodedTake& decoded,
                                                       const calibrate::RigCalibration& base, Diagnostics& failed,
                                                       const Progress& progress) {
  const body::Rig& rig = take.info.rig;
  ChosenCalibration chosen{base, "segments", "", {}};
  int ranges = 0;
  int mounts = 0;
  double worst_residual = 0.0;
  double worst_angle = 0.0;
  if (const take::TakeSegment* range = find_segment(take, kRangeSegment)) {
    for (RangeOutcome& outcome :
         calibrate_range(take, decoded.of(take, *range), nominal_sensors(base), progress.part(0.0, 0.8))) {
      const auto s = static_cast<std::size_t>(outcome.sensor);
      if (!outcome.result) {
        const Error& error = outcome.result.error();
        chosen.diagnostics.push_back({Severity::kWarning, "calibration.range-failed",
                                      "range calibration failed: " + error.message, error.remedy,
                                      rig.accelerometers[s].name, -1.0});
        continue;
      }
      add(chosen.diagnostics, outcome.result->diagnostics);
      if (outcome.result->verdict == calibrate::Verdict::kRepeat) {
        chosen.diagnostics.push_back(
            poor("calibration.range-poor", "range", outcome.result->text, rig.accelerometers[s].name, kTurnAgain));
      }
      chosen.calibration.sensors[s] = outcome.result->calibration;
      worst_residual = std::max(worst_residual, outcome.result->calibration.residual_g);
      ++ranges;
    }
  }
  for (std::size_t g = 0; g < rig.groups.size(); ++g) {
    if (!progress.report(0.8 + 0.2 * static_cast<double>(g) / static_cast<double>(rig.groups.size()), kStage)) {
      return cancelled();
    }
    const take::TakeSegment* first = find_segment(take, pose_segment(rig.groups[g], 0));
    const take::TakeSegment* second = find_segment(take, pose_segment(rig.groups[g], 1));
    const std::vector<int> sensors = nominal_mounts(base, rig.groups[g]);
    if (first == nullptr || second == nullptr || sensors.empty()) {
      continue;
    }
    const Result<calibrate::LimbResult> limb = calibrate_limb(take, static_cast<int>(g), decoded.of(take, *first),
                                                              decoded.of(take, *second), chosen.calibration, sensors);
    if (!limb) {
      chosen.diagnostics.push_back({Severity::kWarning, "calibration.limb-failed",
                                    "limb calibration failed: " + limb.error().message, limb.error().remedy,
                                    rig.groups[g].name, -1.0});
      continue;
    }
    add(chosen.diagnostics, limb->diagnostics);
    for (const calibrate::SensorLimbResult& sensor : limb->sensors) {
      const auto s = static_cast<std::size_t>(sensor.sensor);
      if (sensor.verdict == calibrate::Verdict::kRepeat) {
        chosen.diagnostics.push_back(
            poor("calibration.limb-poor", "limb", sensor.text, rig.accelerometers[s].name, kHoldAgain));
      }
      if (sensor.mount.method == kNominal) {
        continue;  // the poses gave no mounting
      }
      chosen.calibration.mounts[s] = sensor.mount;
      worst_angle = std::max(worst_angle, std::abs(sensor.angle_error_deg));
      ++mounts;
    }
  }
  if (ranges + mounts == 0) {
    failed = std::move(chosen.diagnostics);
    return std::optional<ChosenCalibration>();
  }
  chosen.explanation = fmt::format(
      "from the take's own calibration: range of {} of {} sensors (residual at most {:.4f} g), mounting of {} (poses "
      "at "
      "most {:.1f}° from perpendicular)",
      ranges, rig.accelerometers.size(), worst_residual, mounts, worst_angle);
  return std::optional(std::move(chosen));
}

// Takes over what `to` knows from the data sheet alone and `from` does not; returns how many entries that were.
int complete_ranges(calibrate::RigCalibration& to, const calibrate::RigCalibration& from) {
  int taken = 0;
  for (std::size_t s = 0; s < to.sensors.size(); ++s) {
    if (to.sensors[s].method == kNominal && from.sensors[s].method != kNominal) {
      to.sensors[s] = from.sensors[s];
      ++taken;
    }
  }
  return taken;
}

int complete_mounts(calibrate::RigCalibration& to, const calibrate::RigCalibration& from) {
  int taken = 0;
  for (std::size_t s = 0; s < to.mounts.size(); ++s) {
    if (to.mounts[s].method == kNominal && from.mounts[s].method != kNominal) {
      to.mounts[s] = from.mounts[s];
      ++taken;
    }
  }
  return taken;
}

bool is_whole(const calibrate::RigCalibration& calibration) {
  const auto measured = [](const auto& entry) { return entry.method != kNominal; };
  return std::all_of(calibration.sensors.begin(), calibration.sensors.end(), measured) &&
         std::all_of(calibration.mounts.begin(), calibration.mounts.end(), measured);
}

// Says of which sensors the data sheet stands in for a measurement; nothing when there are none.
void name_gaps(const body::Rig& rig, ChosenCalibration& chosen) {
  std::vector<std::string> ranges, mounts, parts;
  for (std::size_t s = 0; s < rig.accelerometers.size(); ++s) {
    if (chosen.calibration.sensors[s].method == kNominal) {
      ranges.push_back(rig.accelerometers[s].name);
    }
    if (chosen.calibration.mounts[s].method == kNominal) {
      mounts.push_back(rig.accelerometers[s].name);
    }
  }
  if (!ranges.empty()) {
    parts.push_back(fmt::format("the range of {}", fmt::join(ranges, ", ")));
  }
  if (!mounts.empty()) {
    parts.push_back(fmt::format("the mounting of {}", fmt::join(mounts, ", ")));
  }
  if (!parts.empty()) {
    chosen.diagnostics.push_back({Severity::kWarning, "calibration.partial",
                                  fmt::format("never calibrated, so from the data sheet: {}", fmt::join(parts, "; ")),
                                  "calibrate these sensors, then solve again", "", -1.0});
  }
}

// Says whose mounting was found from poses that were not held well, whoever kept it; procedures speak for themselves.
void name_loose_poses(const body::Rig& rig, ChosenCalibration& chosen) {
  const calibrate::LimbParameters limits;
  std::vector<std::string> names;
  double worst = 0.0;
  for (std::size_t s = 0; s < chosen.calibration.mounts.size(); ++s) {
    const calibrate::MountCalibration& mount = chosen.calibration.mounts[s];
    const double off = std::abs(mount.pose_angle_deg - 90.0);
    const std::string& name = rig.accelerometers[s].name;
    const bool told = std::any_of(chosen.diagnostics.begin(), chosen.diagnostics.end(), [&](const Diagnostic& one) {
      return one.code == "calibration.limb-poor" && one.place == name;
    });
    if (mount.method != kNominal && off > limits.good_angle_deg && !told) {
      names.push_back(name);
      worst = std::max(worst, off);
    }
  }
  if (!names.empty()) {
    const bool poor = worst > limits.usable_angle_deg;
    chosen.diagnostics.push_back(
        {poor ? Severity::kWarning : Severity::kInfo, poor ? "calibration.limb-poor" : "calibration.limb-usable",
         fmt::format("the mounting poses were up to {:.1f}° from perpendicular: {}", worst, fmt::join(names, ", ")),
         "hold the poses more exactly to make it better", "", -1.0});
  }
}

std::string newest_date(const calibrate::RigCalibration& calibration) {
  std::string newest;
  for (const calibrate::SensorCalibration& sensor : calibration.sensors) {
    newest = std::max(newest, sensor.date);
  }
  for (const calibrate::MountCalibration& mount : calibration.mounts) {
    newest = std::max(newest, mount.date);
  }
  return newest.empty() ? "an unknown date" : newest;
}

}  // namespace

std::string pose_segment(const body::CalibrationGroup& group, int pose) {
  return fmt::format("pose:{}:{}", group.name, pose == 0 ? "first" : "second");
}

bool is_measured(const calibrate::RigCalibration& calibration) {
  return std::any_of(calibration.sensors.begin(), calibration.sensors.end(),
                     [](const auto& sensor) { return sensor.method != kNominal; }) ||
         std::any_of(calibration.mounts.begin(), calibration.mounts.end(),
                     [](const auto& mount) { return mount.method != kNominal; });
}

std::vector<RangeOutcome> calibrate_range(const take::Take& take, std::span<const decode::AccelerationFrame> frames,
                                          const std::vector<int>& sensors, const Progress& progress) {
  std::vector<RangeOutcome> outcomes;
  for (const int sensor : sensors) {
    if (!progress.report(static_cast<double>(outcomes.size()) / static_cast<double>(sensors.size()), kStage)) {
      break;
    }
    const std::string& serial = take.info.rig.accelerometers.at(static_cast<std::size_t>(sensor)).serial;
    calibrate::RangeCalibrator calibrator(take.info.rig.line_in, serial);
    calibrator.push(calibrate::sensor_series(frames, sensor));
    outcomes.push_back({sensor, calibrator.finish(take.info.created)});
  }
  return outcomes;
}

Result<calibrate::LimbResult> calibrate_limb(const take::Take& take, int group,
                                             std::span<const decode::AccelerationFrame> first,
                                             std::span<const decode::AccelerationFrame> second,
                                             const calibrate::RigCalibration& range, const std::vector<int>& sensors) {
  calibrate::LimbCalibrator calibrator(take.info.rig, range, group, sensors);
  calibrator.push(0, first);
  calibrator.push(1, second);
  return calibrator.finish(take.info.created);
}

Result<ChosenCalibration> choose_calibration(const take::Take& take, const DecodedTake& decoded,
                                             const std::string& wanted, const Progress& progress) {
  if (!progress.report(0.0, kStage)) {
    return cancelled();
  }
  const bool automatic = wanted == "auto";
  const body::Rig& rig = take.info.rig;
  const bool has_snapshot = take.info.calibration && is_measured(*take.info.calibration);
  if (wanted == "snapshot" && !has_snapshot) {
    return Error{"has no calibration in it", take.folder.string(), "calibrate it, or choose another --calibration"};
  }
  // A snapshot of which a part was never measured is completed from the take's own movements, then from the library.
  calibrate::RigCalibration base =
      automatic && has_snapshot ? *take.info.calibration : calibrate::nominal_calibration(rig);
  std::optional<take::LibraryLookup> library;
  int added = 0;
  if ((automatic && !is_whole(base)) || wanted == "library") {
    library = take::library_calibration(rig, take.info.subject);
    if (automatic && library->calibration && find_segment(take, kRangeSegment) == nullptr) {
      added = complete_ranges(base, *library->calibration);  // The take's own poses are read through them.
    }
  }
  const auto completed = [&](ChosenCalibration chosen) {
    if (automatic && library && library->calibration) {
      added += complete_ranges(chosen.calibration, *library->calibration);
      added += complete_mounts(chosen.calibration, *library->calibration);
      if (added > 0) {
        chosen.explanation += "; completed by the " + library->explanation;
      }
      add(chosen.diagnostics, library->diagnostics);
    }
    name_gaps(rig, chosen);
    name_loose_poses(rig, chosen);
    return chosen;
  };
  Diagnostics failed;  // what kept the take's own movements from being used
  if (automatic || wanted == "segments") {
    Result<std::optional<ChosenCalibration>> chosen = from_segments(take, decoded, base, failed, progress);
    if (!chosen) {
      return chosen.error();
    }
    if (*chosen) {
      return completed(**std::move(chosen));
    }
    if (!automatic && !failed.empty()) {
      return Error{failed.front().message, failed.front().place, failed.front().remedy};
    }
    if (!automatic) {
      return Error{"has no calibration segments", take.folder.string(), "choose another --calibration"};
    }
  }
  if ((automatic || wanted == "snapshot") && has_snapshot) {
    return completed({automatic ? base : *take.info.calibration, "snapshot",
                      "as recorded in the take, of " + newest_date(*take.info.calibration), failed});
  }
  if (library && library->calibration) {
    ChosenCalibration chosen{*library->calibration, "library", library->explanation, library->diagnostics};
    add(chosen.diagnostics, failed);
    name_gaps(rig, chosen);
    name_loose_poses(rig, chosen);
    return chosen;
  }
  if (wanted == "library") {
    return Error{library->explanation, take.folder.string(), "calibrate its sensors, or choose another --calibration"};
  }
  if (automatic || wanted == "nominal") {
    ChosenCalibration chosen{calibrate::nominal_calibration(rig), "nominal", "from the data sheet alone", failed};
    if (automatic) {
      chosen.diagnostics.push_back({Severity::kWarning, "calibration.none",
                                    "no sensor of this take was ever calibrated, so inclinations may be 10° wrong",
                                    "calibrate the range of the sensors and their mounting", "", -1.0});
    }
    return chosen;
  }
  return Error{"is not a source of calibrations", "\"" + wanted + "\"",
               "use auto, snapshot, segments, library or nominal"};
}

RecordingCalibration calibration_for_recording(const body::Rig& rig, const std::string& subject) {
  const take::LibraryLookup found = take::library_calibration(rig, subject);
  return {found.calibration ? *found.calibration : calibrate::nominal_calibration(rig), found.explanation,
          found.diagnostics};
}

}  // namespace limbwave::solve
