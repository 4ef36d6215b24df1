#include "estimate/joint_plausibility.h"

#include <algorithm>
#include <cmath>

#include "geometry/so3.h"

namespace limbwave::estimate {
namespace {

using body::JointKind;
using Eigen::Vector3d;

// A joint that is so far round says nothing, radians.
constexpr double kFar = 2.7;

struct Angle {
  double value;
  Vector3d gradient;
};

// atan2(y, x) with the gradients of both.
Angle angle_of(double x, double y, const Vector3d& gradient_x, const Vector3d& gradient_y) {
  const double square = std::max(x * x + y * y, 1e-6);
  return {std::atan2(y, x), (x * gradient_y - y * gradient_x) / square};
}

// Limits and middle of one angle.
void bound(std::vector<JointResidual>& residuals, double angle, const Vector3d& gradient, double minimum,
           double maximum, double sd, double middle_sd) {
  if (angle > maximum) {
    residuals.push_back({(angle - maximum) / sd, gradient / sd});
  } else if (angle < minimum) {
    residuals.push_back({(angle - minimum) / sd, gradient / sd});
  }
  const double half = std::max(0.5 * (maximum - minimum), 0.1);
  const double scale = 1.0 / (half * middle_sd);
  residuals.push_back({(angle - 0.5 * (maximum + minimum)) * scale, gradient * scale});
}

}  // namespace

std::vector<JointResidual> joint_residuals(const body::Joint& joint, const Eigen::Quaterniond& R, double sd,
                                           double middle_sd) {
  std::vector<JointResidual> residuals;
  if (joint.kind == JointKind::kUniversal) {
    // R = exp(axis a) exp(axis2 b): axis2 stays across axis.
    const Vector3d x = R * joint.axis2;
    const double off = joint.axis.dot(x) - joint.axis.dot(joint.axis2);
    residuals.push_back({off / sd, x.cross(joint.axis) / sd});
    // a: how far x has gone round from axis2 about axis. b: how far the axis has gone round the other way, seen from
    // the child.
    const Vector3d across = joint.axis.cross(joint.axis2);
    const Vector3d y = R.conjugate() * joint.axis;
    const Angle a = angle_of(joint.axis2.dot(x), across.dot(x), x.cross(joint.axis2), x.cross(across));
    const Angle b =
        angle_of(joint.axis.dot(y), across.dot(y), (R * joint.axis).cross(joint.axis), (R * across).cross(joint.axis));
    if (std::abs(a.value) < kFar) {
      bound(residuals, a.value, a.gradient, joint.minimum.x(), joint.maximum.x(), sd, middle_sd);
    }
    if (std::abs(b.value) < kFar) {
      bound(residuals, b.value, b.gradient, joint.minimum.y(), joint.maximum.y(), sd, middle_sd);
    }
    return residuals;
  }
  const Vector3d phi = geometry::log_so3(R);
  if (joint.kind == JointKind::kFixed || phi.norm() > kFar) {
    return residuals;
  }
  const Eigen::Matrix3d J = geometry::left_jacobian_inverse(phi);
  if (joint.kind == JointKind::kHinge) {
    const Vector3d u = joint.axis.unitOrthogonal();
    const Vector3d v = joint.axis.cross(u);
    residuals.push_back({u.dot(phi) / sd, J.transpose() * u / sd});
    residuals.push_back({v.dot(phi) / sd, J.transpose() * v / sd});
    bound(residuals, joint.axis.dot(phi), J.transpose() * joint.axis, joint.minimum.x(), joint.maximum.x(), sd,
          middle_sd);
    return residuals;
  }
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    bound(residuals, phi[axis], J.row(axis).transpose(), joint.minimum[axis], joint.maximum[axis], sd, middle_sd);
  }
  return residuals;
}

}  // namespace limbwave::estimate
