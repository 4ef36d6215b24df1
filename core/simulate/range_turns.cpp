#include "simulate/range_turns.h"

#include <array>
#include <cmath>

#include "base/units.h"
#include "simulate/curve.h"

namespace limbwave::simulate {
namespace {

constexpr double kTurn = 2.5;  // seconds from the rest orientation to the pole and back
constexpr double kSpiralTurns = 4.0;
constexpr double kSpiralEnd = 29.5;
constexpr double kHalfCircle = 4.5;
constexpr double kEnd = kSpiralEnd + 4.0 * kHalfCircle + kTurn;

// Polar angle and azimuth of "up" as the sensor sees it.
struct Path {
  Curve polar, azimuth;
};

const Path& path() {
  static const Path path = [] {
    Path p;
    p.azimuth.key(kTurn, 0.0).key(kSpiralEnd, kSpiralTurns * 2.0 * kPi);
    // At the pole half-way the circle through ±x gives way to the one through ±y.
    const double pole = kSpiralEnd + 2.0 * kHalfCircle;
    p.azimuth.key(pole - 1.0, kSpiralTurns * 2.0 * kPi).key(pole + 1.0, (kSpiralTurns * 2.0 + 0.5) * kPi);
    p.polar.key(kTurn, 0.0);
    for (int half = 0; half <= 4; ++half) {
      p.polar.key(kSpiralEnd + half * kHalfCircle, (half + 1) * kPi);
    }
    return p;
  }();
  return path;
}

}  // namespace

double range_seconds() {
  return kEnd;
}

QuaternionJet range_rotation(double time_s, const Quaterniond& R_WS_rest) {
  const QuaternionJet R_SW =
      rotation(Vector3d::UnitZ(), path().azimuth.at(time_s)) * rotation(Vector3d::UnitY(), path().polar.at(time_s));
  QuaternionJet rest;
  rest.v = R_WS_rest;
  if (time_s < 0.5 * kEnd) {
    return blend(rest, conjugate(R_SW), smooth_step(time_s, 0.0, kTurn));
  }
  return blend(conjugate(R_SW), rest, smooth_step(time_s, kEnd - kTurn, kTurn));
}

Vector3d range_jerk(double time_s) {
  struct Jerk {
    double start;
    Vector3d peak;
  };
  static const std::array jerks = {Jerk{7.3, {14.0, 3.0, 6.0}}, Jerk{16.1, {-4.0, 12.0, -9.0}},
                                   Jerk{31.6, {6.0, -8.0, 16.0}}, Jerk{41.2, {-13.0, -6.0, -10.0}}};
  constexpr double length = 0.12;
  for (const Jerk& jerk : jerks) {
    const double x = (time_s - jerk.start) / length;
    if (x > 0.0 && x < 1.0) {
      // To and fro, so that the hand is at rest again afterwards.
      const double window = std::sin(kPi * x);
      return jerk.peak * (window * window * std::sin(2.0 * kPi * x) * 1.54);
    }
  }
  return Vector3d::Zero();
}

}  // namespace limbwave::simulate
