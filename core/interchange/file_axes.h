/// Between the world of core/ (z up, figures facing −y) and files with Y up (figures facing +Z): v_F = (x, z, −y) of
/// v_W. This is what Blender does too, so a figure arrives there as it stands here.
#pragma once

#include <Eigen/Geometry>

namespace limbwave::interchange {

inline Eigen::Vector3d to_y_up(const Eigen::Vector3d& v_W) {
  return {v_W.x(), v_W.z(), -v_W.y()};
}
inline Eigen::Vector3d from_y_up(const Eigen::Vector3d& v_F) {
  return {v_F.x(), -v_F.z(), v_F.y()};
}

/// The same rotation seen in the other axes: both its sides change.
inline Eigen::Quaterniond to_y_up(const Eigen::Quaterniond& R) {
  return {R.w(), R.x(), R.z(), -R.y()};
}
inline Eigen::Quaterniond from_y_up(const Eigen::Quaterniond& R) {
  return {R.w(), R.x(), -R.z(), R.y()};
}

}  // namespace limbwave::interchange
