/// Which bones a person has, and what programs call them.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "body/skeleton.h"

namespace limbwave::interchange {

/// A bone's role is its name in VRM 1.0's humanoid ("leftUpperArm"); these are all of them, parents first.
const std::vector<std::string>& humanoid_roles();

/// What one program calls the bones of a person. Files: resources/bone_maps/*.json and the same folder under the user's
/// data folder; the schema is in resources/bone_maps/README.md.
struct BoneMap {
  std::string name;
  std::string title;
  std::map<std::string, std::string> bones;  ///< Role → name.
};

/// A shipped or user's map by name ("unreal"), or a file by path. Fails, naming the key, on unknown roles and on names
/// that two roles share.
Result<BoneMap> load_bone_map(const std::string& name_or_path);
/// Names of the shipped and the user's maps, sorted. A user's map hides a shipped one of the same name.
std::vector<std::string> bone_map_names();

/// The role of every segment, "" where it has none. Names are compared without case, prefixes up to a colon, spaces and
/// separators; of all `maps` the one that knows most of the names counts, the first one of equals.
std::vector<std::string> roles_of(const body::Skeleton& skeleton, const std::vector<BoneMap>& maps);
/// The same with all maps of `bone_map_names`; files that cannot be read are left out.
std::vector<std::string> roles_of(const body::Skeleton& skeleton);

/// The skeleton with its bones called as `map` says; others keep their names, changed only where they would repeat one.
body::Skeleton renamed(body::Skeleton skeleton, const std::vector<std::string>& roles, const BoneMap& map);

/// World orientations of a T-pose: arms and fingers to the sides, legs down, feet as they are at rest; the person
/// upright, facing +x. Segments without role follow their parents. Thumbs, shoulders and the spine keep their shape.
std::vector<Eigen::Quaterniond> t_pose(const body::Skeleton& skeleton, const std::vector<std::string>& roles);

/// Files `folder/NAME.json` that are shipped or the user's; the user's come first for the same name.
std::filesystem::path find_resource(const std::string& folder, const std::string& name_or_path);
std::vector<std::string> resource_names(const std::string& folder);

}  // namespace limbwave::interchange
