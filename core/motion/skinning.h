/// Automatic skinning: how much every bone moves every vertex of a mesh.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "motion/skinned_mesh.h"

namespace limbwave::motion {

/// A surface in W, metres.
struct TriangleMesh {
  std::string name;
  std::vector<Eigen::Vector3f> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Counter-clockwise seen from outside.
};

struct SkinningOptions {
  /// How strongly the nearest bone heats a vertex (c of the source); more: stiffer limbs, shorter blends.
  double heat = 1.0;
};

/// The mesh skinned to the skeleton that stands inside it in the pose `bind`: bone heat of Baran & Popović, Automatic
/// rigging and animation of 3D characters (2007), §4. Every bone is held at 1 inside and 0 elsewhere, and heat spreads
/// over the surface: (L + M H) w = M H p, with the cotangent Laplacian L, the vertex areas M, and H = c / d² for a
/// vertex that sees its nearest bone at distance d, else 0. One sparse Cholesky factorisation serves all bones.
/// Vertices at one place count as one, so that seams of texture stay closed. At most four influences, weights not
/// negative and of sum 1. Parts of the surface that see no bone take the nearest one.
/// Fails when there are no triangles or bones, indices or numbers are wrong, the equations cannot be solved, or when
/// cancelled.
Result<SkinnedMesh> skinned(const TriangleMesh& mesh, const body::Skeleton& skeleton,
                            const std::vector<body::SegmentPose>& bind, const SkinningOptions& options = {},
                            const Progress& progress = {});

/// The mesh around the skeleton in the pose `bind`: as it is when it stands there already, else scaled to the
/// skeleton's height and moved over its feet. For meshes whose unit or place is not the skeleton's.
TriangleMesh fitted(TriangleMesh mesh, const std::vector<body::SegmentPose>& bind);

}  // namespace limbwave::motion
