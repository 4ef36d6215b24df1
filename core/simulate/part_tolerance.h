/// How far a part is from what its data sheet says.
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "simulate/random.h"

namespace limbwave::simulate {

/// Normal with standard deviation `sigma`, within three of them: a part outside would not pass the factory.
inline double drawn(Random& random, double sigma) {
  return sigma * std::clamp(random.normal(), -3.0, 3.0);
}

/// Three of them: x, y, z.
inline Eigen::Vector3d drawn_vector(Random& random, double sigma) {
  const double x = drawn(random, sigma);
  const double y = drawn(random, sigma);
  const double z = drawn(random, sigma);
  return {x, y, z};
}

}  // namespace limbwave::simulate
