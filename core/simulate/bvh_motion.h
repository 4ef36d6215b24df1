/// Motions out of BVH files, put on a skeleton by the names of the joints.
#pragma once

#include <filesystem>
#include <memory>

#include "base/result.h"
#include "body/skeleton.h"
#include "simulate/motions.h"

namespace limbwave::simulate {

/// Reads any BVH and puts it on `skeleton`, whose own lengths count: only orientations and the root's path are taken.
/// - Joints are found by the segments' own names or, for the segments of "arm", by the usual names of a right arm
///   (CMU, Mixamo, Blender, BVH conventions). Segments without a joint stay at rest. None found is an error.
/// - The unit of the root's path is guessed from the size of the figure unless `metres_per_unit` > 0.
/// - Artificial frames at the start, single-frame spikes and stretches in which joints jump are bridged; everything
///   above 6 to 12 Hz is filtered off, because optical noise would become accelerations that no limb has.
/// - The path starts at the skeleton's place, facing +x.
Result<std::shared_ptr<const BodyMotion>> load_bvh_motion(const std::filesystem::path& path,
                                                          const body::Skeleton& skeleton, double metres_per_unit);

}  // namespace limbwave::simulate
