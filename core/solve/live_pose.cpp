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
      segments_(sensor_segments(rig, skeleton_)),
      R_WL_(skeleton_.segments.size(), Eigen::Quaterniond::Identity()) {
  estimate::InclinationParameters parameters;
  parameters.smoothing_s = settings.smoothing_s;
  trackers_.assign(segments_.size(), estimate::InclinationTracker(settings.smoothing, parameters));
}

void LivePose::push(const decode::AccelerationFrame& frame) {
  std::vector<bool> sensed(skeleton_.segments.size(), false);
  std::vector<Eigen::Quaterniond> R_WL = R_WL_;
  for (std::size_t s = 0; s < segments_.size(); ++s) {
    if (segments_[s] < 0) {
      continue;
    }
    const auto segment = static_cast<std::size_t>(segments_[s]);
    const estimate::ForceSample sample = limb_force(frame, s, signal_, calibration_);
    const estimate::Inclination inclination = trackers_[s].push(sample);
    if (inclination.known) {
      R_WL[segment] = estimate::orientation(inclination.up_L, 0.0, R_WL_[segment]);
      sensed[segment] = true;
    }
  }
  R_WL_ = R_WL;
  for (std::size_t i = 0; i < R_WL.size(); ++i) {
    const body::Segment& segment = skeleton_.segments[i];
    if (sensed[i]) {
      const double heading = i < headings_.size() ? heading_at(headings_[i], frame.time_s) : 0.0;
      R_WL[i] = Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()) * R_WL[i];
    } else if (segment.parent >= 0) {
      R_WL[i] = R_WL[static_cast<std::size_t>(segment.parent)] * segment.R_PL_rest;
    } else {
      R_WL[i] = segment.R_PL_rest;
    }
  }
  pose_ = body::poses_from_orientations(skeleton_, R_WL, skeleton_.segments.front().p_PL);
}

}  // namespace limbwave::solve
