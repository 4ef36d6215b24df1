/// How far a joint is from what it can do, as residuals: what tells the chain-aware smoother about headings, which
/// gravity does not.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "body/skeleton.h"

namespace limbwave::estimate {

struct JointResidual {
  double value = 0.0;                                  ///< In standard deviations.
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();  ///< By a small turn d: R → exp(d) R, per radian.
};

/// Residuals of `R`, the joint's rotation away from rest: off the axes of a hinge or universal joint and beyond the
/// limits with a standard deviation of `sd` radians, and away from the middle of the limits, in half-ranges, with
/// `middle_sd`. Empty for fixed joints. Near half a turn, where a rotation vector jumps, nothing is said.
std::vector<JointResidual> joint_residuals(const body::Joint& joint, const Eigen::Quaterniond& R, double sd,
                                           double middle_sd);

}  // namespace limbwave::estimate
