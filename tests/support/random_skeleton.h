/// Skeletons of random shape with joints of every kind, and random states of motion.
#pragma once

#include <random>
#include <string>

#include "body/tree_state.h"
#include "geometry/so3.h"

namespace limbwave::testing_support {

inline Eigen::Vector3d random_vector(std::mt19937& random, double size) {
  std::normal_distribution<double> normal;
  return size * Eigen::Vector3d(normal(random), normal(random), normal(random));
}

inline body::Skeleton random_skeleton(std::mt19937& random, int segments) {
  body::Skeleton skeleton;
  skeleton.name = "random";
  for (int i = 0; i < segments; ++i) {
    body::Segment segment;
    segment.name = "s" + std::to_string(i);
    segment.parent =
        i == 0 ? -1 : static_cast<int>(std::uniform_int_distribution<int>(std::max(0, i - 4), i - 1)(random));
    segment.joint.kind = static_cast<body::JointKind>(std::uniform_int_distribution<int>(0, 3)(random));
    segment.joint.axis = random_vector(random, 1.0).normalized();
    segment.joint.axis2 = segment.joint.axis.cross(random_vector(random, 1.0)).normalized();
    segment.p_PL = random_vector(random, 0.2);
    segment.R_PL_rest = geometry::exp_so3(random_vector(random, 1.0));
    segment.length = 0.3;
    skeleton.segments.push_back(segment);
  }
  return skeleton;
}

inline body::TreeState random_state(std::mt19937& random, const body::Tree& tree) {
  std::normal_distribution<double> normal;
  body::TreeState state = tree.rest();
  body::VectorXd delta(tree.dofs());
  for (int i = 0; i < tree.dofs(); ++i) {
    delta[i] = 0.8 * normal(random);
    state.qd[i] = 2.0 * normal(random);
    state.qdd[i] = 8.0 * normal(random);
  }
  tree.add(state, delta);
  return state;
}

}  // namespace limbwave::testing_support
