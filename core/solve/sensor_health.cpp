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
constexpr double kFrozenVolts = 1e-7;  // no real sensor and line repeat a reading like this

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
  double largest_g = 0.0;
  for (const decode::AccelerationFrame& frame : frames) {
    if ((frame.usable >> s & 1U) == 0) {
      continue;
    }
    ++usable;
    const Eigen::Vector3d force_g = calibration.apply(frame.volts[s]) / kStandardGravity;
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
  if (variance.maxCoeff() < kFrozenVolts * kFrozenVolts && norm < 1e-6) {
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
      return {norm < 0.3 ? HealthState::kBad : HealthState::kWarning, "not-plausible",
              fmt::format("reads {:.2f} g at rest instead of 1 g; {}", norm,
                          norm < 0.3 ? "check the cable" : "repeat its range calibration")};
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
