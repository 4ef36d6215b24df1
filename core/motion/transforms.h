/// Clips said in another way, for programs that expect it: the poses in the world stay what they were unless stated.
#pragma once

#include <string>
#include <vector>

#include "motion/clip.h"

namespace limbwave::motion {

/// The clip with another rest pose: `R_WL` is every segment's new world orientation at rest, joints stay where their
/// parents carry them. Movement, and meshes under it, stay. Asserts one orientation per segment.
Clip with_rest(Clip clip, const std::vector<Quaterniond>& R_WL);

/// The clip with turned bone frames: `R_LN[i]` is the new frame N of segment i seen in its present frame L, constant.
/// Joint axes turn with it; `Segment::length` afterwards is along N's image of x, no more along N's x. Joint limits
/// keep their numbers and so lose their meaning; they are set to free. Asserts one rotation per segment.
Clip with_bone_frames(Clip clip, const std::vector<Quaterniond>& R_LN);

/// The clip whose rest pose stands with its lowest joint or bone end at world z `height`, metres.
Clip with_rest_height(Clip clip, double height);

/// A segment `name` in front of all others, at the world's origin and never turning: the old root hangs on it and
/// takes `Clip::root_position` along as its own position.
Clip with_root_bone(Clip clip, const std::string& name);

/// Where the way over the floor (world x and y) goes.
enum class RootMotion {
  kFree,     ///< It stays where it is.
  kInPlace,  ///< Taken out: the root joint stays above the place where it is in the first frame.
  kOnRoot,   ///< On segment 0, which with_root_bone made; the hips keep height only.
};

/// Moves or removes the way over the floor. kOnRoot asserts that segment 0 has one child and no length.
Clip with_root_motion(Clip clip, RootMotion motion);

/// One more frame in front that shows the rest pose with the root joint at `root_p_W`; the clip itself starts one frame
/// (1 / frame_rate_hz) later. Without blending: the first frame holds until the second.
Clip with_rest_frame(Clip clip, const Vector3d& root_p_W);

/// The clip with cubic pieces as straight lines from frame to frame (of `frame_rate_hz`), for programs that show cubic
/// keys in another way. All keys stay; steps stay steps.
Clip with_straight_pieces(Clip clip);

/// The clip with meshes moved to where the rest pose has their bones, where that is possible without bending them: the
/// pose in which they were bound is the rest pose in another place. They then count as bound at rest.
Clip with_meshes_at_rest(Clip clip);

/// All segments' direction towards the mean of their children's joints, in their own frame, unit length; leaves and
/// coincident joints: x, the bone axis of L.
std::vector<Vector3d> bone_directions(const body::Skeleton& skeleton);

/// Lowest world z of all joints and bone ends at rest, metres.
double lowest_point_at_rest(const body::Skeleton& skeleton);

}  // namespace limbwave::motion
