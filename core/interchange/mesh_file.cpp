#include "interchange/mesh_file.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>

#include "base/files.h"
#include "interchange/bone_map.h"
#include "interchange/file_axes.h"
#include "interchange/names.h"
#include "motion/transforms.h"

namespace limbwave::interchange {
namespace {

constexpr std::size_t kLargestFile = std::size_t{1} << 30;
constexpr std::size_t kMostTriangles = 10'000'000;

}  // namespace

Result<motion::TriangleMesh> load_mesh(const std::filesystem::path& path) {
  if (const Result<std::string> bytes = read_file(path, kLargestFile); !bytes) {
    return bytes.error();
  } else if (bytes->empty()) {
    return Error{"is empty", path.string(), "save the mesh as .obj, .glb or .fbx"};
  }
  // By name, not from memory: a .gltf has its numbers in files beside it.
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path.string(), aiProcess_Triangulate | aiProcess_JoinIdenticalVertices |
                                                              aiProcess_PreTransformVertices | aiProcess_SortByPType);
  if (scene == nullptr) {
    std::string reason = importer.GetErrorString();
    std::ranges::replace(reason, '\n', ' ');
    return Error{"cannot be read as a mesh (" + reason + ")", path.string(), "save it as .obj, .glb or .fbx"};
  }
  motion::TriangleMesh result;
  result.name = to_utf8(path.stem().string());
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
    const aiMesh& mesh = *scene->mMeshes[m];
    const auto first = static_cast<std::uint32_t>(result.positions.size());
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D& p = mesh.mVertices[v];
      result.positions.push_back(from_y_up(Eigen::Vector3d(p.x, p.y, p.z)).cast<float>());
    }
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices == 3) {
        result.triangles.push_back({first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]});
      }
    }
    if (result.triangles.size() > kMostTriangles) {
      return Error{"has more than ten million triangles", path.string(), "simplify it first"};
    }
  }
  if (result.triangles.empty()) {
    return Error{"has no triangles", path.string(), "choose a file with a mesh"};
  }
  return result;
}

Result<std::shared_ptr<const motion::SkinnedMesh>> skinned_mesh_file(const std::filesystem::path& path,
                                                                     const motion::Clip& clip,
                                                                     const Progress& progress) {
  if (!progress.report(0.0, "reading the mesh")) {
    return cancelled();
  }
  Result<motion::TriangleMesh> mesh = load_mesh(path);
  if (!mesh) {
    return mesh.error();
  }
  motion::Clip still;
  still.skeleton = clip.skeleton;
  still = motion::with_rest(std::move(still), t_pose(clip.skeleton, roles_of(clip.skeleton)));
  const std::vector<body::SegmentPose> bind = motion::rest_poses(still.skeleton);
  Result<motion::SkinnedMesh> skinned =
      motion::skinned(motion::fitted(*std::move(mesh), bind), clip.skeleton, bind, {}, progress.part(0.1, 1.0));
  if (!skinned) {
    return skinned.error();
  }
  return std::shared_ptr<const motion::SkinnedMesh>(std::make_shared<motion::SkinnedMesh>(*std::move(skinned)));
}

}  // namespace limbwave::interchange
