/// Where a take's calibration comes from, and how one is made out of a take's segments.
#pragma once

#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "calibrate/calibration.h"
#include "calibrate/limb_calibration.h"
#include "calibrate/range_calibration.h"
#include "solve/decoded_take.h"
#include "take/take.h"

namespace limbwave::solve {

/// Names of the segments that hold calibration movements.
inline constexpr const char* kRangeSegment = "range";
std::string pose_segment(const body::CalibrationGroup& group, int pose);  ///< "pose:Right arm:first"

/// Range calibration of one sensor, or why it failed.
struct RangeOutcome {
  int sensor = 0;
  Result<calibrate::RangeResult> result;
};

/// Range calibration of all sensors from a stretch in which each is turned slowly about all axes. Told to stop, it
/// returns what it has.
std::vector<RangeOutcome> calibrate_range(const take::Take& take, std::span<const decode::AccelerationFrame> frames,
                                          const std::vector<int>& sensors, const Progress& progress = {});

/// Limb calibration of one group from the stretches of its two poses. `sensors` empty: all of the group.
Result<calibrate::LimbResult> calibrate_limb(const take::Take& take, int group,
                                             std::span<const decode::AccelerationFrame> first,
                                             std::span<const decode::AccelerationFrame> second,
                                             const calibrate::RigCalibration& range,
                                             const std::vector<int>& sensors = {});

/// The calibration that a solve uses, and where it is from.
struct ChosenCalibration {
  calibrate::RigCalibration calibration;
  std::string source;       ///< "snapshot", "segments", "library" or "nominal".
  std::string explanation;  ///< For people, with dates or residuals.
  Diagnostics diagnostics;
};

/// `wanted` as SolveSettings::calibration. Fails when one is asked for by name that the take does not have. Asks
/// `progress` before every sensor.
Result<ChosenCalibration> choose_calibration(const take::Take& take, const DecodedTake& decoded,
                                             const std::string& wanted, const Progress& progress = {});

/// What a new recording starts with.
struct RecordingCalibration {
  /// Of the library what it has for each sensor, the data sheet's for the rest.
  calibrate::RigCalibration calibration;
  std::string explanation;  ///< One line for people: from when and of whom it is, and what is missing.
  Diagnostics diagnostics;  ///< Records of the library that could not be read.
};
RecordingCalibration calibration_for_recording(const body::Rig& rig, const std::string& subject);

/// True when anything in it was measured rather than taken from the data sheet.
bool is_measured(const calibrate::RigCalibration& calibration);

}  // namespace limbwave::solve
