#include "simulate/joint_blend.h"

#include <gtest/gtest.h>

#include <random>

#include "geometry/so3.h"

namespace limbwave::simulate {
namespace {

// A joint that turns at constant acceleration of its angles.
QuaternionJet turned(const body::Segment& segment, const Eigen::Matrix<double, 3, 2>& q, double t) {
  QuaternionJet R;
  R.v = segment.R_PL_rest;
  const auto angle = [&](int k) {
    return Jet{q(0, k) + q(1, k) * t + 0.5 * q(2, k) * t * t, q(1, k) + q(2, k) * t, q(2, k)};
  };
  R = R * rotation(segment.joint.axis, angle(0));
  return segment.joint.kind == body::JointKind::kHinge ? R : R * rotation(segment.joint.axis2, angle(1));
}

class JointBlend : public testing::TestWithParam<body::JointKind> {};

TEST_P(JointBlend, KeepsToTheAxesAndItsDerivativesAreTrue) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (int run = 0; run < 20; ++run) {
    body::Segment segment;
    segment.parent = 0;
    segment.joint.kind = GetParam();
    const auto axis = [&] { return Vector3d(normal(random), normal(random), normal(random)).normalized(); };
    segment.joint.axis = axis();
    segment.joint.axis2 = segment.joint.axis.cross(axis()).normalized();
    segment.R_PL_rest = geometry::exp_so3(axis());
    Eigen::Matrix<double, 3, 2> from;
    Eigen::Matrix<double, 3, 2> to;
    for (int r = 0; r < 3; ++r) {
      from.row(r) << 0.6 * normal(random), 0.4 * normal(random);
      to.row(r) << 0.6 * normal(random), 0.4 * normal(random);
    }
    const auto at = [&](double t) {
      return blend(segment, turned(segment, from, t), turned(segment, to, t), smooth_step(t, -0.5, 1.0));
    };
    const double h = 1e-4;
    const QuaternionJet q = at(0.1);
    const QuaternionJet before = at(0.1 - h);
    const QuaternionJet after = at(0.1 + h);
    EXPECT_LT(((after.v.coeffs() - before.v.coeffs()) / (2 * h) - q.d.coeffs()).norm(), 1e-5);
    EXPECT_LT(((after.d.coeffs() - before.d.coeffs()) / (2 * h) - q.dd.coeffs()).norm(), 1e-4);
    // The angular velocity lies in the plane of the axes.
    const Vector3d w = 2.0 * (q.v.conjugate() * q.d).vec();
    const Quaterniond turn = segment.R_PL_rest.conjugate() * q.v;
    if (GetParam() == body::JointKind::kHinge) {
      EXPECT_LT(turn.vec().cross(segment.joint.axis).norm(), 1e-9);
      EXPECT_LT(w.cross(segment.joint.axis).norm(), 1e-9);
    } else {
      // What turns axis 1 into the child's frame leaves it in the plane across axis 2 that it started in.
      const Vector3d axis_L = turn.conjugate() * segment.joint.axis;
      EXPECT_LT(std::abs(axis_L.dot(segment.joint.axis2)), 1e-9);
      EXPECT_LT(std::abs(w.dot(axis_L.cross(segment.joint.axis2))), 1e-9);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, JointBlend, testing::Values(body::JointKind::kHinge, body::JointKind::kUniversal));

}  // namespace
}  // namespace limbwave::simulate
