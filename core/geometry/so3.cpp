#include "geometry/so3.h"

#include <Eigen/SVD>
#include <cmath>

#include "base/units.h"

namespace limbwave::geometry {
namespace {

// Below this angle the series are exact to double precision.
constexpr double kSmallAngle = 1e-4;

// (1 − cos θ)/θ² and (θ − sin θ)/θ³, the two coefficients of the Jacobians.
void jacobian_coefficients(double angle, double& a, double& b) {
  const double square = angle * angle;
  if (angle < 1e-2) {  // (θ − sin θ) loses digits early
    a = 0.5 - square / 24.0 + square * square / 720.0;
    b = 1.0 / 6.0 - square / 120.0 + square * square / 5040.0;
  } else {
    const double half = std::sin(0.5 * angle);
    a = 2.0 * half * half / square;
    b = (angle - std::sin(angle)) / (square * angle);
  }
}

// 1/θ² − (1 + cos θ)/(2 θ sin θ), the coefficient of the inverse Jacobians.
double inverse_coefficient(double angle) {
  const double square = angle * angle;
  if (angle < 1e-2) {
    return 1.0 / 12.0 + square / 720.0 + square * square / 30240.0;
  }
  // (1 + cos)/sin = cot(θ/2), which stays finite at π.
  return 1.0 / square - 1.0 / (2.0 * angle * std::tan(0.5 * angle));
}

}  // namespace

Matrix3d skew(const Vector3d& a) {
  Matrix3d m;
  m << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return m;
}

Quaterniond exp_so3(const Vector3d& phi) {
  const double angle = phi.norm();
  const double half = 0.5 * angle;
  const double scale = angle < kSmallAngle ? 0.5 - angle * angle / 48.0 : std::sin(half) / angle;
  Quaterniond q(std::cos(half), scale * phi.x(), scale * phi.y(), scale * phi.z());
  q.normalize();
  return q;
}

Vector3d log_so3(const Quaterniond& R) {
  const double sign = R.w() < 0.0 ? -1.0 : 1.0;
  const Vector3d v = sign * R.vec();
  const double w = sign * R.w();
  const double n = v.norm();
  if (n < kSmallAngle * w) {
    const double t = n / w;
    return v * (2.0 / w) * (1.0 - t * t / 3.0);
  }
  return n > 0.0 ? Vector3d(v * (2.0 * std::atan2(n, w) / n)) : Vector3d::Zero();
}

Matrix3d left_jacobian(const Vector3d& phi) {
  double a = 0.0;
  double b = 0.0;
  jacobian_coefficients(phi.norm(), a, b);
  const Matrix3d s = skew(phi);
  return Matrix3d::Identity() + a * s + b * s * s;
}

Matrix3d right_jacobian(const Vector3d& phi) {
  return left_jacobian(-phi);
}

Matrix3d left_jacobian_inverse(const Vector3d& phi) {
  const Matrix3d s = skew(phi);
  return Matrix3d::Identity() - 0.5 * s + inverse_coefficient(phi.norm()) * s * s;
}

Matrix3d right_jacobian_inverse(const Vector3d& phi) {
  return left_jacobian_inverse(-phi);
}

namespace {

// For unit vectors.
Quaterniond unit_shortest_arc(const Vector3d& a, const Vector3d& b, const Vector3d& fallback_axis) {
  const Vector3d half = a + b;  // half-way direction: accurate until the two are nearly opposite
  const double n = half.norm();
  if (n > 1e-7) {
    const Vector3d h = half / n;
    const Vector3d v = a.cross(h);
    Quaterniond q(a.dot(h), v.x(), v.y(), v.z());
    q.normalize();
    return q;
  }
  Vector3d axis = fallback_axis - fallback_axis.dot(a) * a;
  if (axis.norm() < 1e-6) {
    axis = a.unitOrthogonal();
  }
  axis.normalize();
  return {0.0, axis.x(), axis.y(), axis.z()};
}

bool has_direction(const Vector3d& v) {
  const double length = v.stableNorm();
  return length > 0.0 && std::isfinite(length);
}

}  // namespace

Quaterniond shortest_arc(const Vector3d& from, const Vector3d& to, const Vector3d& fallback_axis) {
  if (!has_direction(from) || !has_direction(to)) {
    return Quaterniond::Identity();
  }
  const Vector3d a = from.stableNormalized();
  const Vector3d b = to.stableNormalized();
  Quaterniond q = unit_shortest_arc(a, b, fallback_axis);
  if (a.dot(b) < 0.0) {
    // The small arc that rounding left open: (nearly) opposite directions meet exactly too.
    q = unit_shortest_arc(q * a, b, fallback_axis) * q;
    q.normalize();
  }
  return q;
}

double geodesic_angle(const Quaterniond& R1, const Quaterniond& R2) {
  const Quaterniond d = R1.conjugate() * R2;
  return 2.0 * std::atan2(d.vec().norm(), std::abs(d.w()));
}

double angle_between(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

Matrix3d nearest_rotation(const Matrix3d& M) {
  const Eigen::JacobiSVD<Matrix3d> svd(M, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Vector3d d(1.0, 1.0, 1.0);
  d.z() = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  return svd.matrixU() * d.asDiagonal() * svd.matrixV().transpose();
}

double heading_about_vertical(const Quaterniond& R_WL) {
  const Vector3d up_L = R_WL.conjugate() * Vector3d::UnitZ();
  const Quaterniond about_z = R_WL * shortest_arc(up_L, Vector3d::UnitZ()).conjugate();
  return std::remainder(2.0 * std::atan2(about_z.z(), about_z.w()), 2.0 * kPi);
}

}  // namespace limbwave::geometry
