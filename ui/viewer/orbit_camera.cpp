#include "viewer/orbit_camera.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace limbwave::ui {

namespace {

constexpr double kNearest = 0.05;  // Metres; nearer than a hand is wide there is nothing to see.
constexpr double kFarthest = 60.0;
constexpr double kPole = std::numbers::pi / 2 - 1e-3;  // At the pole itself "right" would have no meaning.

}  // namespace

Eigen::Vector3d OrbitCamera::forward() const {
  return {-std::cos(pitch_) * std::cos(yaw_), -std::cos(pitch_) * std::sin(yaw_), -std::sin(pitch_)};
}

Eigen::Vector3d OrbitCamera::right() const {
  return {-std::sin(yaw_), std::cos(yaw_), 0.0};
}

Eigen::Vector3d OrbitCamera::up() const {
  return right().cross(forward());
}

Eigen::Vector3d OrbitCamera::position() const {
  return target_ - distance_ * forward();
}

double OrbitCamera::near_plane() const {
  return std::max(0.005, 0.02 * distance_);
}

double OrbitCamera::far_plane() const {
  return distance_ + 40.0;
}

void OrbitCamera::orbit(double yaw_change, double pitch_change) {
  yaw_ = std::remainder(yaw_ + yaw_change, 2 * std::numbers::pi);
  pitch_ = std::clamp(pitch_ + pitch_change, -kPole, kPole);
}

void OrbitCamera::pan(double dx, double dy, double height) {
  assert(height > 0);
  const double metres_per_pixel = 2 * distance_ * std::tan(vertical_field_ / 2) / height;
  target_ += metres_per_pixel * (-dx * right() + dy * up());
}

void OrbitCamera::zoom(double factor) {
  assert(factor > 0);
  distance_ = std::clamp(distance_ / factor, kNearest, kFarthest);
}

void OrbitCamera::look(ViewDirection direction) {
  switch (direction) {
    case ViewDirection::kFront:
      yaw_ = 0.0;
      pitch_ = 0.0;
      break;
    case ViewDirection::kSide:
      yaw_ = -std::numbers::pi / 2;
      pitch_ = 0.0;
      break;
    case ViewDirection::kTop:
      yaw_ = std::numbers::pi;
      pitch_ = kPole;
      break;
    case ViewDirection::kThreeQuarter:
      yaw_ = -0.65;
      pitch_ = 0.28;
      break;
  }
}

void OrbitCamera::frame(const Eigen::Vector3d& centre, double radius, double aspect) {
  assert(aspect > 0);
  // The narrower opening decides; a sphere just touches the edges when sin(opening / 2) = radius / distance.
  const double half_vertical = vertical_field_ / 2;
  const double half_horizontal = std::atan(aspect * std::tan(half_vertical));
  target_ = centre;
  const double margin = 1.08;
  distance_ = std::clamp(margin * radius / std::sin(std::min(half_vertical, half_horizontal)), 4 * kNearest, kFarthest);
}

void OrbitCamera::frame(const std::vector<Eigen::Vector3d>& points, double aspect) {
  assert(aspect > 0);
  if (points.empty()) {
    return;
  }
  constexpr double kMargin = 1.15;
  const double slope_up = std::tan(vertical_field_ / 2) / kMargin;
  const double slope_right = aspect * slope_up;
  Eigen::Matrix3d R_VW;
  R_VW << right().transpose(), up().transpose(), forward().transpose();
  // Seen from the camera every edge of the picture is a plane; the two opposite planes that just hold all points meet
  // in a line, which says where the camera may stand. Of the two pairs the farther one decides.
  double right_high = -1e300, right_low = -1e300, up_high = -1e300, up_low = -1e300;
  double depth_sum = 0.0;
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3d v = R_VW * point;
    right_high = std::max(right_high, v.x() - slope_right * v.z());
    right_low = std::max(right_low, -v.x() - slope_right * v.z());
    up_high = std::max(up_high, v.y() - slope_up * v.z());
    up_low = std::max(up_low, -v.y() - slope_up * v.z());
    depth_sum += v.z();
  }
  const double camera_depth =
      std::min(-(right_high + right_low) / (2 * slope_right), -(up_high + up_low) / (2 * slope_up));
  const Eigen::Vector3d camera_V((right_high - right_low) / 2, (up_high - up_low) / 2, camera_depth);
  distance_ = std::clamp(depth_sum / static_cast<double>(points.size()) - camera_depth, 4 * kNearest, kFarthest);
  target_ = R_VW.transpose() * (camera_V + Eigen::Vector3d(0, 0, distance_));
}

ViewRay OrbitCamera::ray(const Eigen::Vector2d& pixel, const Eigen::Vector2d& size) const {
  const double scale = 2 * std::tan(vertical_field_ / 2) / size.y();
  const double x = (pixel.x() - size.x() / 2) * scale;
  const double y = (size.y() / 2 - pixel.y()) * scale;
  return {position(), (forward() + x * right() + y * up()).normalized()};
}

std::optional<Eigen::Vector2d> OrbitCamera::project(const Eigen::Vector3d& point, const Eigen::Vector2d& size) const {
  const Eigen::Vector3d from_camera = point - position();
  const double depth = from_camera.dot(forward());
  if (depth < near_plane()) {
    return std::nullopt;
  }
  const double scale = size.y() / (2 * std::tan(vertical_field_ / 2) * depth);
  return Eigen::Vector2d(size.x() / 2 + scale * from_camera.dot(right()), size.y() / 2 - scale * from_camera.dot(up()));
}

}  // namespace limbwave::ui
