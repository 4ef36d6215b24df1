/// What programs expect of an animation file.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "base/result.h"
#include "motion/transforms.h"

namespace limbwave::interchange {

enum class BoneAxis { kAsIs, kX, kY };          ///< Own axis of a bone's frame that lies along it.
enum class RestPose { kAsIs, kTPose };          ///< The pose that the file's skeleton has by itself.
enum class FileUnit { kCentimetres, kMetres };  ///< Of lengths; glTF is always in metres.

/// How a clip is rearranged for a program. Files: resources/presets/*.json and the same folder under the user's data
/// folder; the schema is in resources/presets/README.md.
struct Preset {
  std::string name;
  std::string title;
  std::string comment;   ///< One sentence for the user.
  std::string bone_map;  ///< Name of the map that names the bones; empty: names stay.
  BoneAxis bone_axis = BoneAxis::kAsIs;
  RestPose rest = RestPose::kAsIs;
  bool rest_frame = false;     ///< The rest pose as frame 0, the movement from frame 1 on.
  bool soles_at_zero = false;  ///< The rest pose stands on the floor.
  std::string root_bone;       ///< Name of a bone at the origin over the hips; empty: the hips are the root.
  motion::RootMotion root_motion = motion::RootMotion::kFree;
  FileUnit unit = FileUnit::kCentimetres;      ///< Of FBX, which says so in the file.
  FileUnit bvh_unit = FileUnit::kCentimetres;  ///< Of BVH, which does not say it.
  std::vector<std::string> required;           ///< Roles without which the program refuses the file.
};

/// A shipped or user's preset by name, or a file by path.
Result<Preset> load_preset(const std::string& name_or_path);

/// Fails, naming them, when bones that the preset requires are missing from the clip's skeleton.
Status check_required(const motion::Clip& clip, const Preset& preset);
/// Names of the shipped and the user's presets, sorted, "plain" first.
std::vector<std::string> preset_names();

/// The own axis along which bones of an arranged clip lie: x, as everywhere in core/, or where the preset turns it.
Eigen::Vector3d bone_axis(const Preset& preset);

/// The clip as the preset wants it: poses in the world stay, unless the way over the floor goes elsewhere. Fails when
/// bones that the program requires are missing, naming them.
Result<motion::Clip> arranged(motion::Clip clip, const Preset& preset);

}  // namespace limbwave::interchange
