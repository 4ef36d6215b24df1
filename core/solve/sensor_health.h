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
  std::string code;  ///< "good", "no-signal", "unusable", "stuck", "not-plausible", "saturated", "no-calibration" ...
  std::string text;  ///< What it is and what to do.
};

/// Judges accelerometer `sensor` by the newest second of `frames`. Readings are compared with what the rig's data sheet
/// and the calibration allow: out of range, frozen, or resting at another length than 1 g.
SensorHealth sensor_health(const body::Rig& rig, const calibrate::SensorCalibration& calibration, int sensor,
                           std::span<const decode::AccelerationFrame> frames);

}  // namespace limbwave::solve
