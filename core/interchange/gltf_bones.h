/// Which nodes of a glTF scene are bones, and where they are at rest. Used by readers and writers alone.
#pragma once

#include <tiny_gltf.h>

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/result.h"
#include "body/skeleton.h"

namespace limbwave::interchange {

/// A bone's length in the extras of its node, for which glTF has no place; in the file's unit, metres as it was
/// written.
inline constexpr const char* kGltfLength = "length_m";

/// A place with a scale, the same in all directions, in the file's axes.
struct Similarity {
  Eigen::Quaterniond R = Eigen::Quaterniond::Identity();
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  double scale = 1.0;

  [[nodiscard]] Similarity operator*(const Similarity& other) const {
    return {(R * other.R).normalized(), p + scale * (R * other.p), scale * other.scale};
  }
  [[nodiscard]] Similarity inverse() const {
    const Eigen::Quaterniond back = R.conjugate();
    return {back, -(back * p) / scale, 1.0 / scale};
  }
};

/// A 4 × 4 matrix, column by column, as a similarity; its scales are averaged, and `is_uniform` says whether they were
/// one. Not finite or without volume: nothing is to be made of it, and the scale is 0.
Similarity similarity_of(const Eigen::Matrix4d& matrix, bool& is_uniform);

/// One tree of bones.
struct GltfTree {
  std::vector<int> nodes;      ///< Node of every segment, parents first.
  body::Skeleton skeleton;     ///< In z up and metres; frames as in the file.
  Similarity above;            ///< Of what stands still above the root, in the file's axes.
  std::vector<double> scales;  ///< World scale of every segment's parent (root: of `above`).
};

/// All trees of bones of a model. Fails on nodes that are their own ancestors, have two parents or do not exist.
Result<std::vector<GltfTree>> gltf_trees(const tinygltf::Model& model, const std::string& place,
                                         Diagnostics& diagnostics);

/// World place of every node at rest, in the file's axes; call it only when `gltf_trees` succeeded.
std::vector<Similarity> gltf_world(const tinygltf::Model& model);

}  // namespace limbwave::interchange
