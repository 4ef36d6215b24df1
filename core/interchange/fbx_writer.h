/// Clips as binary FBX 7.4, for Blender, Maya, MotionBuilder, Unreal and Unity.
#pragma once

#include <filesystem>
#include <span>

#include "base/progress.h"
#include "base/result.h"
#include "interchange/fbx_keys.h"
#include "motion/clip.h"

namespace limbwave::interchange {

/// The file's world: Y up with figures facing +Z, or Z up with figures facing −Y.
enum class FbxUpAxis { kY, kZ };

struct FbxWriteOptions {
  /// Keys at this many frames a second instead of the clips' own; 0: the clips' own keys. The declared frame rate is
  /// this, or that of the first clip; 23.976 means 24/1.001 and so on.
  double fps = 0.0;
  FbxKeyMode keys = FbxKeyMode::kDense;
  FbxUpAxis up = FbxUpAxis::kY;
  /// Length of the file's unit; the file says so (UnitScaleFactor). Unreal wants centimetres.
  double metres_per_unit = 0.01;
};

/// Writes one file with all clips as actors of one scene, all-or-nothing: LimbNode bones in a tree per clip with their
/// rest pose (PreRotation) and names, made unique across the file; the clips' skinned meshes with clusters and bind
/// pose; one animation stack, named as the first clip. Clips without keys give no animation. Memory beyond the clips'
/// own is bounded by the curves of one joint. Independent of locale.
/// A bone's own axes are those of its frame L, as in our glTF: the file's z is L's x (file_axes.h).
/// Blender makes bones at least 0.01 file units long and turns shorter ones by up to a milliradian: skeletons with
/// joints that coincide come right there in metres only.
/// Fails when there is no clip, a clip is not valid (clip_check.h), a mesh is not, the frame rate is not positive, the
/// file would exceed 4 GB, cannot be written, or when cancelled.
Status write_fbx(std::span<const motion::Clip* const> clips, const std::filesystem::path& path,
                 const FbxWriteOptions& options = {}, const Progress& progress = {});
Status write_fbx(const motion::Clip& clip, const std::filesystem::path& path, const FbxWriteOptions& options = {},
                 const Progress& progress = {});

}  // namespace limbwave::interchange
