/// What joints let a microphone do before a source.
#pragma once

#include <Eigen/Core>

#include "body/skeleton.h"

namespace limbwave::solve {

struct PairReach {
  double farthest = 0.0;  ///< Metres from each other, at most.
  double foremost = 0.0;  ///< The smallest angle off the source's normal, radians, 0 to pi.
};

/// Of a source at `p_LS` on segment `s`, with its normal, and a microphone at `p_LM` on segment `m`, both in their
/// segments' frames. Over all poses within the limits of the joints between, some degrees more; sampled, the same ones
/// every time. Where more than two joints are between, bones stretched in one line and any angle.
PairReach pair_reach(const body::Skeleton& skeleton, int s, const Eigen::Vector3d& p_LS,
                     const Eigen::Vector3d& normal_L, int m, const Eigen::Vector3d& p_LM);

}  // namespace limbwave::solve
