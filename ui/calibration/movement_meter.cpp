#include "calibration/movement_meter.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace limbwave::ui {

MovementMeter::MovementMeter(std::vector<int> sensors, const calibrate::RigCalibration& range)
    : sensors_(std::move(sensors)) {
  for (const int sensor : sensors_) {
    calibrations_.push_back(range.sensors.at(static_cast<std::size_t>(sensor)));
  }
}

void MovementMeter::push(const decode::AccelerationFrame& frame) {
  frames_.push_back(frame);
  while (frame.time_s - frames_.front().time_s > kWindowS) {
    frames_.pop_front();
  }
}

void MovementMeter::clear() {
  frames_.clear();
}

std::vector<SensorMovement> MovementMeter::movements() const {
  std::vector<SensorMovement> movements(sensors_.size());
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    const auto sensor = static_cast<std::size_t>(sensors_[i]);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double squares = 0.0;
    double count = 0.0;
    double last_usable_s = -1e9;
    for (const decode::AccelerationFrame& frame : frames_) {
      if ((frame.usable >> sensor & 1U) == 0 || !frame.volts.at(sensor).allFinite()) {
        continue;
      }
      movements[i].force = calibrations_[i].apply(frame.volts.at(sensor));
      const Eigen::Vector3d g = movements[i].force / kStandardGravity;
      sum += g;
      squares += g.squaredNorm();
      count += 1.0;
      last_usable_s = frame.time_s;
    }
    movements[i].heard = !frames_.empty();
    if (count > 0.0) {
      movements[i].movement_g = std::sqrt(std::max(0.0, squares / count - (sum / count).squaredNorm()));
      movements[i].has_signal = frames_.back().time_s - last_usable_s < 0.5;
    }
  }
  return movements;
}

}  // namespace limbwave::ui
