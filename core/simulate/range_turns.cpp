#include "simulate/range_turns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/units.h"
#include "simulate/curve.h"

namespace limbwave::simulate {
namespace {

constexpr double kTurn = 2.5;  // seconds from the rest orientation to the pole and back
constexpr double kSpiralTurns = 4.0;
constexpr double kSpeed = radians(45.0);      // of gravity across the sphere, 1/s: slow enough to feel nothing else
constexpr double kSpinLimit = radians(90.0);  // of the azimuth near the poles, 1/s
constexpr double kRate_hz = 50.0;
constexpr double kPass_hz = 1.5;  // softens the corners between the legs of the path

// Polar angle and azimuth of "up" as the sensor sees it: at constant speed down a spiral, then along the great circles
// through ±x and through ±y.
struct Path {
  SampledCurve polar, azimuth;
  double end = 0.0;
};

Path make_path() {
  std::vector<double> polar;
  std::vector<double> azimuth;
  const auto hold = [&](double seconds, double p, double a) {
    for (int i = 0; i < static_cast<int>(seconds * kRate_hz); ++i) {
      polar.push_back(p);
      azimuth.push_back(a);
    }
  };
  hold(kTurn, 0.0, 0.0);
  constexpr double per_polar = 2.0 * kSpiralTurns;  // radians of azimuth a radian of polar angle
  double p = 0.0;
  while (p < kPi) {
    polar.push_back(p);
    azimuth.push_back(per_polar * p);
    p += std::min(kSpeed / std::hypot(1.0, per_polar * std::sin(p)), kSpinLimit / per_polar) / kRate_hz;
  }
  // From the lower pole up through +x to the upper one, where a quarter turn leads over to the circle through ±y.
  const double first_circle = per_polar * kPi;
  for (p = kPi; p < 5.0 * kPi; p += kSpeed / kRate_hz) {
    polar.push_back(p);
    const double quarter = std::clamp((p - 2.75 * kPi) / (0.5 * kPi), 0.0, 1.0);
    azimuth.push_back(first_circle + 0.5 * kPi * quarter);
  }
  hold(kTurn, 5.0 * kPi, first_circle + 0.5 * kPi);
  Path path;
  path.end = static_cast<double>(polar.size() - 1) / kRate_hz;
  path.polar = SampledCurve(polar, kRate_hz, kPass_hz);
  path.azimuth = SampledCurve(azimuth, kRate_hz, kPass_hz);
  return path;
}

const Path& path() {
  static const Path path = make_path();
  return path;
}

}  // namespace

double range_seconds() {
  return path().end;
}

QuaternionJet range_rotation(double time_s, const Quaterniond& R_WS_rest) {
  const QuaternionJet R_SW =
      rotation(Vector3d::UnitZ(), path().azimuth.at(time_s)) * rotation(Vector3d::UnitY(), path().polar.at(time_s));
  QuaternionJet rest;
  rest.v = R_WS_rest;
  if (time_s < 0.5 * path().end) {
    return blend(rest, conjugate(R_SW), smooth_step(time_s, 0.0, kTurn));
  }
  return blend(conjugate(R_SW), rest, smooth_step(time_s, path().end - kTurn, kTurn));
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
