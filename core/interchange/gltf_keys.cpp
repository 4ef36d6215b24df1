#include "interchange/gltf_keys.h"

#include <cmath>
#include <limits>

#include "interchange/file_axes.h"

namespace limbwave::interchange {
namespace {

// Squares of lengths this near 1 are 1: far less than a float's last bit.
constexpr double kUnit = 1e-12;

}  // namespace

std::vector<float> gltf_times(const std::vector<double>& times) {
  std::vector<float> values;
  values.reserve(times.size());
  for (const double time : times) {
    auto value = static_cast<float>(time);
    if (!values.empty() && value <= values.back()) {
      value = std::nextafter(values.back(), std::numeric_limits<float>::infinity());
    }
    values.push_back(value);
  }
  return values;
}

std::vector<float> gltf_rotations(const std::vector<Eigen::Quaterniond>& rotations) {
  std::vector<float> values(rotations.size() * 4);
  GltfRotations()(rotations, values.data());
  return values;
}

void GltfRotations::operator()(std::span<const Eigen::Quaterniond> rotations, float* values) {
  Eigen::Vector4d previous = previous_;
  for (const Eigen::Quaterniond& R : rotations) {
    // Most are of length 1 already: roots and divisions would be half of the time.
    const double length2 = R.squaredNorm();
    const Eigen::Quaterniond unit = std::abs(length2 - 1.0) < kUnit ? R : R.normalized();
    Eigen::Vector4d q = to_y_up(unit).coeffs();
    if (q.dot(previous) < 0.0) {
      q = -q;
    }
    previous = q;
    Eigen::Vector4f::Map(values) = q.cast<float>();
    values += 4;
  }
  previous_ = previous;
}

std::vector<float> gltf_positions(const std::vector<Eigen::Vector3d>& positions) {
  std::vector<float> values(positions.size() * 3);
  gltf_positions(positions, values.data());
  return values;
}

void gltf_positions(std::span<const Eigen::Vector3d> positions, float* values) {
  for (const Eigen::Vector3d& p : positions) {
    Eigen::Vector3f::Map(values) = to_y_up(p).cast<float>();
    values += 3;
  }
}

std::vector<Eigen::Quaterniond> rotations_from_gltf(const std::vector<float>& values) {
  std::vector<Eigen::Quaterniond> rotations;
  rotations.reserve(values.size() / 4);
  for (std::size_t i = 0; i + 3 < values.size(); i += 4) {
    const Eigen::Quaterniond q(values[i + 3], values[i], values[i + 1], values[i + 2]);
    rotations.push_back(from_y_up(q).normalized());
  }
  return rotations;
}

std::vector<Eigen::Vector3d> positions_from_gltf(const std::vector<float>& values) {
  std::vector<Eigen::Vector3d> positions;
  positions.reserve(values.size() / 3);
  for (std::size_t i = 0; i + 2 < values.size(); i += 3) {
    positions.push_back(from_y_up(Eigen::Vector3d(values[i], values[i + 1], values[i + 2])));
  }
  return positions;
}

}  // namespace limbwave::interchange
