/// Clips as binary glTF 2.0 (.glb): how solves are kept in takes, readable by every 3D program.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/progress.h"
#include "base/result.h"
#include "motion/clip.h"

namespace limbwave::interchange {

/// The clip as a .glb: one node per segment with its rest pose and name, in the order of the segments; one animation
/// with a rotation channel per moving segment and a translation channel for the root; metres, seconds, Y up, facing +Z
/// (file_axes.h), so that the nodes' own Z runs along the bone.
///
/// glTF holds keys as 32-bit floats. So that a solve comes back exactly as it was, the scene's extras ("limbwave") hold
/// the skeleton (lengths, joints, limits), the frame rate, and where in the binary chunk, behind everything glTF refers
/// to, the same keys lie as 64-bit floats. Cubic tracks are marked as linear for other programs.
/// Fails when the skeleton is empty, keys are not finite, start before 0 or do not increase, the file would not fit
/// into 4 GB, or the clip has what solves never have and this form has no place for: meshes, joints that slide,
/// velocities of their own or ways that change from key to key. `write_gltf` (gltf_file.h) writes those.
Result<std::string> glb_from_clip(const motion::Clip& clip);

/// Reads what `glb_from_clip` wrote; `place` names it in errors. When another program has changed the animation, its
/// keys count, not the 64-bit ones. Fails on files without Limbwave's extras.
Result<motion::Clip> clip_from_glb(std::string_view bytes, const std::string& place);

/// The same with files; writing is all-or-nothing.
Status write_glb(const motion::Clip& clip, const std::filesystem::path& path);
Result<motion::Clip> load_glb(const std::filesystem::path& path);

}  // namespace limbwave::interchange
