/// Motion of a tree's links and of points on them, with analytic Jacobians with respect to the joint state.
#pragma once

#include <vector>

#include "body/tree_state.h"

namespace limbwave::body {

/// Motion of one link's frame, all in world coordinates: R_WL, joint's position p, velocity v, acceleration a, angular
/// velocity w and angular acceleration al; those of the frame before the joint with `_before`; S the joint's axes (unit
/// columns; of a hinge the first).
struct LinkMotion {
  Matrix3d R_WL = Matrix3d::Identity();
  Vector3d p = Vector3d::Zero(), v = Vector3d::Zero(), a = Vector3d::Zero();
  Vector3d w = Vector3d::Zero(), al = Vector3d::Zero();
  Vector3d w_before = Vector3d::Zero(), al_before = Vector3d::Zero();
  Matrix3d S = Matrix3d::Zero();
};

using Jacobian = Eigen::Matrix<double, 3, Eigen::Dynamic>;  ///< 3 × degrees of freedom of the chain.

/// Jacobians of one point and of its link's rotation, in world coordinates, with respect to changes of joint state
/// (θ: R exp(δ)), velocity (θ̇) and acceleration (θ̈). Columns are `Tree::chain_dofs(link)`. Not listed, because they
/// are zero or equal: J_v_thetad = J_a_thetadd = J_p_theta and J_w_thetad = J_al_thetadd = J_phi_theta.
struct PointJacobians {
  Jacobian J_phi_theta;  ///< Rotation of the link: R_WL becomes exp(δφ) R_WL.
  Jacobian J_p_theta, J_v_theta, J_a_theta, J_a_thetad;
  Jacobian J_w_theta, J_al_theta, J_al_thetad;
};

/// One forward pass over the tree; Jacobians are closed forms of its results. Re-used without allocation.
class TreeKinematics {
 public:
  explicit TreeKinematics(const Tree& tree);

  /// O(links). `place_scale` multiplies p_PL of a link (bone lengths), one per link, or is empty.
  void update(const TreeState& state, const std::vector<double>& place_scale = {});

  [[nodiscard]] const LinkMotion& link(int index) const { return motion_[static_cast<std::size_t>(index)]; }
  [[nodiscard]] const Tree& tree() const { return *tree_; }

  /// Position, velocity and acceleration of a point fixed on a link, world; p_L in the link's frame.
  struct PointMotion {
    Vector3d p, v, a;
  };
  [[nodiscard]] PointMotion point(int link, const Vector3d& p_L) const;

  /// What is needed of the Jacobians: a rotation rate needs no accelerations, a range only positions.
  enum Need : unsigned { kPosition = 1, kVelocity = 2, kAcceleration = 4, kAngular = 8 };
  void jacobians(int link, const PointMotion& point, unsigned need, PointJacobians& jacobians) const;

  /// Change of a point's position and acceleration when `offset_L`, fixed in the frame of `link`, is added to its way.
  [[nodiscard]] Vector3d offset_acceleration(int link, const Vector3d& offset_W) const {
    const LinkMotion& m = this->link(link);
    return m.al.cross(offset_W) + m.w.cross(m.w.cross(offset_W));
  }

 private:
  const Tree* tree_;
  std::vector<LinkMotion> motion_;
};

}  // namespace limbwave::body
