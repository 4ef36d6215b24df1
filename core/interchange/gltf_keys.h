/// Keys as glTF stores them: 32-bit floats, Y up. The writer and the reader, which compares, must agree bit for bit.
#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace limbwave::interchange {

/// Key times, made strictly increasing where two doubles are one float.
std::vector<float> gltf_times(const std::vector<double>& times);
/// Unit quaternions x, y, z, w with signs chosen so that neighbours are close.
std::vector<float> gltf_rotations(const std::vector<Eigen::Quaterniond>& rotations);
std::vector<float> gltf_positions(const std::vector<Eigen::Vector3d>& positions);

/// The way back, to z up; quaternions are normalised.
std::vector<Eigen::Quaterniond> rotations_from_gltf(const std::vector<float>& values);
std::vector<Eigen::Vector3d> positions_from_gltf(const std::vector<float>& values);

}  // namespace limbwave::interchange
