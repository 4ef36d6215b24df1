/// Meshes of other programs, to be skinned.
#pragma once

#include <filesystem>
#include <memory>

#include "base/progress.h"
#include "base/result.h"
#include "motion/clip.h"
#include "motion/skinning.h"

namespace limbwave::interchange {

/// All triangles of a glTF, FBX or OBJ file as one mesh in W (the file's Y up and facing +Z, as far as it says so), in
/// the file's own unit of length: `motion::fitted` gives it its size. Fails in one line on what cannot be read, has no
/// triangles, or has more than ten million.
Result<motion::TriangleMesh> load_mesh(const std::filesystem::path& path);

/// The mesh of a file fitted and skinned to a clip's skeleton, which is put into the pose in which meshes are made: a
/// T-pose for a person, its rest pose for what is none. Fails as `load_mesh` and `motion::skinned` do.
Result<std::shared_ptr<const motion::SkinnedMesh>> skinned_mesh_file(const std::filesystem::path& path,
                                                                     const motion::Clip& clip,
                                                                     const Progress& progress = {});

}  // namespace limbwave::interchange
