/// A skeleton: rigid segments in a tree, each hanging on its parent by a joint. Read from resources/skeletons/*.json
/// or from a take's snapshot; the schema is in resources/skeletons/README.md.
#pragma once

#include <Eigen/Geometry>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace limbwave::body {

using Eigen::Quaterniond;
using Eigen::Vector3d;

enum class JointKind { kFixed, kHinge, kUniversal, kSpherical };

/// A joint between a segment and its parent (or the world, for the root).
struct Joint {
  JointKind kind = JointKind::kSpherical;
  Vector3d axis = Vector3d::UnitY();   ///< Hinge axis, or first universal axis, in the child's rest frame; unit length.
  Vector3d axis2 = Vector3d::UnitZ();  ///< Second universal axis.
  /// Limits in radians of the rotation vector's components (spherical) or about each axis; min <= max.
  Vector3d minimum = Vector3d::Constant(-3.1416);
  Vector3d maximum = Vector3d::Constant(3.1416);
};

/// Flesh that sound does not pass: all points within `radius` of the line from one point to the other.
struct Capsule {
  Vector3d from_L = Vector3d::Zero(), to_L = Vector3d::Zero();  ///< In the segment's frame, metres.
  double radius = 0.0;                                          ///< Metres, > 0.
};

/// One rigid segment (bone). Frame L: origin at its joint, x along the bone.
struct Segment {
  std::string name;  ///< Unique within the skeleton.
  int parent = -1;   ///< Index of the parent, always smaller than the own one; -1 for the root.
  Joint joint;
  Vector3d p_PL = Vector3d::Zero();                 ///< Joint's position in the parent's frame, metres.
  Quaterniond R_PL_rest = Quaterniond::Identity();  ///< Rest orientation relative to the parent (root: to the world).
  double length = 0.0;                              ///< Metres, along x; >= 0.
  std::vector<Capsule> capsules;                    ///< Its flesh; empty where it does not matter.
};

struct Skeleton {
  std::string name;
  double height = 0.0;            ///< Of the subject that the lengths are for, metres; 0 when it has no meaning.
  std::vector<Segment> segments;  ///< Parents before children; exactly one root, at index 0.

  [[nodiscard]] int find(std::string_view segment) const;  ///< Index, or -1.
};

/// The file or snapshot form. Errors name `place` and the path of the key.
Result<Skeleton> skeleton_from_json(const nlohmann::json& json, const std::string& place);
nlohmann::json skeleton_to_json(const Skeleton& skeleton);

/// A shipped skeleton by name ("arm") or a file by path.
Result<Skeleton> load_skeleton(const std::string& name_or_path);
std::vector<std::string> shipped_skeletons();

/// Poses of all segments in the world, same order as `skeleton.segments`.
struct SegmentPose {
  Quaterniond R_WL = Quaterniond::Identity();
  Vector3d p_WL = Vector3d::Zero();
};

/// Positions from world orientations: roots at `root_p_W`, every child at its parent's joint (line-in paper §5).
std::vector<SegmentPose> poses_from_orientations(const Skeleton& skeleton, const std::vector<Quaterniond>& R_WL,
                                                 const Vector3d& root_p_W);

/// World poses when every joint has the rotation `R_joint` away from rest: R_WL = R_WP · R_PL_rest · R_joint.
std::vector<SegmentPose> poses_from_joints(const Skeleton& skeleton, const std::vector<Quaterniond>& R_joint,
                                           const Vector3d& root_p_W);

/// Number of angles of a joint: 0 (fixed) to 3 (spherical).
std::size_t degrees_of_freedom(JointKind kind);

/// Scales all lengths, offsets and capsules by `height / skeleton.height`. Asserts that both are positive.
Skeleton scaled_to_height(const Skeleton& skeleton, double height);

/// Sets one segment's length, moving the children that hang on its end along.
Skeleton with_length(Skeleton skeleton, int segment, double length);

}  // namespace limbwave::body
