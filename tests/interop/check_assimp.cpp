// Assimp must find in our FBX files what FILE.json beside each says. Usage: interop_check_assimp FOLDER
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

// Assimp turns matrices of 32-bit numbers into quaternions and back at every key; in a chain of 22 joints that adds up.
constexpr double kAtKeys = 1e-5;

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

bool check(const fs::path& path) {
  const json expected = json::parse(std::ifstream(fs::path(path).replace_extension(".json")));
  Assimp::Importer importer;
  importer.SetPropertyBool("IMPORT_FBX_PRESERVE_PIVOTS", false);
  const aiScene* scene = importer.ReadFile(path.string(), 0);
  if (scene == nullptr || scene->mNumAnimations != 1) {
    std::fprintf(stderr, "%s: %s\n", path.c_str(), scene == nullptr ? importer.GetErrorString() : "no animation");
    return false;
  }
  double centimetres = 1.0;
  float factor = 1.0F;
  if (scene->mMetaData != nullptr && scene->mMetaData->Get("UnitScaleFactor", factor)) {
    centimetres = factor;
  }
  int up = 1;
  if (scene->mMetaData != nullptr) {
    scene->mMetaData->Get("UpAxis", up);
  }
  const aiAnimation& animation = *scene->mAnimations[0];
  std::map<std::string, const aiNodeAnim*> channels;
  for (unsigned c = 0; c < animation.mNumChannels; ++c) {
    channels[animation.mChannels[c]->mNodeName.C_Str()] = animation.mChannels[c];
  }
  double worst = 0.0;
  for (const json& sample : expected["samples"]) {
    if (sample["bar_m"].get<double>() > 1e-4) {
      continue;
    }
    const double ticks = sample["time_s"].get<double>() * animation.mTicksPerSecond;
    std::map<std::string, Vector3d> found;
    const std::function<void(const aiNode*, const Affine3d&)> visit = [&](const aiNode* node, const Affine3d& above) {
      Affine3d local = matrix(node->mTransformation);
      if (const auto channel = channels.find(node->mName.C_Str()); channel != channels.end()) {
        const aiNodeAnim& keys = *channel->second;
        const aiVector3D& p = key_at(keys.mPositionKeys, keys.mNumPositionKeys, ticks).mValue;
        const aiQuaternion& q = key_at(keys.mRotationKeys, keys.mNumRotationKeys, ticks).mValue;
        local = Eigen::Translation3d(p.x, p.y, p.z) * Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized();
      }
      const Affine3d M = above * local;
      found[node->mName.C_Str()] = M.translation() * 0.01 * centimetres;
      for (unsigned i = 0; i < node->mNumChildren; ++i) {
        visit(node->mChildren[i], M);
      }
    };
    visit(scene->mRootNode, Affine3d::Identity());
    for (std::size_t i = 0; i < expected["joints"].size(); ++i) {
      const auto joint = found.find(expected["joints"][i].get<std::string>());
      if (joint == found.end()) {
        std::fprintf(stderr, "%s: no node %s\n", path.c_str(), expected["joints"][i].get<std::string>().c_str());
        return false;
      }
      const Vector3d& p = joint->second;
      const Vector3d in_blender = up == 2 ? p : Vector3d(p.x(), -p.z(), p.y());
      const json& head = sample["heads"][i];
      worst = std::max(worst, (in_blender - Vector3d(head[0], head[1], head[2])).norm());
    }
  }
  std::printf("%s: largest error %.1e m\n", path.filename().c_str(), worst);
  return worst <= kAtKeys;
}

}  // namespace

int main(int argc, char** argv) {
  int files = 0;
  bool good = argc == 2;
  for (const auto& entry : fs::directory_iterator(argc == 2 ? argv[1] : ".")) {
    if (entry.path().extension() == ".fbx") {
      ++files;
      good = check(entry.path()) && good;
    }
  }
  return good && files >= 5 ? 0 : 1;
}
