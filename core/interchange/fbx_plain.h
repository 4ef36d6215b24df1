/// An FBX scene said again in the simplest way, so that any reader understands it and none can be harmed: nodes with
/// translation, rotation and scaling alone, one layer, straight curves, meshes that lie in the world, and names by
/// number.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "interchange/fbx_scene.h"

namespace limbwave::interchange {

/// Key times of one node in one animation, with what a file of straight lines cannot say.
struct FbxPlainKeys {
  std::vector<std::int64_t> times;  ///< Ticks, strictly increasing; empty: not animated.
  std::vector<bool> holds;          ///< One per key: nothing moves until the next.
};

struct FbxPlainMesh {
  int skin = -1;                           ///< Index in FbxScene::skins.
  std::vector<std::uint32_t> corners;      ///< Three per triangle: index of the vertex in the file.
  std::vector<Eigen::Vector3d> positions;  ///< Of the vertices when bound, in the file's world.
};

struct FbxPlain {
  std::string bytes;       ///< Binary FBX; node i is called "n<i>", animation k "s<k>".
  std::vector<bool> kept;  ///< One per model: joints, what lies between them and what they hang on.
  std::vector<std::vector<FbxPlainKeys>> keys;  ///< By stack and model.
  std::vector<FbxPlainMesh> meshes;
};

/// Fails, with the byte, on broken curves and meshes, and on animation that would need absurdly many keys.
Result<FbxPlain> plain_fbx(FbxRecords& records, const FbxScene& scene);

}  // namespace limbwave::interchange
