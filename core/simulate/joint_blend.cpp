#include "simulate/joint_blend.h"

#include <Eigen/LU>
#include <array>
#include <cmath>

#include "geometry/so3.h"

namespace limbwave::simulate {
namespace {

using Angles = std::array<Jet, 2>;

// Angles of a rotation away from rest, with derivatives: ω = S q̇ and dω/dt = S q̈ + dS/dt q̇ in the child's frame.
Angles angles_of(const body::Joint& joint, const Quaterniond& rest, const QuaternionJet& R_PL) {
  const Quaterniond turn = rest.conjugate() * R_PL.v;
  const bool hinge = joint.kind == body::JointKind::kHinge;
  Eigen::Vector2d q(2.0 * std::atan2(turn.vec().dot(joint.axis), turn.w()), 0.0);
  q[0] = std::remainder(q[0], 2.0 * EIGEN_PI);
  const auto columns = [&] {
    Eigen::Matrix<double, 3, 2> S;
    S.col(0) = hinge ? joint.axis : Vector3d(Quaterniond(Eigen::AngleAxisd(-q[1], joint.axis2)) * joint.axis);
    S.col(1) = hinge ? Vector3d::Zero() : joint.axis2;
    return S;
  };
  const auto solve = [&](const Vector3d& w) -> Eigen::Vector2d {
    if (hinge) {
      return Eigen::Vector2d(joint.axis.dot(w), 0.0);
    }
    const Eigen::Matrix<double, 3, 2> S = columns();
    const Eigen::Matrix2d normal = S.transpose() * S + 1e-12 * Eigen::Matrix2d::Identity();
    return Eigen::Vector2d(normal.inverse() * (S.transpose() * w));
  };
  for (int i = 0; !hinge && i < 20; ++i) {
    const Quaterniond reached =
        Quaterniond(Eigen::AngleAxisd(q[0], joint.axis)) * Quaterniond(Eigen::AngleAxisd(q[1], joint.axis2));
    q += solve(geometry::log_so3(reached.conjugate() * turn));
  }
  const Quaterniond back = R_PL.v.conjugate();
  const Eigen::Vector2d qd = solve(2.0 * (back * R_PL.d).vec());
  const Vector3d twisting = hinge ? Vector3d::Zero() : Vector3d(columns().col(0).cross(joint.axis2) * (qd[0] * qd[1]));
  const Eigen::Vector2d qdd = solve(2.0 * (back * R_PL.dd).vec() - twisting);
  return {Jet{q[0], qd[0], qdd[0]}, Jet{q[1], qd[1], qdd[1]}};
}

}  // namespace

QuaternionJet blend(const body::Segment& segment, const QuaternionJet& a, const QuaternionJet& b, const Jet& s) {
  const body::Joint& joint = segment.joint;
  if (segment.parent < 0 || (joint.kind != body::JointKind::kHinge && joint.kind != body::JointKind::kUniversal)) {
    return blend(a, b, s);
  }
  const Angles from = angles_of(joint, segment.R_PL_rest, a);
  const Angles to = angles_of(joint, segment.R_PL_rest, b);
  const auto between = [&](std::size_t k) { return from[k] + s * (to[k] - from[k]); };
  QuaternionJet R;
  R.v = segment.R_PL_rest;
  R = R * rotation(joint.axis, between(0));
  return joint.kind == body::JointKind::kHinge ? R : R * rotation(joint.axis2, between(1));
}

}  // namespace limbwave::simulate
