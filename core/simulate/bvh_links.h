/// Which joints of a BVH file move which segments of a skeleton.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "body/skeleton.h"

namespace limbwave::simulate {

using Eigen::Quaterniond;

/// The joint of the file that moves a segment, and the segment's frame in the joint's frame, which at rest is the
/// world's (z up).
struct BvhLink {
  int joint = -1;  ///< -1: none, the segment stays at rest.
  Quaterniond R_JL = Quaterniond::Identity();
};

/// One link for each segment of `skeleton`: by the segments' own names where all are there, else by the usual names of
/// a whole body's joints or of a right arm's. `file` is the skeleton as it was read, whose frames at rest are the
/// world's. Limbs that the file's figure holds elsewhere at rest are taken there by the shortest way.
std::vector<BvhLink> link_segments(const body::Skeleton& skeleton, const body::Skeleton& file);

}  // namespace limbwave::simulate
