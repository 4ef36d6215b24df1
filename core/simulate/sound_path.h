/// How sound gets from a source to a microphone: straight, past limbs, off the floor and walls.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "body/skeleton.h"

namespace limbwave::simulate {

using Eigen::Vector3d;

/// A capsule in the world.
struct WorldCapsule {
  Vector3d a, b;
  double radius = 0.0;
};

/// How far a line of sight passes by an obstacle: `clearance` is negative where it is cut.
struct Passage {
  double clearance = 0.0;
  double along = 0.0;  ///< 0..1, where on the way.
};

/// Nearest approach of the line from p to q to a capsule's surface.
Passage passage(const Vector3d& p, const Vector3d& q, const WorldCapsule& capsule);

/// Loss of a knife edge (ITU-R P.526, equation 31) that reaches `depth` metres into the line between two points d1 and
/// d2 away, decibels >= 0.
double knife_edge_loss_db(double depth, double d1, double d2, double wavelength);

/// What the body does to sound between two points.
struct Shade {
  double loss_db = 0.0;  ///< Sum over limbs, at most 60.
  double detour = 0.0;   ///< How much longer the way round the worst limb is, metres.
};
Shade shade(const Vector3d& p, const Vector3d& q, const std::vector<WorldCapsule>& capsules, double wavelength);

/// A plane that reflects: points x with normal · x = offset; sound is on the normal's side.
struct Mirror {
  Vector3d normal;
  double offset = 0.0;
  double reflection = 0.0;  ///< Of amplitudes.
  [[nodiscard]] Vector3d image(const Vector3d& p) const { return p - 2.0 * (normal.dot(p) - offset) * normal; }
  [[nodiscard]] double height(const Vector3d& p) const { return normal.dot(p) - offset; }
};

}  // namespace limbwave::simulate
