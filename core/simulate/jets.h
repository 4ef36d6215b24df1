/// Functions of time with their first two derivatives, so that accelerations are exact and never differenced.
#pragma once

#include <Eigen/Geometry>
#include <cmath>

namespace limbwave::simulate {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// A number with its first and second derivative by time.
struct Jet {
  double v = 0.0, d = 0.0, dd = 0.0;
};

inline Jet operator+(const Jet& a, const Jet& b) {
  return {a.v + b.v, a.d + b.d, a.dd + b.dd};
}
inline Jet operator-(const Jet& a, const Jet& b) {
  return {a.v - b.v, a.d - b.d, a.dd - b.dd};
}
inline Jet operator*(const Jet& a, const Jet& b) {
  return {a.v * b.v, a.d * b.v + a.v * b.d, a.dd * b.v + 2.0 * a.d * b.d + a.v * b.dd};
}
inline Jet operator*(double s, const Jet& a) {
  return {s * a.v, s * a.d, s * a.dd};
}
/// f(a) from f, f' and f'' at a.v.
inline Jet chain(const Jet& a, double f, double df, double ddf) {
  return {f, df * a.d, ddf * a.d * a.d + df * a.dd};
}
inline Jet sin(const Jet& a) {
  return chain(a, std::sin(a.v), std::cos(a.v), -std::sin(a.v));
}
inline Jet cos(const Jet& a) {
  return chain(a, std::cos(a.v), -std::sin(a.v), -std::cos(a.v));
}
/// 1/√a, for a > 0.
inline Jet inverse_sqrt(const Jet& a) {
  const double r = 1.0 / std::sqrt(a.v);
  return chain(a, r, -0.5 * r / a.v, 0.75 * r / (a.v * a.v));
}

/// A vector with its first and second derivative by time.
struct VectorJet {
  Vector3d v = Vector3d::Zero(), d = Vector3d::Zero(), dd = Vector3d::Zero();
};

inline VectorJet operator+(const VectorJet& a, const VectorJet& b) {
  return {a.v + b.v, a.d + b.d, a.dd + b.dd};
}
inline VectorJet operator*(const Jet& s, const VectorJet& a) {
  return {s.v * a.v, s.d * a.v + s.v * a.d, s.dd * a.v + 2.0 * s.d * a.d + s.v * a.dd};
}

/// A quaternion (a 4-vector; of unit length where it is a rotation) with its derivatives by time.
struct QuaternionJet {
  Quaterniond v = Quaterniond::Identity();
  Quaterniond d{0.0, 0.0, 0.0, 0.0};
  Quaterniond dd{0.0, 0.0, 0.0, 0.0};
};

inline QuaternionJet operator*(const QuaternionJet& a, const QuaternionJet& b) {
  QuaternionJet r;
  r.v = a.v * b.v;
  r.d.coeffs() = (a.d * b.v).coeffs() + (a.v * b.d).coeffs();
  r.dd.coeffs() = (a.dd * b.v).coeffs() + 2.0 * (a.d * b.d).coeffs() + (a.v * b.dd).coeffs();
  return r;
}
inline QuaternionJet operator*(const QuaternionJet& a, const Quaterniond& b) {
  return {a.v * b, a.d * b, a.dd * b};
}
inline QuaternionJet operator*(const Quaterniond& a, const QuaternionJet& b) {
  return {a * b.v, a * b.d, a * b.dd};
}
inline QuaternionJet conjugate(const QuaternionJet& a) {
  return {a.v.conjugate(), a.d.conjugate(), a.dd.conjugate()};
}

/// Rotation about a fixed unit axis by a moving angle.
inline QuaternionJet rotation(const Vector3d& axis, const Jet& angle) {
  const Jet c = cos(0.5 * angle);
  const Jet s = sin(0.5 * angle);
  const auto make = [&](double w, double xyz) {
    return Quaterniond(w, xyz * axis.x(), xyz * axis.y(), xyz * axis.z());
  };
  return {make(c.v, s.v), make(c.d, s.d), make(c.dd, s.dd)};
}

/// q/|q|, for q ≠ 0.
inline QuaternionJet normalized(const QuaternionJet& q) {
  const Jet square{q.v.squaredNorm(), 2.0 * q.v.dot(q.d), 2.0 * (q.d.squaredNorm() + q.v.dot(q.dd))};
  const Jet r = inverse_sqrt(square);
  QuaternionJet n;
  n.v.coeffs() = r.v * q.v.coeffs();
  n.d.coeffs() = r.d * q.v.coeffs() + r.v * q.d.coeffs();
  n.dd.coeffs() = r.dd * q.v.coeffs() + 2.0 * r.d * q.d.coeffs() + r.v * q.dd.coeffs();
  return n;
}

/// R * a for a rotation R.
inline VectorJet rotate(const QuaternionJet& R, const VectorJet& a) {
  const auto pure = [](const Vector3d& u) { return Quaterniond(0.0, u.x(), u.y(), u.z()); };
  const QuaternionJet r = R * QuaternionJet{pure(a.v), pure(a.d), pure(a.dd)} * conjugate(R);
  return {r.v.vec(), r.d.vec(), r.dd.vec()};
}
inline VectorJet rotate(const QuaternionJet& R, const Vector3d& a) {
  const Quaterniond pure(0.0, a.x(), a.y(), a.z());
  const QuaternionJet r = (R * pure) * conjugate(R);
  return {r.v.vec(), r.d.vec(), r.dd.vec()};
}

/// From a to b with the weight s (0..1) along the shorter way: (1 − s) a + s b, normalised.
inline QuaternionJet blend(const QuaternionJet& a, const QuaternionJet& b, const Jet& s) {
  const double sign = a.v.dot(b.v) < 0.0 ? -1.0 : 1.0;
  const Jet wa{1.0 - s.v, -s.d, -s.dd};
  const Jet wb = sign * s;
  QuaternionJet q;
  q.v.coeffs() = wa.v * a.v.coeffs() + wb.v * b.v.coeffs();
  q.d.coeffs() = wa.d * a.v.coeffs() + wa.v * a.d.coeffs() + wb.d * b.v.coeffs() + wb.v * b.d.coeffs();
  q.dd.coeffs() = wa.dd * a.v.coeffs() + 2.0 * wa.d * a.d.coeffs() + wa.v * a.dd.coeffs() + wb.dd * b.v.coeffs() +
                  2.0 * wb.d * b.d.coeffs() + wb.v * b.dd.coeffs();
  return normalized(q);
}

/// The smooth step of degree 9: 0 at x <= 0, 1 at x >= 1, with four derivatives that vanish at both ends (C⁴). Limbs do
/// not start more abruptly: at a lower degree the acceleration has corners that a 60 Hz multiplexer cannot follow.
inline Jet smooth_step(double x) {
  if (x <= 0.0) {
    return {0.0, 0.0, 0.0};
  }
  if (x >= 1.0) {
    return {1.0, 0.0, 0.0};
  }
  const double x2 = x * x;
  const double y = 1.0 - x;
  const double xy3 = x2 * x * y * y * y;
  return {x2 * x2 * x * (126.0 + x * (-420.0 + x * (540.0 + x * (-315.0 + 70.0 * x)))), 630.0 * xy3 * x * y,
          2520.0 * xy3 * (1.0 - 2.0 * x)};
}

/// The smooth step from `start` to `start + duration`, by time.
inline Jet smooth_step(double t, double start, double duration) {
  const Jet s = smooth_step((t - start) / duration);
  return {s.v, s.d / duration, s.dd / (duration * duration)};
}

}  // namespace limbwave::simulate
