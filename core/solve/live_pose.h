/// The causal solver: one acceleration frame in, one pose out. Depends on frames alone, never on how they arrive.
///
/// Frames come two cycles late, because the axes of a cycle are brought to one instant. For the screen the newest
/// cycles count: `ahead` runs copies of the trackers over their first versions and forgets them again.
#pragma once

#include <span>
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

  /// World poses at the last of `frames`, which follow the newest one pushed (FrontEnd::frames_ahead). Changes nothing.
  /// Empty before the first frame was pushed.
  [[nodiscard]] std::vector<body::SegmentPose> ahead(std::span<const decode::AccelerationFrame> frames) const;

  /// Takes effect from the next frame on.
  void set_calibration(calibrate::RigCalibration calibration) { calibration_ = std::move(calibration); }
  void set_headings(std::vector<std::vector<HeadingKey>> headings) { headings_ = std::move(headings); }
  [[nodiscard]] const calibrate::RigCalibration& calibration() const { return calibration_; }

 private:
  // What a frame changes.
  struct State {
    std::vector<estimate::InclinationTracker> trackers;
    std::vector<Eigen::Quaterniond> R_WL;  // without headings
  };
  std::vector<body::SegmentPose> advance(State& state, const decode::AccelerationFrame& frame) const;

  body::LineInSignal signal_;
  body::Skeleton skeleton_;
  calibrate::RigCalibration calibration_;
  std::vector<std::vector<HeadingKey>> headings_;
  std::vector<int> segments_;  // of each sensor
  State state_;
  std::vector<body::SegmentPose> pose_;
};

}  // namespace limbwave::solve
