#include "workspaces/solve/solve_pose.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/units.h"
#include "solve/compose.h"

namespace limbwave::ui {

namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

Vector3d root_position(const motion::Clip& clip, double time_s) {
  return clip.root_position.empty() ? clip.skeleton.segments.front().p_PL : motion::sample(clip.root_position, time_s);
}

}  // namespace

void edited_pose(const motion::Clip& clip, const body::Skeleton& skeleton, const std::vector<bool>& has_sensor,
                 const HeadingChange& change, double time_s, std::vector<body::SegmentPose>& poses) {
  motion::pose_at(clip, time_s, poses);
  assert(poses.size() == skeleton.segments.size() && has_sensor.size() == poses.size());
  std::vector<double> turns(poses.size());
  std::vector<Quaterniond> R_WL(poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    turns[i] = has_sensor[i] ? change(static_cast<int>(i), time_s) : 0.0;
    R_WL[i] = poses[i].R_WL;
  }
  solve::turn_segments(skeleton, has_sensor, turns, R_WL);
  poses = body::poses_from_orientations(skeleton, R_WL, root_position(clip, time_s));
}

std::vector<bool> segments_with_sensors(const body::Rig& rig, const body::Skeleton& skeleton) {
  std::vector<bool> sensed(skeleton.segments.size(), false);
  for (const body::Accelerometer& sensor : rig.accelerometers) {
    const int segment = skeleton.find(sensor.segment);
    if (segment >= 0) {
      sensed[static_cast<std::size_t>(segment)] = true;
    }
  }
  return sensed;
}

std::vector<body::SegmentPose> truth_pose(const evaluate::Truth& truth, const body::Skeleton& skeleton,
                                          double take_time_s) {
  if (truth.segments.empty()) {
    return {};
  }
  std::vector<body::SegmentPose> poses = motion::rest_poses(skeleton);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const body::Segment& segment = skeleton.segments[i];
    const auto known = std::find_if(truth.segments.begin(), truth.segments.end(),
                                    [&](const auto& one) { return one.name == segment.name && !one.times.empty(); });
    if (segment.parent >= 0) {
      const body::SegmentPose& parent = poses[static_cast<std::size_t>(segment.parent)];
      poses[i] = {parent.R_WL * segment.R_PL_rest, parent.p_WL + parent.R_WL * segment.p_PL};
    }
    if (known == truth.segments.end()) {
      continue;
    }
    const auto after = std::upper_bound(known->times.begin(), known->times.end(), take_time_s);
    const auto b = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
        after - known->times.begin(), 0, static_cast<std::ptrdiff_t>(known->times.size()) - 1));
    const std::size_t a = b > 0 ? b - 1 : 0;
    const double span = known->times[b] - known->times[a];
    const double part = span > 0.0 ? std::clamp((take_time_s - known->times[a]) / span, 0.0, 1.0) : 0.0;
    poses[i].R_WL = known->R_WL[a].slerp(part, known->R_WL[b]);
    const Vector3d position = known->p_WL[a] + part * (known->p_WL[b] - known->p_WL[a]);
    if (position.allFinite()) {
      poses[i].p_WL = position;
    }
  }
  return poses;
}

std::vector<Vector3d> motion_extent(const motion::Clip& clip, int instants) {
  assert(instants > 1);
  std::vector<Vector3d> points;
  std::vector<body::SegmentPose> poses;
  for (int i = 0; i < instants; ++i) {
    motion::pose_at(clip, clip.duration() * i / (instants - 1), poses);
    for (std::size_t s = 0; s < poses.size(); ++s) {
      points.push_back(poses[s].p_WL);
      points.emplace_back(poses[s].p_WL + poses[s].R_WL * Vector3d(clip.skeleton.segments[s].length, 0, 0));
    }
  }
  return points;
}

std::vector<Vector3d> reach_extent(const body::Skeleton& skeleton) {
  std::vector<Vector3d> points;
  if (skeleton.segments.empty()) {
    return points;
  }
  const std::vector<body::SegmentPose> rest = motion::rest_poses(skeleton);
  std::vector<double> reach;
  for (const body::Segment& segment : skeleton.segments) {
    reach.push_back(segment.length);
  }
  bool alone = true;
  for (std::size_t i = skeleton.segments.size(); i-- > 1;) {  // Children come after their parents.
    const body::Segment& segment = skeleton.segments[i];
    const auto parent = static_cast<std::size_t>(segment.parent);
    reach[parent] = std::max(reach[parent], segment.p_PL.norm() + reach[i]);
  }
  const auto sphere = [&](const Vector3d& centre, double radius) {
    for (int axis = 0; axis < 3; ++axis) {
      points.emplace_back(centre + radius * Vector3d::Unit(axis));
      points.emplace_back(centre - radius * Vector3d::Unit(axis));
    }
  };
  for (std::size_t i = 1; i < skeleton.segments.size(); ++i) {
    if (skeleton.segments[i].parent == 0) {
      sphere(rest[i].p_WL, reach[i]);
      alone = false;
    }
  }
  if (alone) {
    sphere(rest[0].p_WL, reach[0]);
  }
  points.push_back(rest[0].p_WL);
  points.emplace_back(rest[0].p_WL + rest[0].R_WL * Vector3d(skeleton.segments[0].length, 0, 0));
  return points;
}

std::vector<std::vector<float>> elevations(const motion::Clip& clip, const std::vector<int>& segments) {
  std::vector<std::vector<float>> lists(segments.size());
  if (clip.joints.empty()) {
    return lists;
  }
  std::vector<body::SegmentPose> poses;
  for (const double time : clip.joints.front().rotation.times) {
    motion::pose_at(clip, time, poses);
    for (std::size_t k = 0; k < segments.size(); ++k) {
      float value = std::nanf("");
      if (segments[k] >= 0 && static_cast<std::size_t>(segments[k]) < poses.size()) {
        const Vector3d along = poses[static_cast<std::size_t>(segments[k])].R_WL * Vector3d::UnitX();
        value = static_cast<float>(degrees(std::asin(std::clamp(along.z(), -1.0, 1.0))));
      }
      lists[k].push_back(value);
    }
  }
  return lists;
}

}  // namespace limbwave::ui
