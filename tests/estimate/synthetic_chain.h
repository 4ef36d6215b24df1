/// An arm of three links that swings in known ways, as its accelerometers at 60 Hz feel it.
#pragma once

#include <functional>
#include <random>
#include <vector>

#include "base/units.h"
#include "estimate/limb_chain.h"
#include "estimate/synthetic_limb.h"
#include "geometry/so3.h"

namespace limbwave::test {

using estimate::ChainLink;
using estimate::LimbChain;

/// Torso, upper arm hanging on it, forearm.
inline LimbChain three_links() {
  LimbChain chain;
  ChainLink torso;
  torso.p_LS = {0.35, 0.0, -0.10};
  torso.R_PL_rest = Quaterniond(std::sqrt(0.5), 0.0, -std::sqrt(0.5), 0.0);
  ChainLink upper_arm;
  upper_arm.parent = 0;
  upper_arm.p_PL = {0.46, -0.19, 0.0};
  upper_arm.p_LS = {0.18, 0.0, 0.05};
  upper_arm.R_PL_rest = Quaterniond(0.0, 0.0, 1.0, 0.0);
  ChainLink forearm;
  forearm.parent = 1;
  forearm.p_PL = {0.30, 0.0, 0.0};
  forearm.p_LS = {0.20, 0.0, 0.03};
  forearm.joint.kind = body::JointKind::kUniversal;
  forearm.joint.axis = -Vector3d::UnitY();
  forearm.joint.axis2 = Vector3d::UnitX();
  chain.links = {torso, upper_arm, forearm};
  chain.sensors = {0, 1, 2};
  return chain;
}

using Angles = std::function<Vector3d(double)>;  ///< Torso's lean, shoulder's flexion, elbow's flexion, radians.

/// A second's hurried swing of shoulder and elbow, again and again, with rests before and after.
inline Vector3d swinging(double t) {
  const double s = std::min(1.0, std::max(0.0, t - 2.0));
  const double on = s * s * s * s * (35.0 - 84.0 * s + 70.0 * s * s - 20.0 * s * s * s);  // three smooth derivatives
  return on * Vector3d(0.03 * std::sin(1.9 * t), 0.5 * std::sin(2.0 * kPi * 0.95 * (t - 2.0)),
                       0.35 + 0.25 * std::sin(2.0 * kPi * 0.95 * (t - 2.0) - 0.5));
}

/// World orientations of the links of `three_links`.
inline std::vector<Quaterniond> orientations_at(const LimbChain& chain, const Vector3d& angles) {
  const auto turn = [](const Vector3d& axis, double angle) { return Quaterniond(Eigen::AngleAxisd(angle, axis)); };
  std::vector<Quaterniond> R_WL;
  R_WL.push_back(chain.links[0].R_PL_rest * turn(Vector3d::UnitY(), angles[0]));
  R_WL.push_back(R_WL[0] * chain.links[1].R_PL_rest * turn(-Vector3d::UnitY(), angles[1]));
  R_WL.push_back(R_WL[1] * turn(-Vector3d::UnitY(), angles[2]));
  return R_WL;
}

struct ChainSeries {
  LimbChain chain;
  std::vector<double> times;
  std::vector<std::vector<estimate::ForceSample>> samples;  ///< [link][instant]
  std::vector<std::vector<Quaterniond>> R_WL;               ///< The truth.

  [[nodiscard]] Vector3d up_L(std::size_t link, std::size_t instant) const {
    return R_WL[link][instant].conjugate() * Vector3d::UnitZ();
  }
};

/// What the sensors of `really` feel; the series' chain is `believed`.
inline ChainSeries felt_by_chain(double seconds, const Angles& angles, double noise, const LimbChain& really,
                                 const LimbChain& believed, std::uint64_t seed = 1) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  ChainSeries series;
  series.chain = believed;
  series.samples.resize(really.links.size());
  series.R_WL.resize(really.links.size());
  const auto positions = [&](double t) {
    const std::vector<Quaterniond> R_WL = orientations_at(really, angles(t));
    std::vector<Vector3d> joints;
    std::vector<Vector3d> sensors;
    for (std::size_t i = 0; i < R_WL.size(); ++i) {
      const int parent = really.links[i].parent;
      const auto p = static_cast<std::size_t>(parent);
      joints.push_back(parent < 0 ? Vector3d(Vector3d::Zero()) : Vector3d(joints[p] + R_WL[p] * really.links[i].p_PL));
      sensors.push_back(joints[i] + R_WL[i] * really.links[i].p_LS);
    }
    return sensors;
  };
  for (int n = 0; n < static_cast<int>(60.0 * seconds); ++n) {
    constexpr double h = 1e-3;
    const double t = n / 60.0;
    series.times.push_back(t);
    const std::vector<Quaterniond> R_WL = orientations_at(really, angles(t));
    const auto before = positions(t - h);
    const auto now = positions(t);
    const auto after = positions(t + h);
    for (std::size_t i = 0; i < R_WL.size(); ++i) {
      const Vector3d a = (after[i] - 2.0 * now[i] + before[i]) / (h * h);
      const Vector3d error(normal(random), normal(random), normal(random));
      series.samples[i].push_back(
          {t, R_WL[i].conjugate() * (a + kStandardGravity * Vector3d::UnitZ()) + noise * error, true});
      series.R_WL[i].push_back(R_WL[i]);
    }
  }
  return series;
}

}  // namespace limbwave::test
