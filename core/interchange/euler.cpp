#include "interchange/euler.h"

#include <cmath>

#include "base/units.h"

namespace limbwave::interchange {
namespace {

// Closer than this to gimbal lock (cosine of the middle angle) the first angle is lost in rounding.
constexpr double kGimbalLock = 1e-9;

double nearest_turn(double angle, double previous) {
  return angle + 2.0 * kPi * std::round((previous - angle) / (2.0 * kPi));
}

}  // namespace

Eigen::Quaterniond from_euler(const EulerAngles& angles, const EulerOrder& order) {
  Eigen::Quaterniond R = Eigen::Quaterniond::Identity();
  for (std::size_t i = 0; i < 3; ++i) {
    R = R * Eigen::Quaterniond(Eigen::AngleAxisd(angles[i], Eigen::Vector3d::Unit(order[i])));
  }
  return R;
}

EulerAngles to_euler(const Eigen::Quaterniond& R, const EulerOrder& order, const EulerAngles& previous) {
  const int i = order[0];
  const int j = order[1];
  const int k = order[2];
  const double sign = (j - i + 3) % 3 == 1 ? 1.0 : -1.0;  // +1 for xyz, yzx, zxy
  const Eigen::Matrix3d M = R.normalized().toRotationMatrix();
  // Column k is R_i R_j e_k: its length outside axis i is the cosine of the middle angle.
  double a = previous[0];
  double cos_a = 0.0;
  double sin_a = 0.0;
  if (const double cos_b = std::hypot(M(j, k), M(k, k)); cos_b > kGimbalLock) {
    cos_a = M(k, k) / cos_b;
    sin_a = -sign * M(j, k) / cos_b;
    a = std::atan2(sin_a, cos_a);
  } else {
    cos_a = std::cos(a);
    sin_a = std::sin(a);
  }
  // With the first rotation taken off (R_i(-a) M), the other two come from entries that never vanish together, so that
  // what rounding does to `a` near gimbal lock is made good by `c`.
  const auto row_j = [&](int column) { return cos_a * M(j, column) + sign * sin_a * M(k, column); };
  const double rest_kk = cos_a * M(k, k) - sign * sin_a * M(j, k);
  const double b = std::atan2(sign * M(i, k), rest_kk);
  const double c = std::atan2(sign * row_j(i), row_j(j));

  const EulerAngles branches[2] = {{a, b, c}, {a + kPi, kPi - b, c + kPi}};
  EulerAngles best{};
  double best_change = INFINITY;
  for (const EulerAngles& branch : branches) {
    EulerAngles turned{};
    double change = 0.0;
    for (std::size_t n = 0; n < 3; ++n) {
      turned[n] = nearest_turn(branch[n], previous[n]);
      change += std::abs(turned[n] - previous[n]);
    }
    if (change < best_change) {
      best_change = change;
      best = turned;
    }
  }
  return best;
}

}  // namespace limbwave::interchange
