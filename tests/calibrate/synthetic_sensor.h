/// A sensor with known errors, turned by hand or worn, for tests of calibrations.
#pragma once

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <random>

#include "base/units.h"
#include "body/rig.h"
#include "calibrate/calibration.h"
#include "calibrate/reading.h"
#include "geometry/so3.h"

namespace limbwave::test {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

/// volts = offset + volts_per_g · E · f/g + noise, with the errors of signals.md §4 before calibration.
struct SyntheticSensor {
  Vector3d offset = Vector3d::Constant(1.32);
  Matrix3d volts_per_force = Matrix3d::Identity() * (0.33 / kStandardGravity);
  double noise = 0.02;  ///< m/s² RMS per axis.

  static SyntheticSensor perfect() {
    SyntheticSensor sensor;
    sensor.noise = 0.0;
    return sensor;
  }
  /// Offset and scale `percent` off per axis in random directions, cross-axis terms a tenth of that.
  static SyntheticSensor off_by(double fraction, std::mt19937_64& random) {
    SyntheticSensor sensor;
    std::bernoulli_distribution sign;
    std::uniform_real_distribution<double> cross(-0.1, 0.1);
    Matrix3d E = Matrix3d::Identity();
    for (int i = 0; i < 3; ++i) {
      sensor.offset[i] += 0.33 * fraction * (sign(random) ? 1.0 : -1.0);
      for (int j = 0; j < 3; ++j) {
        E(i, j) += fraction * (i == j ? (sign(random) ? 1.0 : -1.0) : cross(random));
      }
    }
    sensor.volts_per_force = E * (0.33 / kStandardGravity);
    return sensor;
  }
  [[nodiscard]] Vector3d volts(const Vector3d& f_S, std::mt19937_64& random) const {
    std::normal_distribution<double> normal;
    const Vector3d n(normal(random), normal(random), normal(random));
    return offset + volts_per_force * (f_S + noise * n);
  }
  /// The calibration that undoes this sensor up to the rotation that gravity cannot show: |apply| is exact.
  [[nodiscard]] Matrix3d symmetric_M() const {
    const Matrix3d M = volts_per_force.inverse();
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(M.transpose() * M);
    return eigen.operatorSqrt();
  }
  /// Frame of the symmetric calibration relative to the chip's true frame: f_sym = Q f_S.
  [[nodiscard]] Matrix3d symmetric_frame() const { return symmetric_M() * volts_per_force; }
};

/// Turning by hand through all directions: three angles that run at incommensurate speeds, `rate` rad/s in all.
inline Quaterniond hand_turn(double t, double rate) {
  return Quaterniond(Eigen::AngleAxisd(0.81 * rate * t, Vector3d::UnitX()) *
                     Eigen::AngleAxisd(0.47 * rate * t + 0.3, Vector3d::UnitY()) *
                     Eigen::AngleAxisd(0.31 * rate * t, Vector3d::UnitZ()));
}

/// Readings at 60 Hz while `R_WS(t)` turns and `a_W(t)` accelerates the sensor.
inline calibrate::SensorSeries record(const SyntheticSensor& sensor, double seconds,
                                      const std::function<Quaterniond(double)>& R_WS,
                                      const std::function<Vector3d(double)>& a_W, std::mt19937_64& random) {
  calibrate::SensorSeries series;
  for (int i = 0; i < static_cast<int>(60.0 * seconds); ++i) {
    const double t = i / 60.0;
    const Vector3d f_W = kStandardGravity * Vector3d::UnitZ() + a_W(t);
    series.push(t, sensor.volts(R_WS(t).conjugate() * f_W, random), true);
  }
  return series;
}

inline Vector3d no_acceleration(double /*t*/) {
  return Vector3d::Zero();
}

/// A hand's jerks: every `period` seconds a push of 120 ms with 1.5 g in a changing direction.
inline Vector3d jerks(double t, double period) {
  const double phase = std::fmod(t, period);
  if (phase > 0.12) {
    return Vector3d::Zero();
  }
  const double k = std::floor(t / period);
  const Vector3d direction = Vector3d(std::sin(1.7 * k), std::cos(2.3 * k), std::sin(0.9 * k + 1.0)).normalized();
  return 1.5 * kStandardGravity * std::sin(kPi * phase / 0.12) * direction;
}

inline body::LineInSignal nominal_signal() {
  return {};
}

}  // namespace limbwave::test
