#include "solve/live_pose.h"

#include "solve/compose.h"
#include "solve/limb_forces.h"

namespace limbwave::solve {

LivePose::LivePose(const body::Rig& rig, body::Skeleton skeleton, calibrate::RigCalibration calibration,
                   const SolveSettings& settings)
    : signal_(rig.line_in),
      skeleton_(std::move(skeleton)),
      calibration_(std::move(calibration)),
      headings_(settings.headings),
      segments_(sensor_segments(rig, skeleton_)) {
  estimate::InclinationParameters parameters;
  parameters.smoothing_s = settings.smoothing_s;
  state_.R_WL.assign(skeleton_.segments.size(), Eigen::Quaterniond::Identity());
  state_.trackers.assign(segments_.size(), estimate::InclinationTracker(settings.smoothing, parameters));
}

void LivePose::push(const decode::AccelerationFrame& frame) {
  pose_ = advance(state_, frame);
}

std::vector<body::SegmentPose> LivePose::ahead(std::span<const decode::AccelerationFrame> frames) const {
  std::vector<body::SegmentPose> pose = pose_;
  if (!pose.empty() && !frames.empty()) {
    State state = state_;
    for (const decode::AccelerationFrame& frame : frames) {
      pose = advance(state, frame);
    }
  }
  return pose;
}

std::vector<body::SegmentPose> LivePose::advance(State& state, const decode::AccelerationFrame& frame) const {
  std::vector<bool> sensed(skeleton_.segments.size(), false);
  for (std::size_t s = 0; s < segments_.size(); ++s) {
    if (segments_[s] < 0) {
      continue;
    }
    const auto segment = static_cast<std::size_t>(segments_[s]);
    const estimate::ForceSample sample = limb_force(frame, s, signal_, calibration_);
    const estimate::Inclination inclination = state.trackers[s].push(sample);
    if (inclination.known) {
      state.R_WL[segment] = estimate::orientation(inclination.up_L, 0.0, state.R_WL[segment]);
      sensed[segment] = true;
    }
  }
  std::vector<Eigen::Quaterniond> R_WL;
  set_orientations(skeleton_, sensed, state.R_WL, headings_, frame.time_s, R_WL);
  return body::poses_from_orientations(skeleton_, R_WL, skeleton_.segments.front().p_PL);
}

}  // namespace limbwave::solve
