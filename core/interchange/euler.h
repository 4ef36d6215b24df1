/// Euler angles of files: any order of three different axes, taken from rotations without jumps.
#pragma once

#include <Eigen/Geometry>
#include <array>

namespace limbwave::interchange {

/// Three axes (0 = x, 1 = y, 2 = z), all different, in the order in which the rotations are multiplied:
/// R = R_axis0(a0) · R_axis1(a1) · R_axis2(a2).
using EulerOrder = std::array<int, 3>;
inline constexpr EulerOrder kZXY = {2, 0, 1};
inline constexpr EulerOrder kZYX = {2, 1, 0};

/// Angles in radians, in the order of the axes.
using EulerAngles = std::array<double, 3>;

Eigen::Quaterniond from_euler(const EulerAngles& angles, const EulerOrder& order);

/// The angles of `R` nearest to `previous`: of both solutions, each moved by whole turns, the one with the smallest sum
/// of changes. In gimbal lock, where only the sum or difference of the outer angles is determined, the first stays at
/// its previous value. Interpolating the angles between keys then follows the motion instead of spinning.
EulerAngles to_euler(const Eigen::Quaterniond& R, const EulerOrder& order, const EulerAngles& previous = {0, 0, 0});

}  // namespace limbwave::interchange
