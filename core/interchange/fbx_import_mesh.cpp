#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "geometry/so3.h"
#include "interchange/fbx_import.h"

namespace limbwave::interchange {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3f;

// Bind poses that differ by less from rest are rest.
constexpr double kSameAngle = 1e-4;
constexpr double kSamePlace = 1e-5;  // m

// Normals that follow from the triangles, larger ones counting more.
std::vector<Vector3f> smooth_normals(const motion::SkinnedMesh& mesh) {
  std::vector<Vector3f> normals(mesh.positions.size(), Vector3f::Zero());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vector3f area = (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
    for (const std::uint32_t corner : {a, b, c}) {
      normals[corner] += area;
    }
  }
  for (Vector3f& normal : normals) {
    const float length = normal.norm();
    normal = length > 1e-20F && std::isfinite(length) ? Vector3f(normal / length) : Vector3f::UnitZ();
  }
  return normals;
}

// The four largest influences of a vertex, with sum 1; the root's when it has none.
void set_influences(motion::SkinnedMesh& mesh, std::size_t vertex, std::vector<std::pair<float, std::uint16_t>>& all) {
  std::ranges::sort(all, [](const auto& a, const auto& b) { return a.first > b.first; });
  all.resize(std::min(all.size(), motion::kInfluences));
  float sum = 0.0F;
  for (const auto& [weight, segment] : all) {
    sum += weight;
  }
  auto& segments = mesh.segments[vertex];
  auto& weights = mesh.weights[vertex];
  segments = {};
  weights = {1.0F, 0.0F, 0.0F, 0.0F};
  for (std::size_t k = 0; k < all.size() && sum > 1e-12F && std::isfinite(sum); ++k) {
    segments[k] = all[k].second;
    weights[k] = all[k].first / sum;
  }
}

}  // namespace

