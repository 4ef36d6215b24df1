/// How much every sensor moves just now, so that a wizard can say who does. No widgets.
#pragma once

#include <deque>
#include <vector>

#include "calibrate/calibration.h"
#include "decode/slot_alignment.h"

namespace limbwave::ui {

/// One sensor over the newest second.
struct SensorMovement {
  double movement_g = 0.0;                          ///< RMS of specific force about its mean, g.
  bool heard = false;                               ///< There are readings, usable or not.
  bool has_signal = false;                          ///< Readings were usable within the newest half second.
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< Newest usable specific force, m/s², sensor frame.
};

class MovementMeter {
 public:
  static constexpr double kWindowS = 1.0;

  MovementMeter() = default;
  /// `sensors`: indices into the rig's accelerometers; `range` has one entry per accelerometer of the rig.
  MovementMeter(std::vector<int> sensors, const calibrate::RigCalibration& range);

  void push(const decode::AccelerationFrame& frame);
  void clear();
  /// One per sensor given, in that order.
  [[nodiscard]] std::vector<SensorMovement> movements() const;

 private:
  std::vector<int> sensors_;
  std::vector<calibrate::SensorCalibration> calibrations_;
  std::deque<decode::AccelerationFrame> frames_;
};

}  // namespace limbwave::ui
