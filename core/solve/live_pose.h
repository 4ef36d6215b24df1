/// The causal solver: one acceleration frame in, one pose out. Depends on frames alone, never on how they arrive.
#pragma once

#include <vector>

#include "body/rig.h"
#include "body/skeleton.h"
#include "calibrate/calibration.h"
#include "decode/slot_alignment.h"
#include "estimate/inclination_tracker.h"
#include "solve/solve.h"

namespace limbwave::solve {

class LivePose {
 public:
  LivePose(const body::Rig& rig, body::Skeleton skeleton, calibrate::RigCalibration calibration,
           const SolveSettings& settings);

  /// Advances by one frame; frames in order of time.
  void push(const decode::AccelerationFrame& frame);

  /// World poses of all segments after the newest frame; empty before the first.
  [[nodiscard]] const std::vector<body::SegmentPose>& pose() const { return pose_; }

  /// Takes effect from the next frame on.
  void set_calibration(calibrate::RigCalibration calibration) { calibration_ = std::move(calibration); }
  void set_headings(std::vector<std::vector<HeadingKey>> headings) { headings_ = std::move(headings); }
  [[nodiscard]] const calibrate::RigCalibration& calibration() const { return calibration_; }

 private:
  body::Skeleton skeleton_;
  calibrate::RigCalibration calibration_;
  std::vector<std::vector<HeadingKey>> headings_;
  std::vector<int> segments_;  // of each sensor
  std::vector<estimate::InclinationTracker> trackers_;
  std::vector<Eigen::Quaterniond> R_WL_;
  std::vector<body::SegmentPose> pose_;
};

}  // namespace limbwave::solve