std::shared_ptr<const motion::SkinnedMesh> FbxImporter::mesh(const FbxPlainMesh& plain, const aiMesh& imported,
                                                             const FbxActor& actor) const {
  const FbxSkin& skin = scene_.skins[static_cast<std::size_t>(plain.skin)];
  auto mesh = std::make_shared<motion::SkinnedMesh>();
  mesh->name = skin.name;
  // Assimp has one vertex per corner, in the corners' order. Vertices of no triangle are left out.
  if (imported.mNumVertices != plain.corners.size()) {
    return nullptr;
  }
  constexpr std::uint32_t kNone = ~0U;
  std::vector<std::uint32_t> compact(plain.positions.size(), kNone);
  std::vector<std::uint32_t> vertex_of(plain.corners.size());
  std::vector<bool> first(plain.corners.size(), false);
  for (std::size_t corner = 0; corner < plain.corners.size(); ++corner) {
    std::uint32_t& vertex = compact[plain.corners[corner]];
    if (vertex == kNone) {
      vertex = static_cast<std::uint32_t>(mesh->positions.size());
      first[corner] = true;
      const aiVector3D& p = imported.mVertices[corner];
      mesh->positions.emplace_back(
          (scene_.metres_per_unit * scene_.R_WF * Eigen::Vector3d(p.x, p.y, p.z)).cast<float>());
    }
    vertex_of[corner] = vertex;
  }
  for (std::size_t corner = 0; corner + 2 < vertex_of.size(); corner += 3) {
    mesh->triangles.push_back({vertex_of[corner], vertex_of[corner + 1], vertex_of[corner + 2]});
  }
  mesh->normals = smooth_normals(*mesh);

  std::unordered_map<int, std::uint16_t> segment_of;
  for (std::size_t i = 0; i < actor.joints.size(); ++i) {
    segment_of[actor.joints[i]] = static_cast<std::uint16_t>(i);
  }
  std::vector<std::vector<std::pair<float, std::uint16_t>>> influences(mesh->positions.size());
  std::vector<bool> bound(actor.joints.size(), false);
  std::vector<body::SegmentPose> bind(actor.joints.size());
  for (unsigned b = 0; b < imported.mNumBones; ++b) {
    const aiBone& bone = *imported.mBones[b];
    const auto node = std::ranges::find_if(
        nodes_, [&](const aiNode* candidate) { return candidate != nullptr && candidate->mName == bone.mName; });
    const auto segment = segment_of.find(static_cast<int>(node - nodes_.begin()));
    if (segment == segment_of.end()) {
      continue;
    }
    Eigen::Affine3d bone_at_bind = Eigen::Affine3d::Identity();
    aiMatrix4x4 M = bone.mOffsetMatrix;
    M.Inverse();
    bone_at_bind.matrix() << M.a1, M.a2, M.a3, M.a4, M.b1, M.b2, M.b3, M.b4, M.c1, M.c2, M.c3, M.c4, 0, 0, 0, 1;
    if (bone_at_bind.matrix().allFinite()) {
      bind[segment->second] = pose_of(bone_at_bind);
      bound[segment->second] = true;
    }
    for (unsigned w = 0; w < bone.mNumWeights; ++w) {
      const aiVertexWeight& weight = bone.mWeights[w];
      if (weight.mVertexId < first.size() && first[weight.mVertexId] && weight.mWeight > 0.0F) {
        influences[vertex_of[weight.mVertexId]].emplace_back(weight.mWeight, segment->second);
      }
    }
  }
  mesh->segments.resize(mesh->positions.size());
  mesh->weights.resize(mesh->positions.size());
  for (std::size_t v = 0; v < influences.size(); ++v) {
    set_influences(*mesh, v, influences[v]);
  }

  // Bones that move no vertex keep their rest pose under their parent's bind pose.
  const motion::Clip still = clip(actor, -1);
  const std::vector<body::SegmentPose> at_rest = motion::rest_poses(still.skeleton);
  bool as_rest = true;
  for (std::size_t i = 0; i < bind.size(); ++i) {
    const body::Segment& segment = still.skeleton.segments[i];
    if (!bound[i] && segment.parent < 0) {
      bind[i] = at_rest[i];
    } else if (!bound[i]) {
      const body::SegmentPose& parent = bind[static_cast<std::size_t>(segment.parent)];
      bind[i] = {parent.R_WL * segment.R_PL_rest, parent.p_WL + parent.R_WL * segment.p_PL};
    }
    as_rest = as_rest && geometry::geodesic_angle(bind[i].R_WL, at_rest[i].R_WL) < kSameAngle &&
              (bind[i].p_WL - at_rest[i].p_WL).norm() < kSamePlace;
  }
  if (!as_rest) {
    mesh->bind_poses = std::move(bind);
  }
  return mesh;
}

std::vector<std::shared_ptr<const motion::SkinnedMesh>> FbxImporter::meshes(const FbxActor& actor,
                                                                            const std::vector<FbxActor>& all) const {
  std::vector<std::shared_ptr<const motion::SkinnedMesh>> result;
  const auto shared_bones = [&](const FbxActor& candidate, const FbxSkin& skin) {
    return std::ranges::count_if(skin.clusters, [&](const FbxCluster& cluster) {
      return std::ranges::binary_search(candidate.joints, cluster.model);
    });
  };
  for (const FbxPlainMesh& plain : plain_.meshes) {
    const FbxSkin& skin = scene_.skins[static_cast<std::size_t>(plain.skin)];
    const auto owner =
        std::ranges::max_element(all, {}, [&](const FbxActor& candidate) { return shared_bones(candidate, skin); });
    const std::string name = fmt::format("m{}", plain.skin);
    for (unsigned m = 0; owner != all.end() && &*owner == &actor && m < imported_.mNumMeshes; ++m) {
      if (name != imported_.mMeshes[m]->mName.C_Str()) {
        continue;
      }
      if (auto made = this->mesh(plain, *imported_.mMeshes[m], actor)) {
        result.push_back(std::move(made));
      }
    }
  }
  return result;
}

}  // namespace limbwave::interchange
