/// Between the world of core/ (z up, figures at rest face +x with their left towards +y) and the world of files (Y up,
/// figures face +Z with their left towards +X, as glTF and most BVH files have it): v_F = (y, z, x) of v_W.
/// Blender, whose figures face −y, shows such a file at (y, −x, z) of v_W.
#pragma once

#include <Eigen/Geometry>

namespace limbwave::interchange {

inline Eigen::Vector3d to_y_up(const Eigen::Vector3d& v_W) {
  return {v_W.y(), v_W.z(), v_W.x()};
}
inline Eigen::Vector3d from_y_up(const Eigen::Vector3d& v_F) {
  return {v_F.z(), v_F.x(), v_F.y()};
}

/// The same rotation seen in the other axes: both its sides change.
inline Eigen::Quaterniond to_y_up(const Eigen::Quaterniond& R) {
  return {R.w(), R.y(), R.z(), R.x()};
}
inline Eigen::Quaterniond from_y_up(const Eigen::Quaterniond& R) {
  return {R.w(), R.z(), R.x(), R.y()};
}

}  // namespace limbwave::interchange
