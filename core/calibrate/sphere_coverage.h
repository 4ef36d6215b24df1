/// Which directions of gravity a sensor has been held in, on a sphere cut into cells of equal area.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

namespace limbwave::calibrate {

/// 48 cells of equal area in six bands about the sensor's z axis (4, 8, 12, 12, 8, 4 cells), each about 30° wide.
class SphereCoverage {
 public:
  static constexpr int kCells = 48;

  /// `enough_s`: time of steady readings after which a cell counts as visited, seconds.
  explicit SphereCoverage(double enough_s = 0.1) : enough_s_(enough_s) {}

  /// Index of the cell that holds a direction; need not have unit length, must not be zero.
  static int cell_of(const Eigen::Vector3d& direction);
  /// Direction to a cell's middle, unit length.
  static Eigen::Vector3d centre(int cell);

  /// Counts `seconds` of steady readings in a direction.
  void add(const Eigen::Vector3d& direction, double seconds);
  [[nodiscard]] bool visited(int cell) const { return seconds_.at(static_cast<std::size_t>(cell)) >= enough_s_; }
  [[nodiscard]] double seconds(int cell) const { return seconds_.at(static_cast<std::size_t>(cell)); }
  /// Fraction of the sphere that was visited, 0..1.
  [[nodiscard]] double fraction() const;
  /// Middles of the cells that were not visited, the one furthest from every visited cell first.
  [[nodiscard]] std::vector<Eigen::Vector3d> missing() const;
  /// Largest angle from the middle of any cell to the nearest visited one, radians; π when none was visited.
  [[nodiscard]] double largest_hole() const;

 private:
  [[nodiscard]] double distance_to_visited(int cell) const;
  double enough_s_;
  std::array<double, kCells> seconds_{};
};

/// How to hold a sensor so that `up_S` points up, by its axes: "+x up", "between +x and −z up".
std::string direction_words(const Eigen::Vector3d& up_S);

}  // namespace limbwave::calibrate
