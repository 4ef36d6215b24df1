/// Vectors and quaternions in JSON files of this folder and its users.
#pragma once

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/json_reader.h"

namespace limbwave::body {

inline Eigen::Vector3d read_vector(const JsonReader& reader) {
  const std::vector<double> v = reader.numbers(3);
  return {v[0], v[1], v[2]};
}

/// A direction: refused when its length is zero, normalised otherwise.
inline Eigen::Vector3d read_direction(const JsonReader& reader) {
  const Eigen::Vector3d v = read_vector(reader);
  if (!(v.norm() > 1e-9)) {
    reader.fail("is not a direction: its length is zero");
    return Eigen::Vector3d::UnitX();
  }
  return std::abs(v.squaredNorm() - 1.0) > 1e-15 ? Eigen::Vector3d(v.normalized()) : v;
}

/// [w, x, y, z]; refused when not of unit length within 1 %, normalised otherwise.
inline Eigen::Quaterniond read_quaternion(const JsonReader& reader) {
  const std::vector<double> q = reader.numbers(4);
  Eigen::Quaterniond quaternion(q[0], q[1], q[2], q[3]);
  if (std::abs(quaternion.norm() - 1.0) > 0.01) {
    reader.fail("is not a rotation: a quaternion [w, x, y, z] has length 1");
    return Eigen::Quaterniond::Identity();
  }
  // A quaternion that is unit to rounding is taken as it stands, so that a file read and written again is the same.
  if (std::abs(quaternion.squaredNorm() - 1.0) > 1e-15) {
    quaternion.normalize();
  }
  return quaternion;
}

inline nlohmann::json to_json(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}
inline nlohmann::json to_json(const Eigen::Quaterniond& q) {
  return {q.w(), q.x(), q.y(), q.z()};
}

/// Resolves "NAME" to FOLDER/NAME.json among the shipped files, or takes an existing path as it is.
std::string shipped_or_path(const std::string& folder, const std::string& name_or_path);
/// Names of the shipped files of a folder, sorted.
std::vector<std::string> shipped_names(const std::string& folder);

}  // namespace limbwave::body
