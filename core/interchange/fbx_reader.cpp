#include "interchange/fbx_reader.h"

#include <assimp/config.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>

#include "base/files.h"
#include "interchange/clip_check.h"
#include "interchange/fbx_import.h"
#include "interchange/fbx_plain.h"
#include "motion/transforms.h"

namespace limbwave::interchange {
namespace {

// Segments are counted with 16 bits in meshes.
constexpr std::size_t kMostJoints = 60000;
constexpr std::size_t kMostClips = 1000;
constexpr double kFurthest = 1e9;  // m

motion::Clip along_bones(motion::Clip clip) {
  std::vector<Eigen::Quaterniond> turns;
  for (const Eigen::Vector3d& direction : motion::bone_directions(clip.skeleton)) {
    turns.push_back(Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), direction));
  }
  return motion::with_bone_frames(std::move(clip), turns);
}

// Each number of the file may be sane by itself and all together not: scales multiply.
Status check_sane(const motion::Clip& clip, const std::string& place) {
  Status status = check_clip(clip);
  for (const auto& mesh : clip.meshes) {
    status = status ? motion::validate(*mesh, clip.skeleton) : status;
  }
  const auto near = [](const Eigen::Vector3d& p) { return p.norm() < kFurthest; };
  bool all_near = std::ranges::all_of(clip.root_position.values, near);
  for (std::size_t i = 0; status && i < clip.joints.size(); ++i) {
    all_near =
        all_near && near(clip.skeleton.segments[i].p_PL) && std::ranges::all_of(clip.joints[i].position.values, near);
  }
  if (!status) {
    return Error{status.error().message, place, "export it again"};
  }
  return all_near ? Status() : Status(Error{"has bones that are absurdly far away", place, "check its unit and scale"});
}

}  // namespace

Result<std::vector<motion::Clip>> read_fbx(std::string_view bytes, const std::string& place,
                                           const FbxReadOptions& options) {
  Result<FbxRecords> records = FbxRecords::parse(bytes, place);
  if (!records) {
    return records.error();
  }
  Result<FbxScene> scene = fbx_scene(*records);
  if (!scene) {
    return scene.error();
  }
  if (!options.animation) {
    scene->stacks.clear();
  }
  Result<FbxPlain> plain = plain_fbx(*records, *scene);
  if (!plain) {
    return plain.error();
  }
  const std::vector<FbxActor> actors = fbx_actors(*scene, *plain);
  if (actors.empty()) {
    return Error{"has no bones", place, "export the skeleton along with the animation"};
  }
  const std::size_t clips_wanted = actors.size() * std::max<std::size_t>(scene->stacks.size(), 1);
  for (const FbxActor& actor : actors) {
    if (actor.joints.size() > kMostJoints || clips_wanted > kMostClips) {
      return Error{fmt::format("has {} skeletons, one with {} bones", actors.size(), actor.joints.size()), place,
                   "export only what is to be animated"};
    }
  }

  Assimp::Importer importer;
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_OPTIMIZE_EMPTY_ANIMATION_CURVES, false);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_MATERIALS, false);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_TEXTURES, false);
  const aiScene* imported = importer.ReadFileFromMemory(plain->bytes.data(), plain->bytes.size(), 0, "fbx");
  if (imported == nullptr || imported->mRootNode == nullptr) {
    return Error{fmt::format("cannot be understood ({})", importer.GetErrorString()), place, "export it again"};
  }
  plain->bytes = {};  // as long as the animation
  const FbxImporter import(*scene, *plain, *imported);
  const auto meshes = import.meshes(actors);
  std::vector<motion::Clip> clips;
  const int stacks = static_cast<int>(scene->stacks.size());
  for (int stack = stacks == 0 ? -1 : 0; stack < stacks; ++stack) {
    for (std::size_t a = 0; a < actors.size(); ++a) {
      clips.push_back(import.clip(actors[a], stack));
      clips.back().meshes = meshes[a];
      if (Status status = check_sane(clips.back(), place); !status) {
        return status.error();
      }
      if (options.frames == BoneFrames::kAlongBone) {
        clips.back() = along_bones(std::move(clips.back()));
      }
    }
  }
  return clips;
}

Result<std::vector<motion::Clip>> load_fbx(const std::filesystem::path& path, const FbxReadOptions& options) {
  const Result<std::string> bytes = read_file(path);
  if (!bytes) {
    return bytes.error();
  }
  Result<std::vector<motion::Clip>> clips = read_fbx(*bytes, path.string(), options);
  if (clips) {
    for (motion::Clip& clip : *clips) {
      clip.name = clip.name.empty() ? path.stem().string() : clip.name;
    }
  }
  return clips;
}

}  // namespace limbwave::interchange
