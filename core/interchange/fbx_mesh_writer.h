/// Skinned meshes in FBX.
#pragma once

#include <string>
#include <vector>

#include "interchange/fbx_keys.h"
#include "interchange/fbx_scene_writer.h"
#include "motion/clip.h"

namespace limbwave::interchange {

/// How many bones of `bones` move some vertex: each gets a cluster.
std::size_t fbx_cluster_count(const motion::SkinnedMesh& mesh, std::size_t bones);

class FbxMeshWriter {
 public:
  /// `bones`: the models that were written for the skeleton's segments.
  FbxMeshWriter(FbxRecordWriter& out, FbxSceneWriter& scene, const FbxFrames& frames, const body::Skeleton& skeleton,
                const std::vector<FbxId>& bones)
      : out_(out), scene_(scene), frames_(frames), skeleton_(skeleton), bones_(bones) {}

  /// The pose in which the clip's first mesh (without meshes: the skeleton) is bound.
  void bind_pose(const motion::Clip& clip);
  /// The mesh under the scene's root, with a skin and one cluster per bone that moves it.
  void mesh(const motion::SkinnedMesh& mesh, const std::string& name);

 private:
  FbxArray matrix(const body::SegmentPose& pose) const;
  FbxId geometry(const motion::SkinnedMesh& mesh, const std::string& name);

  FbxRecordWriter& out_;
  FbxSceneWriter& scene_;
  const FbxFrames& frames_;
  const body::Skeleton& skeleton_;
  const std::vector<FbxId>& bones_;
};

}  // namespace limbwave::interchange
