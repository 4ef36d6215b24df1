/// Biovision hierarchy (BVH) files: text, Y up and facing +Z (file_axes.h), Euler angles in degrees at a constant frame
/// rate.
#pragma once

#include <filesystem>
#include <string>

#include "base/progress.h"
#include "base/result.h"
#include "motion/clip.h"

namespace limbwave::interchange {

/// BVH does not say in which unit lengths are; most programs expect centimetres.
enum class BvhUnit { kCentimetres, kMetres };
/// Order in which a joint's rotation channels are listed and multiplied.
enum class BvhRotationOrder { kZXY, kZYX };

struct BvhWriteOptions {
  BvhUnit unit = BvhUnit::kCentimetres;
  BvhRotationOrder order = BvhRotationOrder::kZXY;
  double fps = 0.0;  ///< Frames per second; 0 = the clip's own frame rate.
};

/// The clip as BVH text: frames at multiples of 1/fps from 0 to the clip's duration, at least one.
/// The rest pose of the file is the skeleton's, all joints' axes parallel to the file's; rotations are relative to it.
/// The root's OFFSET is 0 and its position stands in the channels; joints that slide have position channels too, which
/// replace their OFFSET. Leaves end in an End Site at their length along the
/// bone. Names are made plain and unique (names.h). Angles are unrolled: no jumps between frames. Independent of
/// locale. Fails when the skeleton is empty, the frame rate is not positive, a key is not finite, or when cancelled.
Result<std::string> bvh_text(const motion::Clip& clip, const BvhWriteOptions& options = {},
                             const Progress& progress = {});

/// Writes `bvh_text` all-or-nothing.
Status write_bvh(const motion::Clip& clip, const std::filesystem::path& path, const BvhWriteOptions& options = {},
                 const Progress& progress = {});

}  // namespace limbwave::interchange
