/// Skinned meshes of a glTF file. Used by the reader alone.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "interchange/gltf_bones.h"
#include "interchange/gltf_model.h"
#include "motion/skinned_mesh.h"

namespace limbwave::interchange {

using GltfMeshes = std::vector<std::shared_ptr<const motion::SkinnedMesh>>;

/// The meshes whose skin hangs on the tree, all triangles of a mesh as one, in z up and metres as they are when bound.
/// Fails, with the place, on accessors that do not fit together.
Result<GltfMeshes> gltf_meshes(const tinygltf::Model& model, const GltfTree& tree, const std::string& place,
                               Diagnostics& diagnostics);

}  // namespace limbwave::interchange
