/// The camera of the viewer: turns about a target, z up. Pure arithmetic, so that it is tested without a window.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <vector>

namespace limbwave::ui {

enum class ViewDirection { kFront, kSide, kTop, kThreeQuarter };

/// Where a pixel looks: a point and a unit direction in the world.
struct ViewRay {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
};

/// A perspective camera that looks at `target` from `distance` metres. Yaw is measured about the vertical from +x,
/// pitch is positive when the camera is above the target; radians. Pixels have their origin at the top left.
class OrbitCamera {
 public:
  [[nodiscard]] const Eigen::Vector3d& target() const { return target_; }
  [[nodiscard]] double distance() const { return distance_; }
  [[nodiscard]] double yaw() const { return yaw_; }
  [[nodiscard]] double pitch() const { return pitch_; }
  [[nodiscard]] double vertical_field() const { return vertical_field_; }

  [[nodiscard]] Eigen::Vector3d position() const;
  [[nodiscard]] Eigen::Vector3d right() const;    ///< Unit vector to the right in the picture.
  [[nodiscard]] Eigen::Vector3d up() const;       ///< Unit vector upwards in the picture.
  [[nodiscard]] Eigen::Vector3d forward() const;  ///< Unit vector into the picture.
  [[nodiscard]] double near_plane() const;
  [[nodiscard]] double far_plane() const;

  /// Turns by angles; the pitch stops short of the poles.
  void orbit(double yaw_change, double pitch_change);
  /// Moves the target so that a point at its depth follows the pointer by (dx, dy) pixels in a picture that is
  /// `height` pixels high.
  void pan(double dx, double dy, double height);
  /// Divides the distance by `factor` (> 1 comes nearer), within limits.
  void zoom(double factor);
  /// Moves along with something: the same way and distance, another target.
  void follow(const Eigen::Vector3d& target) { target_ = target; }
  /// Looks along an axis, keeping target and distance.
  void look(ViewDirection direction);
  /// Centres on a sphere and goes as far away as it needs to be seen whole. Asserts that aspect (width / height) > 0.
  void frame(const Eigen::Vector3d& centre, double radius, double aspect);

  /// Goes to where all points are seen, as near as that allows and in the middle, looking the same way.
  void frame(const std::vector<Eigen::Vector3d>& points, double aspect);

  /// The ray through a pixel of a picture of this size.
  [[nodiscard]] ViewRay ray(const Eigen::Vector2d& pixel, const Eigen::Vector2d& size) const;
  /// The pixel of a point; empty behind the near plane.
  [[nodiscard]] std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& point, const Eigen::Vector2d& size) const;

 private:
  Eigen::Vector3d target_ = Eigen::Vector3d(0.0, 0.0, 1.0);
  double distance_ = 3.0;
  double yaw_ = 0.6;
  double pitch_ = 0.3;
  double vertical_field_ = 0.6;  ///< Whole vertical opening, radians.
};

}  // namespace limbwave::ui
