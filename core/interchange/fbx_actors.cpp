#include <algorithm>

#include "interchange/fbx_import.h"

namespace limbwave::interchange {
namespace {

// More than a reader takes; what follows is left out.
constexpr std::size_t kMostActors = 2000;

}  // namespace

std::vector<FbxActor> fbx_actors(const FbxScene& scene, const FbxPlain& plain) {
  std::vector<FbxActor> actors;
  std::vector<int> actor_of(scene.models.size(), -1);
  // A node between two bones counts as a bone: whether some bone hangs on a node is known from behind.
  std::vector<bool> carries(scene.models.size(), false);
  for (std::size_t i = scene.models.size(); i-- > 0;) {
    const int parent = scene.models[i].parent;
    if (parent >= 0 && (carries[i] || scene.models[i].joint)) {
      carries[static_cast<std::size_t>(parent)] = true;
    }
  }
  for (std::size_t i = 0; i < scene.models.size(); ++i) {
    if (!plain.kept[i]) {
      continue;
    }
    const int parent = scene.models[i].parent;
    const int above = parent < 0 ? -1 : actor_of[static_cast<std::size_t>(parent)];
    if (above >= 0 && (scene.models[i].joint || carries[i])) {
      actor_of[i] = above;
      actors[static_cast<std::size_t>(above)].joints.push_back(static_cast<int>(i));
    } else if (scene.models[i].joint && actors.size() < kMostActors) {
      FbxActor actor;
      actor.joints.push_back(static_cast<int>(i));
      for (int node = parent; node >= 0; node = scene.models[static_cast<std::size_t>(node)].parent) {
        actor.above.push_back(node);
      }
      std::ranges::reverse(actor.above);
      actor_of[i] = static_cast<int>(actors.size());
      actors.push_back(std::move(actor));
    }
  }
  return actors;
}

}  // namespace limbwave::interchange
