#include "solve/sensor_health.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace limbwave::solve {
namespace {

constexpr std::size_t kWindow = 60;         // frames: one second at the nominal rate
constexpr double kStillDeviation_g = 0.03;  // quieter than any worn limb that moves
constexpr double kNormTolerance_g = 0.1;    // a calibrated sensor at rest is nearer to 1 g
constexpr double kUncalibratedTolerance_g = 0.3;
constexpr double kBadAtRest_g = 0.5;      // further than this from 1 g no range calibration is to blame
constexpr double kSameLevel_g = 0.15;     // axes that are not driven sit at one level
constexpr double kBeyondGravity_g = 1.2;  // on all axes at once: 2.1 g, which is no rest
constexpr double kMidSupply_g = 0.1;

// What the readings of a second have in common, in nominal g around the sensor's zero. Judged before any calibration,
// which would turn a level of the line into a direction.
struct Levels {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  double deviation = 0.0;  // RMS of the most restless axis
};

// An input that nothing drives: all axes rest at one level, and that level is one which gravity does not give on all
// three at once, the ground, the supply or the middle between them.
bool is_undriven(const Levels& levels) {
  const double middle = levels.mean.mean();
  const bool is_one_level = (levels.mean.array() - middle).abs().maxCoeff() < kSameLevel_g;
  return levels.deviation < kStillDeviation_g && is_one_level &&
         (std::abs(middle) > kBeyondGravity_g || std::abs(middle) < kMidSupply_g);
}

}  // namespace

SensorHealth sensor_health(const body::Rig& rig, const calibrate::SensorCalibration& calibration, int sensor,
                           std::span<const decode::AccelerationFrame> frames) {
  if (frames.size() < kWindow / 2) {
    return {HealthState::kUnknown, "no-signal", "no readings yet"};
  }
  frames = frames.last(std::min(frames.size(), kWindow));
  const auto s = static_cast<std::size_t>(sensor);
  std::size_t usable = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Vector3d squares = Eigen::Vector3d::Zero();
  Eigen::Vector3d nominal_sum = Eigen::Vector3d::Zero();
  Eigen::Vector3d nominal_squares = Eigen::Vector3d::Zero();
  double largest_g = 0.0;
  const Eigen::Vector3d zero = Eigen::Vector3d::Constant(rig.line_in.zero_g_volts - rig.line_in.reference_volts);
  for (const decode::AccelerationFrame& frame : frames) {
    if ((frame.usable >> s & 1U) == 0) {
      continue;
    }
    ++usable;
    const Eigen::Vector3d force_g = calibration.apply(frame.volts[s]) / kStandardGravity;
    const Eigen::Vector3d nominal_g = (frame.volts[s] - zero) / rig.line_in.volts_per_g;
    nominal_sum += nominal_g;
    nominal_squares += nominal_g.cwiseProduct(nominal_g);
    sum += force_g;
    squares += force_g.cwiseProduct(force_g);
    largest_g = std::max(largest_g, force_g.cwiseAbs().maxCoeff());
  }
  const double fraction = static_cast<double>(usable) / static_cast<double>(frames.size());
  if (fraction < 0.5) {
    return {HealthState::kBad, "unusable",
            fmt::format("only {:.0f} % of the readings can be used; lower the level if it clips, else check the cable",
                        100.0 * fraction)};
  }
  const auto n = static_cast<double>(usable);
  const Eigen::Vector3d mean = sum / n;
  const Eigen::Vector3d variance = (squares / n - mean.cwiseProduct(mean)).cwiseMax(0.0);
  const double norm = mean.norm();
  Levels levels{nominal_sum / n, 0.0};
  levels.deviation = std::sqrt((nominal_squares / n - levels.mean.cwiseProduct(levels.mean)).cwiseMax(0.0).maxCoeff());
  if (is_undriven(levels)) {
    return {HealthState::kBad, "no-signal", "reads nothing; check that the sensor is plugged in"};
  }
  if (largest_g > 1.5 * rig.line_in.range_g) {
    return {HealthState::kBad, "not-plausible",
            fmt::format("reads {:.1f} g, more than the sensor can; check its cable and supply", largest_g)};
  }
  const double deviation = std::sqrt(variance.maxCoeff());
  const bool calibrated = calibration.method != "nominal";
  if (deviation < kStillDeviation_g) {
    const double tolerance = calibrated ? kNormTolerance_g : kUncalibratedTolerance_g;
    if (std::abs(norm - 1.0) > tolerance) {
      const bool is_bad = std::abs(norm - 1.0) > kBadAtRest_g;
      return {is_bad ? HealthState::kBad : HealthState::kWarning, "not-plausible",
              fmt::format("reads {:.2f} g at rest instead of 1 g; {}", norm,
                          is_bad ? "check its cable and plug" : "repeat its range calibration")};
    }
  }
  if (largest_g > 0.98 * rig.line_in.range_g) {
    return {HealthState::kWarning, "saturated",
            fmt::format("reaches its limit of {:.0f} g; move less abruptly", rig.line_in.range_g)};
  }
  if (fraction < 0.98) {
    return {HealthState::kWarning, "gaps", fmt::format("{:.0f} % of the readings are lost", 100.0 * (1.0 - fraction))};
  }
  if (!calibrated) {
    return {HealthState::kWarning, "no-calibration", "works, but was never calibrated; calibrate its range"};
  }
  return {HealthState::kGood, "good", "good"};
}

}  // namespace limbwave::solve
