/// Where the sensors of a rig sit on the limbs that hang on one another: the lever arms of the chain-aware smoother.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "body/rig.h"
#include "body/skeleton.h"

namespace limbwave::estimate {

using Eigen::Vector3d;

/// One sensor and the segment that it is worn on. Segments without a sensor are taken to rest against their parents.
struct ChainLink {
  int parent = -1;                   ///< Link of the nearest ancestor that has a sensor, always an earlier one; −1.
  Vector3d p_PL = Vector3d::Zero();  ///< The segment's joint in the parent link's frame, metres.
  Vector3d p_LS = Vector3d::Zero();  ///< The sensor on its segment, metres.
  body::Joint joint;                 ///< Against the parent; spherical without limits where there is none.
  Eigen::Quaterniond R_PL_rest = Eigen::Quaterniond::Identity();  ///< Against the parent link (root: the world).
};

struct LimbChain {
  std::vector<ChainLink> links;  ///< Parents before children.
  std::vector<int> sensors;      ///< Of each link: index into the rig's accelerometers.
  [[nodiscard]] int roots() const;
};

/// Links for all accelerometers that are on a segment of the skeleton, in the order of its segments.
LimbChain limb_chain(const body::Rig& rig, const body::Skeleton& skeleton);

}  // namespace limbwave::estimate
