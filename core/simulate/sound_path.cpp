#include "simulate/sound_path.h"

#include <algorithm>
#include <cmath>

namespace limbwave::simulate {
namespace {

constexpr double kMostLoss = 60.0;  // decibels

}  // namespace

Passage passage(const Vector3d& p, const Vector3d& q, const WorldCapsule& capsule) {
  // Closest points of two segments (Ericson, Real-Time Collision Detection, 2005, §5.1.9).
  const Vector3d d1 = q - p;
  const Vector3d d2 = capsule.b - capsule.a;
  const Vector3d r = p - capsule.a;
  const double a = d1.squaredNorm();
  const double e = d2.squaredNorm();
  const double f = d2.dot(r);
  const double c = d1.dot(r);
  double s = 0.0;
  double t = 0.0;
  if (e <= 1e-18) {
    s = a > 0.0 ? std::clamp(-c / a, 0.0, 1.0) : 0.0;
  } else {
    const double b = d1.dot(d2);
    const double denominator = a * e - b * b;
    s = denominator > 1e-18 ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0.0;
    t = (b * s + f) / e;
    if (t < 0.0 || t > 1.0) {
      t = std::clamp(t, 0.0, 1.0);
      s = a > 0.0 ? std::clamp((b * t - c) / a, 0.0, 1.0) : 0.0;
    }
  }
  return {(p + s * d1 - capsule.a - t * d2).norm() - capsule.radius, s};
}

double knife_edge_loss_db(double depth, double d1, double d2, double wavelength) {
  const double near = std::max(d1, 1e-3);
  const double far = std::max(d2, 1e-3);
  const double v = depth * std::sqrt(2.0 / wavelength * (1.0 / near + 1.0 / far));
  if (v <= -0.78) {
    return 0.0;
  }
  return std::max(0.0, 6.9 + 20.0 * std::log10(std::sqrt((v - 0.1) * (v - 0.1) + 1.0) + v - 0.1));
}

Shade shade(const Vector3d& p, const Vector3d& q, const std::vector<WorldCapsule>& capsules, double wavelength) {
  Shade shade;
  const double length = (q - p).norm();
  for (const WorldCapsule& capsule : capsules) {
    // Most limbs are far from the line: a sphere about them tells.
    const Vector3d middle = 0.5 * (capsule.a + capsule.b);
    const double reach = 0.5 * (capsule.b - capsule.a).norm() + capsule.radius + 0.05;
    const double s = length > 0.0 ? std::clamp((middle - p).dot(q - p) / (length * length), 0.0, 1.0) : 0.0;
    if ((p + s * (q - p) - middle).squaredNorm() > reach * reach) {
      continue;
    }
    const Passage by = passage(p, q, capsule);
    const double d1 = by.along * length;
    const double d2 = length - d1;
    // A microphone or source just outside its own limb is not shaded by that limb's nearness at the very end.
    const double loss =
        by.clearance >= 0.0 && std::min(d1, d2) < 1e-6 ? 0.0 : knife_edge_loss_db(-by.clearance, d1, d2, wavelength);
    shade.loss_db += loss;
    if (by.clearance < 0.0) {
      const double near = std::max(d1, 0.01);
      const double far = std::max(d2, 0.01);
      shade.detour = std::max(shade.detour, 0.5 * by.clearance * by.clearance * (1.0 / near + 1.0 / far));
    }
  }
  shade.loss_db = std::min(shade.loss_db, kMostLoss);
  shade.detour = std::min(shade.detour, 0.3);
  return shade;
}

}  // namespace limbwave::simulate
