/// A clip: keyframed tracks on a skeleton.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "body/skeleton.h"

namespace limbwave::motion {

using Eigen::Quaterniond;
using Eigen::Vector3d;

enum class Interpolation { kStep, kLinear, kCubic };

/// Keys of one quantity, times strictly increasing, seconds since the start of the clip.
template <typename T>
struct Track {
  std::vector<double> times;
  std::vector<T> values;
  Interpolation interpolation = Interpolation::kLinear;
  [[nodiscard]] bool empty() const { return times.empty(); }
};

using RotationTrack = Track<Quaterniond>;
using PositionTrack = Track<Vector3d>;

/// One animated segment: rotation relative to its parent including rest (R_PL; root: R_WL), empty = rest.
struct JointTracks {
  RotationTrack rotation;
};

struct Clip {
  std::string name;
  body::Skeleton skeleton;
  double frame_rate_hz = 60.0;      ///< Declared in files; keys need not lie on frames.
  std::vector<JointTracks> joints;  ///< One per segment.
  PositionTrack root_position;      ///< p_W of the root joint, metres; empty = at the root's offset.

  [[nodiscard]] double duration() const;  ///< Time of the last key, seconds.
};

/// Value of a track at a time, held before the first and after the last key. Rotations: spherical linear along the
/// shorter way. Asserts that the track is not empty.
Quaterniond sample(const RotationTrack& track, double time_s);
Vector3d sample(const PositionTrack& track, double time_s);

/// World poses of all segments at a time.
std::vector<body::SegmentPose> pose_at(const Clip& clip, double time_s);

/// The clip with keys at multiples of 1/fps, from 0 to its duration.
Clip resampled(const Clip& clip, double fps);

}  // namespace limbwave::motion
