/// A closed surface that can be asked what it hides. Used by skinning alone.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace limbwave::motion {

class Surface {
 public:
  /// Keeps references: both must outlive it.
  Surface(const std::vector<Eigen::Vector3d>& positions, const std::vector<std::array<std::uint32_t, 3>>& triangles);
  ~Surface();
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;

  /// Whether the way from vertex `from` to the point `to` stays inside: it starts inwards and meets no triangle but
  /// those of the vertex.
  [[nodiscard]] bool sees(std::uint32_t from, const Eigen::Vector3d& to) const;

 private:
  struct Tree;
  const std::vector<Eigen::Vector3d>& positions_;
  const std::vector<std::array<std::uint32_t, 3>>& triangles_;
  std::vector<Eigen::Vector3d> normals_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace limbwave::motion
