#include "interchange/gltf_keys.h"

#include <cmath>
#include <limits>

#include "interchange/file_axes.h"

namespace limbwave::interchange {

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
  std::vector<float> values;
  values.reserve(rotations.size() * 4);
  Eigen::Quaterniond previous = Eigen::Quaterniond::Identity();
  for (const Eigen::Quaterniond& R : rotations) {
    Eigen::Quaterniond q = to_y_up(R.normalized());
    if (q.dot(previous) < 0.0) {
      q.coeffs() *= -1.0;
    }
    previous = q;
    for (const double component : {q.x(), q.y(), q.z(), q.w()}) {
      values.push_back(static_cast<float>(component));
    }
  }
  return values;
}

std::vector<float> gltf_positions(const std::vector<Eigen::Vector3d>& positions) {
  std::vector<float> values;
  values.reserve(positions.size() * 3);
  for (const Eigen::Vector3d& p_W : positions) {
    const Eigen::Vector3d p = to_y_up(p_W);
    for (const double component : {p.x(), p.y(), p.z()}) {
      values.push_back(static_cast<float>(component));
    }
  }
  return values;
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
