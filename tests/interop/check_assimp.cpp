// Assimp must find in our files what FILE.expected.json beside each says. Usage: interop_check_assimp FOLDER
#include <assimp/scene.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace {

namespace fs = std::filesystem;
using Eigen::Affine3d;
using Eigen::Vector3d;
using nlohmann::json;

Affine3d matrix(const aiMatrix4x4& m) {
  Affine3d M;
  M.matrix() << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4;
  return M;
}

// The key nearest to a time; samples are taken at keys.
template <typename Key>
const Key& key_at(const Key* keys, unsigned count, double time) {
  const Key* after = std::lower_bound(keys, keys + count, time, [](const Key& key, double t) { return key.mTime < t; });
  if (after == keys + count || (after != keys && time - (after - 1)->mTime < after->mTime - time)) {
    --after;
  }
  return *after;
}

// The length of the file's unit, and which way is up.
struct Space {
  double metres = 1.0;
  int up = 1;
};

Space space_of(const aiScene& scene, const std::string& ending, const json& expected) {
  Space space;
  if (ending == ".bvh") {
    space.metres = expected["metres_per_unit"];
  } else if (ending == ".fbx") {
    float centimetres = 1.0F;
    if (scene.mMetaData != nullptr) {
      scene.mMetaData->Get("UnitScaleFactor", centimetres);
      scene.mMetaData->Get("UpAxis", space.up);
    }
    space.metres = 0.01 * static_cast<double>(centimetres);
  }
  return space;
}

bool check(const fs::path& path) {
  const json expected = json::parse(std::ifstream(path.string() + ".expected.json"));
  const std::string ending = path.extension().string();
  Assimp::Importer importer;
  importer.SetPropertyBool("IMPORT_FBX_PRESERVE_PIVOTS", false);
  const aiScene* scene = importer.ReadFile(path.string(), 0);
  const std::string name = path.filename().string();
  const bool still = name.starts_with("still") || name.starts_with("foreign");
  if (scene == nullptr || scene->mNumAnimations < (still ? 0U : 1U)) {
    std::fprintf(stderr, "  %s: %s\n", path.c_str(), scene == nullptr ? importer.GetErrorString() : "no animation");
    return false;
  }
  if (name.starts_with("foreign") && ending == ".fbx") {
    // Its still pose is another than Autodesk's and Blender's.
    std::printf("%s: read otherwise\n", name.c_str());
    return true;
  }
  const Space space = space_of(*scene, ending, expected);
  std::map<std::string, const aiNodeAnim*> channels;
  double ticks_per_second = 1.0;
  if (scene->mNumAnimations > 0) {
    const aiAnimation& animation = *scene->mAnimations[0];
    // It holds the frame time of BVH in single precision.
    ticks_per_second = ending == ".bvh" ? expected["fps"].get<double>() : animation.mTicksPerSecond;
    for (unsigned c = 0; c < animation.mNumChannels; ++c) {
      channels[animation.mChannels[c]->mNodeName.C_Str()] = animation.mChannels[c];
    }
  }
  double worst = 0.0;
  bool good = true;
  for (const json& sample : expected["samples"]) {
    if (!sample["at_key"].get<bool>() || sample["bar_m"].get<double>() > 1e-3) {
      continue;
    }
    const double ticks = sample["time_s"].get<double>() * ticks_per_second;
    std::map<std::string, Vector3d> found;
    const std::function<void(const aiNode*, const Affine3d&)> visit = [&](const aiNode* node, const Affine3d& above) {
      Affine3d local = matrix(node->mTransformation);
      if (const auto channel = channels.find(node->mName.C_Str()); channel != channels.end()) {
        const aiNodeAnim& keys = *channel->second;
        Vector3d p = local.translation();
        Eigen::Quaterniond R(local.linear());
        if (keys.mNumPositionKeys > 0) {
          const aiVector3D& key = key_at(keys.mPositionKeys, keys.mNumPositionKeys, ticks).mValue;
          p = Vector3d(key.x, key.y, key.z);
        }
        if (keys.mNumRotationKeys > 0) {
          const aiQuaternion& key = key_at(keys.mRotationKeys, keys.mNumRotationKeys, ticks).mValue;
          R = Eigen::Quaterniond(key.w, key.x, key.y, key.z);
        }
        local = Eigen::Translation3d(p) * R.normalized();
      }
      const Affine3d M = above * local;
      found[node->mName.C_Str()] = M.translation() * space.metres;
      for (unsigned i = 0; i < node->mNumChildren; ++i) {
        visit(node->mChildren[i], M);
      }
    };
    visit(scene->mRootNode, Affine3d::Identity());
    for (std::size_t i = 0; i < expected["joints"].size(); ++i) {
      const auto joint = found.find(expected["joints"][i].get<std::string>());
      if (joint == found.end() && name.starts_with("foreign")) {
        std::printf("%s: its nodes have other names\n", name.c_str());
        return true;
      }
      if (joint == found.end()) {
        std::fprintf(stderr, "  %s: no node %s\n", path.c_str(), expected["joints"][i].get<std::string>().c_str());
        return false;
      }
      const Vector3d& p = joint->second;
      const Vector3d in_blender = space.up == 2 ? p : Vector3d(p.x(), -p.z(), p.y());
      const json& head = sample["heads"][i];
      const double error = (in_blender - Vector3d(head[0], head[1], head[2])).norm();
      worst = std::max(worst, error);
      good = good && error <= sample["bar_m"].get<double>();
    }
  }
  std::printf("%s: largest error %.1e m\n", path.filename().c_str(), worst);
  if (!good) {
    std::fprintf(stderr, "  %s: a joint is %.1e m off\n", path.filename().c_str(), worst);
  }
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  int files = 0;
  bool good = argc == 2;
  for (const auto& entry : fs::directory_iterator(argc == 2 ? argv[1] : ".")) {
    const std::string ending = entry.path().extension().string();
    const bool known = ending == ".fbx" || ending == ".glb" || ending == ".gltf" || ending == ".bvh";
    if (known && fs::exists(entry.path().string() + ".expected.json")) {
      ++files;
      good = check(entry.path()) && good;
    }
  }
  std::printf("%d files\n", files);
  return good && files >= 80 ? 0 : 1;
}
