/// Triangle meshes that follow a skeleton.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "body/skeleton.h"

namespace limbwave::motion {

/// At most four segments move a vertex; unused places have weight 0 (and segment 0).
inline constexpr std::size_t kInfluences = 4;

/// A mesh as it lies in the world frame W (metres, Z up) when it is bound to the skeleton.
struct SkinnedMesh {
  std::string name;
  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector3f> normals;                          ///< Unit length, one per vertex; or empty.
  std::vector<std::array<std::uint32_t, 3>> triangles;           ///< Counter-clockwise seen from outside.
  std::vector<std::array<std::uint16_t, kInfluences>> segments;  ///< One per vertex: indices of skeleton segments.
  std::vector<std::array<float, kInfluences>> weights;           ///< One per vertex: not negative, sum 1.
  /// World poses of all segments when bound; empty: the skeleton's rest poses.
  std::vector<body::SegmentPose> bind_poses;
};

/// Vertices in W when the segments have `poses`: linear blend skinning. Asserts that the mesh is valid for as many
/// segments as there are poses.
std::vector<Eigen::Vector3f> deformed(const SkinnedMesh& mesh, const body::Skeleton& skeleton,
                                      const std::vector<body::SegmentPose>& poses);

/// Whether sizes fit together, indices exist, numbers are finite, and weights sum to 1 within 1e-4. Errors name the
/// mesh and the first wrong element.
Status validate(const SkinnedMesh& mesh, const body::Skeleton& skeleton);

}  // namespace limbwave::motion
