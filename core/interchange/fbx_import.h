/// From the scene that Assimp makes of a plain FBX to clips.
#pragma once

#include <assimp/scene.h>

#include <memory>
#include <string>
#include <vector>

#include "interchange/fbx_plain.h"
#include "motion/clip.h"

namespace limbwave::interchange {

/// One skeleton of the scene: its joints as indices of models, parents before children.
struct FbxActor {
  std::vector<int> joints;
  std::vector<int> above;  ///< What the root joint hangs on, from the scene's root down.
};

std::vector<FbxActor> fbx_actors(const FbxScene& scene, const FbxPlain& plain);

/// Makes clips; everything it is given must outlive it.
class FbxImporter {
 public:
  FbxImporter(const FbxScene& scene, const FbxPlain& plain, const aiScene& imported);

  /// The actor in animation `stack`; without any movement when it is negative.
  [[nodiscard]] motion::Clip clip(const FbxActor& actor, int stack) const;
  /// The meshes that mostly hang on the actor.
  [[nodiscard]] std::vector<std::shared_ptr<const motion::SkinnedMesh>> meshes(const FbxActor& actor,
                                                                               const std::vector<FbxActor>& all) const;

 private:
  struct NodeKeys;
  struct Animation;

  [[nodiscard]] Animation animation(int stack) const;
  [[nodiscard]] FbxPlacement rest(int model) const;
  /// A bone's rigid place in our world from its matrix in the file's.
  [[nodiscard]] body::SegmentPose pose_of(const Eigen::Affine3d& M) const;
  [[nodiscard]] Eigen::Affine3d global_at(const std::vector<int>& chain, const Animation& animation,
                                          double time_s) const;
  void follow(motion::Clip& clip, const FbxActor& actor, const Animation& animation) const;
  void bake(motion::Clip& clip, const FbxActor& actor, const Animation& animation) const;
  [[nodiscard]] bool rigid(const FbxActor& actor, const Animation& animation) const;
  [[nodiscard]] std::shared_ptr<const motion::SkinnedMesh> mesh(const FbxPlainMesh& plain, const aiMesh& imported,
                                                                const FbxActor& actor) const;

  const FbxScene& scene_;
  const FbxPlain& plain_;
  const aiScene& imported_;
  std::vector<const aiNode*> nodes_;  ///< One per model; null where it was left out.
  Eigen::Quaterniond R_WF_;
};

}  // namespace limbwave::interchange
