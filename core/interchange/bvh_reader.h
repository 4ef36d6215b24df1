/// Reading of Biovision hierarchy (BVH) files, as other programs write them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "base/result.h"
#include "motion/clip.h"

namespace limbwave::interchange {

inline constexpr double kMetresPerCentimetre = 0.01;
/// The length unit of CMU's optical recordings in BVH: an inch divided by 0.45.
inline constexpr double kMetresPerCmuUnit = 0.0564444;

/// kY: Y up, figures face +Z; turned to z up, facing +x. kZ: taken as it is.
enum class UpAxis { kY, kZ };

/// How a joint's frame L lies in the skeleton that is read.
enum class BoneFrames {
  /// x along the bone, as everywhere in core/: towards the mean of the children's joints, or towards the End Site.
  /// The rest orientation R_PL_rest says how the file's axes (parallel to the world's at rest) lie in it; R_WL(t) times
  /// the inverse of R_WL at rest is the file's own rotation, converted to z up. Writing gives the same file again.
  kAlongBone,
  /// The file's own axes converted to z up, parallel to the world's at rest (R_PL_rest = identity). x is *not* along
  /// the bone, `length` says only how long it is, and the directions of End Sites are lost.
  kFile,
};

struct BvhReadOptions {
  /// Metres per unit of length, which the file does not say; nullopt = guessed from the skeleton's size.
  std::optional<double> metres_per_unit = kMetresPerCentimetre;
  UpAxis up = UpAxis::kY;
  BoneFrames frames = BoneFrames::kAlongBone;
  std::size_t skip_frames = 0;         ///< Leave out so many frames at the start (an artificial T-pose).
  Diagnostics* diagnostics = nullptr;  ///< Where to report what was odd but readable; may be null.
};

/// Reads BVH text; `place` names it in errors (FILE:LINE). Accepts any channel order, one to three rotation channels
/// per joint, position channels on every joint (where they move, the joint slides, which is reported; its rest place is
/// their mean),
/// all line ends, tabs, lower case, names with spaces (made plain and unique), a byte order mark, `#` comments, and
/// frame counts that do not match. Rounded frame times mean the common rate that rounds to them: 0.0083333 is 120 Hz
/// (frame_rate.h). Memory is bounded by the size of the text, whatever it claims. Fails, with the line, on everything
/// else.
Result<motion::Clip> read_bvh(std::string_view text, const std::string& place, const BvhReadOptions& options = {});

/// The same from a file; the clip gets the file's name.
Result<motion::Clip> load_bvh(const std::filesystem::path& path, const BvhReadOptions& options = {});

/// A guess of the unit from the size of a skeleton at rest in file units. Twelve joints or more are taken as a whole
/// person between 1 and 2.6 m, in metres, CMU units, centimetres or millimetres; fewer as a part of one, in metres,
/// centimetres or millimetres.
double guess_metres_per_unit(const body::Skeleton& in_file_units);

}  // namespace limbwave::interchange
