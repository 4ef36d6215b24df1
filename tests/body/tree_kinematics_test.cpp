#include "body/tree_kinematics.h"

#include <gtest/gtest.h>

#include <functional>

#include "support/random_skeleton.h"

namespace limbwave::body {
namespace {

using testing_support::random_skeleton;
using testing_support::random_state;
using testing_support::random_vector;

// What a point does: p, v, a, ω, α stacked.
using Motion = Eigen::Matrix<double, 15, 1>;

Motion motion_of(const Tree& tree, const TreeState& state, int link, const Vector3d& p_L) {
  TreeKinematics kinematics(tree);
  kinematics.update(state);
  const auto point = kinematics.point(link, p_L);
  Motion m;
  m << point.p, point.v, point.a, kinematics.link(link).w, kinematics.link(link).al;
  return m;
}

// Central difference, Richardson-extrapolated.
template <typename F>
auto derivative(const F& f, double h) {
  using T = decltype(f(h));
  const T wide = (f(h) - f(-h)) / (2 * h);
  const T narrow = (f(0.5 * h) - f(-0.5 * h)) / h;
  return T((4.0 * narrow - wide) / 3.0);
}

enum class Level { kState, kVelocity, kAcceleration };

TreeState changed(const Tree& tree, TreeState state, Level level, int dof, double by) {
  if (level == Level::kVelocity) {
    state.qd[dof] += by;
  } else if (level == Level::kAcceleration) {
    state.qdd[dof] += by;
  } else {
    VectorXd delta = VectorXd::Zero(tree.dofs());
    delta[dof] = by;
    tree.add(state, delta);
  }
  return state;
}

class RandomTrees : public testing::TestWithParam<int> {};

TEST_P(RandomTrees, JacobiansAgreeWithNumericalOnes) {
  std::mt19937 random(static_cast<unsigned>(GetParam()));
  const Skeleton skeleton = random_skeleton(random, 2 + GetParam() % 9);
  for (const RootMotion root : {RootMotion::kJoint, RootMotion::kFree}) {
    const Tree tree(skeleton, root);
    const TreeState state = random_state(random, tree);
    TreeKinematics kinematics(tree);
    kinematics.update(state);
    for (int segment = 0; segment < tree.segments(); ++segment) {
      const int link = tree.link_of(segment);
      const Vector3d p_L = random_vector(random, 0.2);
      PointJacobians j;
      kinematics.jacobians(link, kinematics.point(link, p_L), 15U, j);
      const Matrix3d R = kinematics.link(link).R_WL;
      for (std::size_t c = 0; c < tree.chain_dofs(link).size(); ++c) {
        const int dof = tree.chain_dofs(link)[c];
        const auto column = static_cast<Eigen::Index>(c);
        const auto numerical = [&](Level level) {
          return derivative([&](double h) { return motion_of(tree, changed(tree, state, level, dof, h), link, p_L); },
                            2e-3);
        };
        Motion expected;
        expected << j.J_p_theta.col(column), j.J_v_theta.col(column), j.J_a_theta.col(column), j.J_w_theta.col(column),
            j.J_al_theta.col(column);
        const double scale = 1.0 + expected.norm();
        EXPECT_LT((numerical(Level::kState) - expected).norm(), 1e-8 * scale);
        expected << Vector3d::Zero(), j.J_p_theta.col(column), j.J_a_thetad.col(column), j.J_phi_theta.col(column),
            j.J_al_thetad.col(column);
        EXPECT_LT((numerical(Level::kVelocity) - expected).norm(), 1e-8 * scale);
        expected << Vector3d::Zero(), Vector3d::Zero(), j.J_p_theta.col(column), Vector3d::Zero(),
            j.J_phi_theta.col(column);
        EXPECT_LT((numerical(Level::kAcceleration) - expected).norm(), 1e-8 * scale);
        const auto turn = derivative(
            [&](double h) {
              TreeKinematics k(tree);
              k.update(changed(tree, state, Level::kState, dof, h));
              return geometry::log_so3(Quaterniond(k.link(link).R_WL * R.transpose()));
            },
            2e-3);
        EXPECT_LT((turn - j.J_phi_theta.col(column)).norm(), 1e-8);
      }
    }
  }
}

// The joint state moved on in time, exact to the third order for ball joints.
TreeState after(const Tree& tree, TreeState state, double h) {
  VectorXd delta = h * state.qd + 0.5 * h * h * state.qdd;
  for (const TreeLink& link : tree.links()) {
    if (link.kind == LinkKind::kBall) {
      const Vector3d w = state.qd.segment<3>(link.first);
      const Vector3d al = state.qdd.segment<3>(link.first);
      delta.segment<3>(link.first) += h * h * h / 12.0 * w.cross(al);
    }
  }
  tree.add(state, delta);
  state.qd += h * state.qdd;
  return state;
}

TEST_P(RandomTrees, VelocitiesAndAccelerationsAreDerivativesByTime) {
  std::mt19937 random(static_cast<unsigned>(100 + GetParam()));
  const Skeleton skeleton = random_skeleton(random, 2 + GetParam() % 9);
  const Tree tree(skeleton, RootMotion::kFree);
  const TreeState state = random_state(random, tree);
  for (int segment = 0; segment < tree.segments(); ++segment) {
    const int link = tree.link_of(segment);
    const Vector3d p_L = random_vector(random, 0.2);
    const Motion at = motion_of(tree, state, link, p_L);
    const Motion rate = derivative([&](double h) { return motion_of(tree, after(tree, state, h), link, p_L); }, 1e-3);
    EXPECT_LT((rate.segment<3>(0) - at.segment<3>(3)).norm(), 1e-7 * (1 + at.norm()));
    EXPECT_LT((rate.segment<3>(3) - at.segment<3>(6)).norm(), 1e-7 * (1 + at.norm()));
    EXPECT_LT((rate.segment<3>(9) - at.segment<3>(12)).norm(), 1e-7 * (1 + at.norm()));
  }
}

TEST_P(RandomTrees, AgreesWithThePosesOfTheSkeleton) {
  std::mt19937 random(static_cast<unsigned>(200 + GetParam()));
  const Skeleton skeleton = random_skeleton(random, 2 + GetParam() % 9);
  for (const RootMotion root : {RootMotion::kJoint, RootMotion::kFree}) {
    const Tree tree(skeleton, root);
    const TreeState state = random_state(random, tree);
    TreeKinematics kinematics(tree);
    kinematics.update(state);
    const auto poses = poses_from_joints(skeleton, tree.segment_rotations(state), tree.root_position(state));
    for (int segment = 0; segment < tree.segments(); ++segment) {
      const LinkMotion& m = kinematics.link(tree.link_of(segment));
      EXPECT_LT((m.p - poses[static_cast<std::size_t>(segment)].p_WL).norm(), 1e-12);
      EXPECT_LT((m.R_WL - poses[static_cast<std::size_t>(segment)].R_WL.toRotationMatrix()).norm(), 1e-12);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomTrees, testing::Range(0, 24));

TEST(TreeState, AddAndDifferenceAreInverse) {
  std::mt19937 random(7);
  const Skeleton skeleton = random_skeleton(random, 12);
  const Tree tree(skeleton, RootMotion::kFree);
  const TreeState a = random_state(random, tree);
  TreeState b = a;
  const VectorXd delta = 0.3 * VectorXd::Random(tree.dofs());
  tree.add(b, delta);
  EXPECT_LT((tree.difference(a, b) - delta).norm(), 1e-12);
}

TEST(TreeState, NearestAnglesFindTheAnglesOfAUniversalJoint) {
  const Vector3d a1(0, -1, 0);
  const Vector3d a2(1, 0, 0);
  for (const Eigen::Vector2d& q : {Eigen::Vector2d(0.4, -1.2), Eigen::Vector2d(2.2, 0.3), Eigen::Vector2d(-0.1, 1.5)}) {
    const Quaterniond R = Quaterniond(Eigen::AngleAxisd(q[0], a1)) * Quaterniond(Eigen::AngleAxisd(q[1], a2));
    EXPECT_LT((nearest_angles(R, a1, a2, {0.6 * q[0], 0.6 * q[1]}) - q).norm(), 1e-9);
  }
  const Quaterniond R(Eigen::AngleAxisd(3.5, a1));
  EXPECT_NEAR(nearest_angles(R, a1, Vector3d::Zero(), {3.0, 0.0})[0], 3.5, 1e-12);
}

}  // namespace
}  // namespace limbwave::body
