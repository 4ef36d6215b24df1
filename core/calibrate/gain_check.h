/// Finds one gain factor common to all sensors: a sound card whose volume or left/right balance is not the one of the
/// day of calibration. Gravity is a known length in every sensor, so its readings at rest tell.
#pragma once

#include <span>
#include <vector>

#include "base/result.h"
#include "calibrate/calibration.h"
#include "calibrate/stillness.h"
#include "decode/slot_alignment.h"

namespace limbwave::calibrate {

/// A mean reading at rest of one sensor.
struct StillReading {
  int sensor = 0;                     ///< Index into the calibrations.
  Vector3d volts = Vector3d::Zero();  ///< Mean.
  int window = 0;                     ///< Readings of one window are of one pose.
};

struct GainResult {
  double gain = 1.0;            ///< γ: multiply volts by it to have those of the day of calibration.
  double standard_error = 0.0;  ///< Of γ, from how well the sensors agree.
  double residual_g = 0.0;      ///< RMS of |f|/g − 1 after applying γ, outliers included.
  double before_g = 0.0;        ///< The same with γ = 1.
  int readings = 0;
  bool moved = false;  ///< γ differs from 1 significantly (3 standard errors) and by more than 0.2 %.
};

/// γ that minimises Σ ρ(|M_s (γ v − o_s)|/g − 1) over all readings (Gauss-Newton with Huber weights, from γ = 1).
/// Needs readings that together are sensitive to γ: fails when there are none, or when γ is uncertain by more than 5 %.
/// Valid for 0.5 < γ < 2; fails outside.
Result<GainResult> estimate_gain(std::span<const StillReading> readings, std::span<const SensorCalibration> sensors);

/// The readings at rest of a stretch: every stretch of a second in which no sensor moves by more than `threshold_g`.
/// Sensors that are unusable throughout are left out.
std::vector<StillReading> still_readings(std::span<const decode::AccelerationFrame> frames,
                                         std::span<const SensorCalibration> sensors, double threshold_g = 0.02);

/// The calibration for volts as they now are: apply(volts) of the result is apply(γ · volts) of `sensor`.
SensorCalibration with_gain(const SensorCalibration& sensor, double gain);

}  // namespace limbwave::calibrate
