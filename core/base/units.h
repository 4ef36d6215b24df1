/// Physical constants and the few conversions that borders need. Inside core/ everything is SI and radians.
#pragma once

#include <numbers>

namespace limbwave {

/// Standard gravity, m/s² (CGPM 1901). A resting accelerometer reads this much, upward.
inline constexpr double kStandardGravity = 9.80665;

inline constexpr double kPi = std::numbers::pi;

constexpr double radians(double degrees) {
  return degrees * (kPi / 180.0);
}
constexpr double degrees(double radians) {
  return radians * (180.0 / kPi);
}

}  // namespace limbwave
