/// A clip: keyframed tracks on a skeleton, with the meshes that it moves.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "body/skeleton.h"
#include "motion/skinned_mesh.h"
#include "motion/track.h"

namespace limbwave::motion {

/// One animated segment; empty tracks are at rest.
struct JointTracks {
  RotationTrack rotation;  ///< Relative to its parent, including rest (R_PL; root: R_WL).
  /// The joint's place in its parent's frame (p_PL), metres: bones that stretch or slide in imported animation. Always
  /// empty for the root, whose place is `Clip::root_position`.
  PositionTrack position = {};
};

struct Clip {
  std::string name;
  body::Skeleton skeleton;
  double frame_rate_hz = 60.0;      ///< Declared in files; keys need not lie on frames.
  std::vector<JointTracks> joints;  ///< One per segment.
  PositionTrack root_position;      ///< p_W of the root joint, metres; empty = at the root's offset.
  /// What the skeleton moves; shared, so that copies of a clip stay cheap.
  std::vector<std::shared_ptr<const SkinnedMesh>> meshes;

  [[nodiscard]] double duration() const;  ///< Time of the last key, seconds; 0 without keys.
};

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
