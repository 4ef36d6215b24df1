/// A body for skeletons that have none.
#pragma once

#include <memory>

#include "motion/skinned_mesh.h"

namespace limbwave::motion {

/// A small figure of rounded limbs, one from every joint to each of its children and along every bone that ends,
/// skinned to the skeleton at rest: a few dozen vertices a bone, smooth at the joints. Programs that make an armature
/// only of bones with a mesh (Unreal, most glTF importers) need one. A skeleton without any length gets one small ball.
/// `along`: the own axis of bones without children that points to their end.
std::shared_ptr<const SkinnedMesh> mannequin(const body::Skeleton& skeleton,
                                             const Eigen::Vector3d& along = Eigen::Vector3d::UnitX());

}  // namespace limbwave::motion
