/// Limbs that turn in known ways and accelerate in bursts, as an accelerometer at 60 Hz feels them.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "base/units.h"
#include "estimate/inclination.h"
#include "geometry/so3.h"

namespace limbwave::test {

using Eigen::Quaterniond;
using Eigen::Vector3d;

struct LimbSeries {
  std::vector<estimate::ForceSample> samples;
  std::vector<Vector3d> up_L;  ///< The truth.
};

/// 60 Hz readings of a limb whose orientation is `R_WL(t)` and whose sensor accelerates with `a_W(t)`.
inline LimbSeries felt(double seconds, const std::function<Quaterniond(double)>& R_WL,
                       const std::function<Vector3d(double)>& a_W, double noise, std::uint64_t seed = 1) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  LimbSeries series;
  for (int i = 0; i < static_cast<int>(60.0 * seconds); ++i) {
    const double t = i / 60.0;
    const Quaterniond R_LW = R_WL(t).conjugate();
    const Vector3d n(normal(random), normal(random), normal(random));
    series.samples.push_back({t, R_LW * (kStandardGravity * Vector3d::UnitZ() + a_W(t)) + noise * n, true});
    series.up_L.push_back(R_LW * Vector3d::UnitZ());
  }
  return series;
}

/// Slow turning of an unhurried limb: peaks of about 40°/s.
inline Quaterniond slow_turn(double t) {
  return geometry::exp_so3(Vector3d(0.5 * std::sin(0.9 * t), 0.8 * std::sin(0.6 * t + 0.4), 0.6 * std::sin(0.4 * t)));
}

/// Every 2 s a push there and back within 0.5 s (one period of a sine under a bell), of `peak` m/s², in a direction
/// that changes every time. It leaves no velocity behind.
inline Vector3d bursts(double t, double peak) {
  const double phase = std::fmod(t, 2.0) - 1.0;
  if (std::abs(phase) > 0.25) {
    return Vector3d::Zero();
  }
  const double k = std::floor(t / 2.0);
  const Vector3d direction =
      Vector3d(std::sin(2.1 * k + 0.3), std::cos(1.3 * k), 0.7 * std::sin(0.7 * k + 1.0)).normalized();
  return peak * std::sin(4.0 * kPi * phase) * std::cos(2.0 * kPi * phase) / 0.77 * direction;
}

inline Vector3d rest(double /*t*/) {
  return Vector3d::Zero();
}

/// Acceleration of a point at `p_L` of a limb that turns about a resting joint, by central differences.
inline std::function<Vector3d(double)> lever(const std::function<Quaterniond(double)>& R_WL, const Vector3d& p_L) {
  return [R_WL, p_L](double t) -> Vector3d {
    constexpr double h = 1e-3;
    return (R_WL(t + h) * p_L - 2.0 * (R_WL(t) * p_L) + R_WL(t - h) * p_L) / (h * h);
  };
}

}  // namespace limbwave::test
