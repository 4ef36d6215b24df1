#include "interchange/bone_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <compare>
#include <set>
#include <utility>

#include "base/files.h"
#include "base/json_reader.h"
#include "interchange/names.h"

namespace limbwave::interchange {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestFile = std::size_t{1} << 20;

std::vector<std::string> make_roles() {
  std::vector<std::string> roles{"hips", "spine", "chest", "upperChest", "neck", "head"};
  for (const std::string side : {"left", "right"}) {
    for (const char* part : {"UpperLeg", "LowerLeg", "Foot", "Toes", "Shoulder", "UpperArm", "LowerArm", "Hand"}) {
      roles.push_back(side + part);
    }
    for (const char* part : {"ThumbMetacarpal", "ThumbProximal", "ThumbDistal"}) {
      roles.push_back(side + part);
    }
    for (const std::string finger : {"Index", "Middle", "Ring", "Little"}) {
      for (const std::string part : {"Proximal", "Intermediate", "Distal"}) {
        roles.push_back(std::string(side).append(finger).append(part));
      }
    }
  }
  return roles;
}

// "mixamorig:Left_Arm" and "leftarm" are the same bone.
std::string key_of(std::string_view name) {
  name.remove_prefix(std::min(name.rfind(':') + 1, name.size()));
  std::string key;
  for (const char c : name) {
    if (std::string_view(" _-.").find(c) == std::string_view::npos) {
      key.push_back(static_cast<char>(std::tolower(static_cast<unsigned char>(c))));
    }
  }
  return key;
}

// How well a map fits: by names that it knows, of equals by those spelled just so.
struct Fit {
  std::size_t known = 0;
  std::size_t exact = 0;
  [[nodiscard]] bool is_better_than(const Fit& other) const {
    return known != other.known ? known > other.known : exact > other.exact;
  }
};

std::vector<std::string> roles_by(const body::Skeleton& skeleton, const BoneMap& map, Fit& fit) {
  std::map<std::string, std::string> role_of;
  for (const auto& [role, name] : map.bones) {
    role_of[key_of(name)] = role;
  }
  std::vector<std::string> roles;
  std::set<std::string> taken;
  for (const body::Segment& segment : skeleton.segments) {
    const auto found = role_of.find(key_of(segment.name));
    const bool is_new = found != role_of.end() && taken.insert(found->second).second;
    roles.push_back(is_new ? found->second : "");
    fit.exact += is_new && map.bones.at(found->second) == segment.name ? 1 : 0;
  }
  fit.known = taken.size();
  return roles;
}

}  // namespace

const std::vector<std::string>& humanoid_roles() {
  static const std::vector<std::string> roles = make_roles();
  return roles;
}

fs::path find_resource(const std::string& folder, const std::string& name_or_path) {
  if (name_or_path.find('/') == std::string::npos && !name_or_path.ends_with(".json")) {
    for (const fs::path& base : {user_data_folder(), resources_folder()}) {
      fs::path file = base / folder / (name_or_path + ".json");
      std::error_code ignored;
      if (fs::exists(file, ignored)) {
        return file;
      }
    }
  }
  return name_or_path;
}

std::vector<std::string> resource_names(const std::string& folder) {
  std::set<std::string> names;
  for (const fs::path& base : {user_data_folder(), resources_folder()}) {
    std::error_code error;
    for (fs::directory_iterator entry(base / folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
      if (entry->path().extension() == ".json") {
        names.insert(entry->path().stem().string());
      }
    }
  }
  return {names.begin(), names.end()};
}

Result<BoneMap> load_bone_map(const std::string& name_or_path) {
  const fs::path path = find_resource("bone_maps", name_or_path);
  const Result<std::string> text = read_file(path, kLargestFile);
  if (!text) {
    return text.error();
  }
  const Result<nlohmann::json> json = parse_json(*text, path.string());
  if (!json) {
    return json.error();
  }
  JsonReader::State state{path.string(), {}};
  const JsonReader root(*json, "", state);
  root.allow({"schema", "name", "title", "comment", "bones"});
  (void)root.at("schema").integer(1, 1);
  BoneMap map;
  map.name = root.at("name").string();
  map.title = root.string_or("title", map.name);
  const JsonReader bones = root.at("bones");
  std::set<std::string> names;
  if (bones.raw().is_object()) {
    for (const auto& [role, value] : bones.raw().items()) {
      const JsonReader bone = bones.at(role.c_str());
      const std::string name = bone.string();
      if (std::ranges::find(humanoid_roles(), role) == humanoid_roles().end()) {
        bone.fail("is no bone of a person", "the bones are listed in resources/bone_maps/README.md");
      } else if (name.empty() || !names.insert(key_of(name)).second) {
        bone.fail("is empty or stands for two bones", "give every bone a name of its own");
      }
      map.bones[role] = name;
    }
  } else {
    bones.fail("is no object", "write it as { \"hips\": \"NAME\", ... }");
  }
  if (state.error) {
    return *state.error;
  }
  return map;
}

std::vector<std::string> bone_map_names() {
  return resource_names("bone_maps");
}

std::vector<std::string> roles_of(const body::Skeleton& skeleton, const std::vector<BoneMap>& maps) {
  std::vector<std::string> best(skeleton.segments.size());
  Fit closest;
  for (const BoneMap& map : maps) {
    Fit fit;
    std::vector<std::string> roles = roles_by(skeleton, map, fit);
    if (fit.is_better_than(closest)) {
      closest = fit;
      best = std::move(roles);
    }
  }
  return best;
}

std::vector<std::string> roles_of(const body::Skeleton& skeleton) {
  std::vector<BoneMap> maps;
  for (const std::string& name : bone_map_names()) {
    if (Result<BoneMap> map = load_bone_map(name)) {
      maps.push_back(*std::move(map));
    }
  }
  return roles_of(skeleton, maps);
}

body::Skeleton renamed(body::Skeleton skeleton, const std::vector<std::string>& roles, const BoneMap& map) {
  UniqueNames unique;
  std::vector<bool> is_done(skeleton.segments.size(), false);
  // Mapped bones get their names first, so that a bystander of the same name gives way.
  for (std::size_t i = 0; i < skeleton.segments.size(); ++i) {
    const auto found = map.bones.find(roles[i]);
    if (found != map.bones.end()) {
      skeleton.segments[i].name = unique(found->second);
      is_done[i] = true;
    }
  }
  for (std::size_t i = 0; i < skeleton.segments.size(); ++i) {
    if (!is_done[i]) {
      skeleton.segments[i].name = unique(skeleton.segments[i].name);
    }
  }
  return skeleton;
}

}  // namespace limbwave::interchange
