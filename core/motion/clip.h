/// A clip: keyframed tracks on a skeleton.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "base/result.h"
#include "body/skeleton.h"

namespace limbwave::motion {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// How a track goes from one key to the next. Step holds the earlier key. Linear goes straight, rotations spherically.
/// Cubic passes every key with the mean velocity of its two neighbours (Catmull-Rom; rotations in cumulative Bézier
/// form, Kim, Kim & Shin 1995).
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

  [[nodiscard]] double duration() const;  ///< Time of the last key, seconds; 0 without keys.
};

/// Value of a track at a time, held before the first and after the last key. Rotations: spherical linear along the
/// shorter way. Asserts that the track is not empty.
Quaterniond sample(const RotationTrack& track, double time_s);
Vector3d sample(const PositionTrack& track, double time_s);

/// World poses of all segments at a time.
std::vector<body::SegmentPose> pose_at(const Clip& clip, double time_s);
/// The same into a vector that is used again, so that playing allocates nothing.
void pose_at(const Clip& clip, double time_s, std::vector<body::SegmentPose>& poses);
/// World poses of a skeleton at rest.
std::vector<body::SegmentPose> rest_poses(const body::Skeleton& skeleton);

/// All times at which some track has a key, increasing; times closer than a microsecond count once.
std::vector<double> key_times(const Clip& clip);

/// How many frames of 1/fps fit from 0 to `duration_s`, both ends included. Asserts that fps > 0.
std::size_t frame_count(double duration_s, double fps);

/// The clip with linear keys at multiples of 1/fps, from 0 to its duration. Empty tracks stay empty.
/// Asserts that fps > 0.
Clip resampled(const Clip& clip, double fps);

/// The part from `begin_s` to `end_s`, moved to start at 0. Keys inside stay as they are; the cut ends get a key with
/// the value that was there. Asserts that 0 <= begin_s < end_s.
Clip trimmed(const Clip& clip, double begin_s, double end_s);

/// `first` followed by `second`, which starts one frame (of `first`) after its end. Fails when the skeletons differ in
/// their segments' names or parents; bone lengths and rest are those of `first`.
Result<Clip> concatenated(const Clip& first, const Clip& second);

}  // namespace limbwave::motion
