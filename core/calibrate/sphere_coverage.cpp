#include "calibrate/sphere_coverage.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "geometry/so3.h"

namespace limbwave::calibrate {
namespace {

using Eigen::Vector3d;

// A band of a sphere has an area proportional to its height, so a band's height goes with its number of cells.
constexpr std::array<int, 6> kBandCells = {4, 8, 12, 12, 8, 4};
constexpr double kHeightPerCell = 2.0 / SphereCoverage::kCells;

}  // namespace

int SphereCoverage::cell_of(const Vector3d& direction) {
  const Vector3d u = direction.normalized();
  double bottom = -1.0;
  int first = 0;
  for (std::size_t band = 0; band < kBandCells.size(); ++band) {
    const int cells = kBandCells[band];
    bottom += kHeightPerCell * cells;
    if (u.z() < bottom || band + 1 == kBandCells.size()) {
      const double turn = std::atan2(u.y(), u.x()) / (2.0 * kPi) + 0.5;
      return first + std::clamp(static_cast<int>(turn * cells), 0, cells - 1);
    }
    first += cells;
  }
  return kCells - 1;
}

Vector3d SphereCoverage::centre(int cell) {
  double bottom = -1.0;
  int first = 0;
  for (const int cells : kBandCells) {
    if (cell < first + cells) {
      const double z = bottom + 0.5 * kHeightPerCell * cells;
      const double azimuth = ((cell - first + 0.5) / cells - 0.5) * 2.0 * kPi;
      const double r = std::sqrt(1.0 - z * z);
      return {r * std::cos(azimuth), r * std::sin(azimuth), z};
    }
    bottom += kHeightPerCell * cells;
    first += cells;
  }
  return Vector3d::UnitZ();
}

void SphereCoverage::add(const Vector3d& direction, double seconds) {
  if (direction.allFinite() && direction.squaredNorm() > 0.0) {
    seconds_[static_cast<std::size_t>(cell_of(direction))] += seconds;
  }
}

double SphereCoverage::fraction() const {
  const auto visited_cells = std::count_if(seconds_.begin(), seconds_.end(), [&](double s) { return s >= enough_s_; });
  return static_cast<double>(visited_cells) / kCells;
}

double SphereCoverage::distance_to_visited(int cell) const {
  double nearest = kPi;
  for (int other = 0; other < kCells; ++other) {
    if (visited(other)) {
      nearest = std::min(nearest, geometry::angle_between(centre(cell), centre(other)));
    }
  }
  return nearest;
}

std::vector<Vector3d> SphereCoverage::missing() const {
  std::vector<std::pair<double, int>> cells;
  for (int cell = 0; cell < kCells; ++cell) {
    if (!visited(cell)) {
      cells.emplace_back(-distance_to_visited(cell), cell);
    }
  }
  std::sort(cells.begin(), cells.end());
  std::vector<Vector3d> directions;
  directions.reserve(cells.size());
  for (const auto& [distance, cell] : cells) {
    directions.push_back(centre(cell));
  }
  return directions;
}

double SphereCoverage::largest_hole() const {
  double hole = 0.0;
  for (int cell = 0; cell < kCells; ++cell) {
    hole = std::max(hole, distance_to_visited(cell));
  }
  return hole;
}

std::string direction_words(const Vector3d& up_S) {
  const Vector3d u = up_S.normalized();
  std::array<int, 3> order = {0, 1, 2};
  std::sort(order.begin(), order.end(), [&](int a, int b) { return std::abs(u[a]) > std::abs(u[b]); });
  const auto axis = [&](int i) { return std::string(u[i] < 0.0 ? "−" : "+") + "xyz"[i]; };
  // Within about 25° of an axis its name alone says it well enough.
  if (std::abs(u[order[0]]) > 0.9) {
    return axis(order[0]) + " up";
  }
  if (std::abs(u[order[2]]) > 0.4) {
    return "the corner of " + axis(0) + ", " + axis(1) + " and " + axis(2) + " up";
  }
  return "between " + axis(std::min(order[0], order[1])) + " and " + axis(std::max(order[0], order[1])) + " up";
}

}  // namespace limbwave::calibrate
