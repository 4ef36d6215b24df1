#include "interchange/preset.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "base/files.h"
#include "base/json_reader.h"
#include "interchange/bone_map.h"

namespace limbwave::interchange {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr std::size_t kLargestFile = std::size_t{1} << 20;

// The value that a word stands for; other words are refused with the list of those that are known.
template <typename T>
T choice(const JsonReader& json, const char* key, T otherwise, std::vector<std::pair<std::string, T>> words) {
  if (!json.has(key)) {
    return otherwise;
  }
  const JsonReader value = json.at(key);
  const std::string word = value.string();
  std::vector<std::string> known;
  for (const auto& [name, meaning] : words) {
    if (name == word) {
      return meaning;
    }
    known.push_back(name);
  }
  value.fail(fmt::format("is \"{}\"", word), fmt::format("use one of {}", fmt::join(known, ", ")));
  return otherwise;
}

Preset read_preset(const JsonReader& root) {
  root.allow({"schema", "name", "title", "comment", "bone_map", "bone_axis", "rest", "rest_frame", "soles_at_zero",
              "root", "root_name", "root_motion", "unit", "bvh_unit", "required"});
  (void)root.at("schema").integer(1, 1);
  Preset preset;
  preset.name = root.at("name").string();
  preset.title = root.string_or("title", preset.name);
  preset.comment = root.string_or("comment", "");
  preset.bone_map = root.string_or("bone_map", "");
  preset.bone_axis = choice<BoneAxis>(root, "bone_axis", BoneAxis::kAsIs,
                                      {{"as-is", BoneAxis::kAsIs}, {"x", BoneAxis::kX}, {"y", BoneAxis::kY}});
  preset.rest =
      choice<RestPose>(root, "rest", RestPose::kAsIs, {{"as-is", RestPose::kAsIs}, {"t-pose", RestPose::kTPose}});
  preset.rest_frame = root.boolean_or("rest_frame", false);
  preset.soles_at_zero = root.boolean_or("soles_at_zero", false);
  const std::vector<std::pair<std::string, FileUnit>> units = {{"cm", FileUnit::kCentimetres},
                                                               {"m", FileUnit::kMetres}};
  preset.unit = choice<FileUnit>(root, "unit", FileUnit::kCentimetres, units);
  preset.bvh_unit = choice<FileUnit>(root, "bvh_unit", preset.unit, units);
  preset.root_motion = choice<motion::RootMotion>(root, "root_motion", motion::RootMotion::kFree,
                                                  {{"free", motion::RootMotion::kFree},
                                                   {"in-place", motion::RootMotion::kInPlace},
                                                   {"on-root", motion::RootMotion::kOnRoot}});
  if (choice<bool>(root, "root", false, {{"hips", false}, {"bone", true}})) {
    preset.root_bone = root.string_or("root_name", "root");
  } else if (preset.root_motion == motion::RootMotion::kOnRoot) {
    root.at("root_motion").fail("puts movement on a root bone that is not there", "set \"root\" to \"bone\"");
  }
  if (root.has("required")) {
    for (const JsonReader& item : root.at("required").items()) {
      preset.required.push_back(item.string());
      if (std::ranges::find(humanoid_roles(), preset.required.back()) == humanoid_roles().end()) {
        item.fail("is no bone of a person", "the bones are listed in resources/bone_maps/README.md");
      }
    }
  }
  return preset;
}

// Turns bone frames so that their axis `own` points to the bone's end.
motion::Clip along_bones(motion::Clip clip, const Vector3d& own) {
  std::vector<Quaterniond> turns;
  for (const Vector3d& bone : motion::bone_directions(clip.skeleton)) {
    turns.push_back(Quaterniond::FromTwoVectors(own, bone));
  }
  return motion::with_bone_frames(std::move(clip), turns);
}

}  // namespace

Status check_required(const motion::Clip& clip, const Preset& preset) {
  const std::vector<std::string> roles = roles_of(clip.skeleton);
  std::vector<std::string> missing;
  for (const std::string& role : preset.required) {
    if (std::ranges::find(roles, role) == roles.end()) {
      missing.push_back(role);
    }
  }
  if (missing.empty()) {
    return {};
  }
  return Error{fmt::format("{} needs bones that the skeleton lacks: {}", preset.title, fmt::join(missing, ", ")),
               clip.name, "capture a whole body, choose another preset, or name the bones in a bone map"};
}

Result<Preset> load_preset(const std::string& name_or_path) {
  const std::string path = find_resource("presets", name_or_path).string();
  const Result<std::string> text = read_file(path, kLargestFile);
  if (!text) {
    return text.error();
  }
  const Result<nlohmann::json> json = parse_json(*text, path);
  if (!json) {
    return json.error();
  }
  JsonReader::State state{path, {}};
  Preset preset = read_preset(JsonReader(*json, "", state));
  if (state.error) {
    return *state.error;
  }
  return preset;
}

std::vector<std::string> preset_names() {
  std::vector<std::string> names = resource_names("presets");
  // Not the one of std::ranges, which Clang 14 does not compile.
  std::stable_partition(names.begin(), names.end(), [](const std::string& name) { return name == "plain"; });
  return names;
}

Vector3d bone_axis(const Preset& preset) {
  // Files' x, y and z are our y, z and x (file_axes.h).
  switch (preset.bone_axis) {
    case BoneAxis::kX:
      return Vector3d::UnitY();
    case BoneAxis::kY:
      return Vector3d::UnitZ();
    default:
      return Vector3d::UnitX();
  }
}

Result<motion::Clip> arranged(motion::Clip clip, const Preset& preset) {
  if (clip.skeleton.segments.empty()) {
    return Error{"has no bones", clip.name, "export a clip with a skeleton"};
  }
  const std::vector<std::string> roles = roles_of(clip.skeleton);
  if (const Status complete = check_required(clip, preset); !complete) {
    return complete.error();
  }
  if (!preset.bone_map.empty()) {
    const Result<BoneMap> map = load_bone_map(preset.bone_map);
    if (!map) {
      return map.error();
    }
    clip.skeleton = renamed(std::move(clip.skeleton), roles, *map);
  }
  if (preset.rest == RestPose::kTPose) {
    const std::vector<Quaterniond> R_WL = t_pose(clip.skeleton, roles);
    clip = motion::with_rest(std::move(clip), R_WL);
  }
  if (preset.soles_at_zero) {
    clip = motion::with_rest_height(std::move(clip), 0.0);
  }
  if (preset.root_motion == motion::RootMotion::kInPlace) {
    clip = motion::with_root_motion(std::move(clip), preset.root_motion);
  }
  if (!preset.root_bone.empty()) {
    clip = motion::with_root_bone(std::move(clip), preset.root_bone);
    if (preset.root_motion == motion::RootMotion::kOnRoot) {
      clip = motion::with_root_motion(std::move(clip), preset.root_motion);
    }
  }
  if (preset.bone_axis != BoneAxis::kAsIs) {
    clip = along_bones(std::move(clip), bone_axis(preset));
  }
  if (preset.rest_frame) {
    const Vector3d p_root = clip.skeleton.segments.front().p_PL;
    clip = motion::with_rest_frame(std::move(clip), p_root);
  }
  return clip;
}

}  // namespace limbwave::interchange
