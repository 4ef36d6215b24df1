#include "solve/limb_forces.h"

#include "solve/front_end.h"

namespace limbwave::solve {

estimate::ForceSample limb_force(const decode::AccelerationFrame& frame, std::size_t sensor,
                                 const body::LineInSignal& signal, const calibrate::RigCalibration& calibration) {
  return {frame.time_s, calibration.mounts[sensor].R_LS * calibration.sensors[sensor].apply(frame.volts[sensor]),
          (frame.usable >> sensor & 1U) != 0 && !saturated(signal, frame.volts[sensor])};
}

std::vector<estimate::ForceSample> limb_forces(std::span<const decode::AccelerationFrame> frames, std::size_t sensor,
                                               const body::LineInSignal& signal,
                                               const calibrate::RigCalibration& calibration) {
  std::vector<estimate::ForceSample> samples;
  samples.reserve(frames.size());
  for (const decode::AccelerationFrame& frame : frames) {
    samples.push_back(limb_force(frame, sensor, signal, calibration));
  }
  return samples;
}

}  // namespace limbwave::solve
