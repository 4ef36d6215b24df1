/// Animations of other programs, whatever their format.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/result.h"
#include "motion/clip.h"

namespace limbwave::interchange {

/// Endings of the files that `load_animation` reads, with their dots, in small letters.
const std::vector<std::string>& animation_endings();

/// Whether a file's name has one of these endings, whatever its case.
bool is_animation_file(const std::filesystem::path& path);

/// All movements of a .bvh, .fbx, .glb, .gltf or .vrm file, at least one: of a BVH file in the unit that its skeleton's
/// size suggests, of a take's own solve (.glb) exactly as it was kept. Clips without a name get the file's. Fails in
/// one line, with the place in the file, on what cannot be read; other endings are refused.
Result<std::vector<motion::Clip>> load_animation(const std::filesystem::path& path, Diagnostics* diagnostics = nullptr);

}  // namespace limbwave::interchange
