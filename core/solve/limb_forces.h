/// Calibrated readings in the limbs' frames: what the estimators start from.
#pragma once

#include <span>
#include <vector>

#include "body/rig.h"
#include "calibrate/calibration.h"
#include "decode/slot_alignment.h"
#include "estimate/inclination.h"

namespace limbwave::solve {

/// One reading: R_LS · SensorCalibration::apply(volts); not usable where the decoder says so or the sensor saturates.
estimate::ForceSample limb_force(const decode::AccelerationFrame& frame, std::size_t sensor,
                                 const body::LineInSignal& signal, const calibrate::RigCalibration& calibration);

/// The readings of one sensor, one per frame.
std::vector<estimate::ForceSample> limb_forces(std::span<const decode::AccelerationFrame> frames, std::size_t sensor,
                                               const body::LineInSignal& signal,
                                               const calibrate::RigCalibration& calibration);

}  // namespace limbwave::solve
