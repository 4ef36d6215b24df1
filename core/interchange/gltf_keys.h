/// Keys as glTF stores them: 32-bit floats, Y up. The writer and the reader, which compares, must agree bit for bit.
#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

namespace limbwave::interchange {

/// Key times, made strictly increasing where two doubles are one float.
std::vector<float> gltf_times(const std::vector<double>& times);
/// Unit quaternions x, y, z, w with signs chosen so that neighbours are close.
std::vector<float> gltf_rotations(const std::vector<Eigen::Quaterniond>& rotations);
std::vector<float> gltf_positions(const std::vector<Eigen::Vector3d>& positions);
/// The same for a part of them, to where there is room for three numbers each.
void gltf_positions(std::span<const Eigen::Vector3d> positions, float* values);
/// The same as gltf_rotations, part after part.
class GltfRotations {
 public:
  /// Writes four numbers for each.
  void operator()(std::span<const Eigen::Quaterniond> rotations, float* values);

 private:
  Eigen::Vector4d previous_{0.0, 0.0, 0.0, 1.0};
};

/// The way back, to z up; quaternions are normalised.
std::vector<Eigen::Quaterniond> rotations_from_gltf(const std::vector<float>& values);
std::vector<Eigen::Vector3d> positions_from_gltf(const std::vector<float>& values);

}  // namespace limbwave::interchange
