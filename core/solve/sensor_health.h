/// One sensor's health from its recent readings, in words a person can act on.
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>

#include "body/rig.h"
#include "calibrate/calibration.h"
#include "decode/slot_alignment.h"

namespace limbwave::solve {

enum class HealthState { kUnknown, kGood, kWarning, kBad };

/// Colour and words.
struct SensorHealth {
  HealthState state = HealthState::kUnknown;
  /// "good", "no-signal", "unusable", "not-plausible", "saturated", "gaps" or "no-calibration".
  std::string code;
  std::string text;  ///< What it is and what to do.
};

/// Judges accelerometer `sensor` by the newest second of `frames`, by what the rig's data sheet and the calibration
/// allow: lost readings, an input that nothing drives (all axes at the ground, at the supply or half-way), values out
/// of range, resting at another length than 1 g. A chip that holds one plausible value cannot be told from one at rest;
/// that shows when it is turned, in the range calibration.
SensorHealth sensor_health(const body::Rig& rig, const calibrate::SensorCalibration& calibration, int sensor,
                           std::span<const decode::AccelerationFrame> frames);

}  // namespace limbwave::solve
