/// Meshes of other programs, to be skinned.
#pragma once

#include <filesystem>

#include "base/result.h"
#include "motion/skinning.h"

namespace limbwave::interchange {

/// All triangles of a glTF, FBX or OBJ file as one mesh in W (the file's Y up and facing +Z, as far as it says so), in
/// the file's own unit of length: `motion::fitted` gives it its size. Fails in one line on what cannot be read, has no
/// triangles, or has more than ten million.
Result<motion::TriangleMesh> load_mesh(const std::filesystem::path& path);

}  // namespace limbwave::interchange
