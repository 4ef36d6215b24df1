/// How a whole body in a BVH file becomes the segments of the skeleton "body".
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "body/skeleton.h"

namespace limbwave::simulate {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// Usual names of a body segment's joint in files (CMU, Mixamo, Blender, BVH conventions), letters and digits only, in
/// order of preference; empty for a segment that "body" does not have.
std::vector<std::string> usual_body_joints(const std::string& segment);

/// Whether a segment's x axis follows the file's bone at rest (limbs), or its frame the upright figure (trunk, feet).
bool follows_bone(const std::string& segment);

/// Local rotations R_PL of one frame, parents first, brought to what the joints of the skeleton can do: hinges and
/// universal joints take the nearest angles, and what hangs on them makes up for the difference as far as its own joint
/// lets it. `R_PL` holds the wanted rotations; `angles` those of the frame before, two per segment.
void project_on_joints(const body::Skeleton& skeleton, std::vector<Quaterniond>& R_PL,
                       std::vector<Eigen::Vector2d>& angles);

}  // namespace limbwave::simulate
