/// Which parts of a body may stand on the ground.
#pragma once

#include <string>
#include <vector>

#include "estimate/body_model.h"

namespace limbwave::estimate {

/// A part of the sole that may stand.
struct Sole {
  int segment = 0;
  Vector3d p_L = Vector3d::Zero();  ///< Lowest point at rest: the middle of what is about as low.
  Vector3d heel_L = Vector3d::Zero(), toe_L = Vector3d::Zero();  ///< The two ends of that, in either order.
  int board = -1;                                                ///< On the foot; -1: none.
  std::string name;
};

/// The feet of a skeleton: leaves whose lowest point at rest is within 6 cm of the whole body's lowest.
std::vector<Sole> find_soles(const BodyModel& model);

}  // namespace limbwave::estimate
