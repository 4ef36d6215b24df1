#include "interchange/fbx_plain_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace limbwave::interchange {
namespace {

using Eigen::Affine3d;
using Eigen::Vector3d;

constexpr double kLargest = 3e8;
// A bone that is smaller than this to a mesh has no place in it.
constexpr double kSmallestScale = 1e-9;

bool sane(const std::vector<double>& numbers) {
  return std::ranges::all_of(numbers, [](double number) { return std::abs(number) <= kLargest; });
}

// Weights of one bone, of all its clusters.
struct Bone {
  std::vector<std::int32_t> vertices;
  std::vector<double> weights;
  Affine3d link = Affine3d::Identity();
};

class MeshReader {
 public:
  MeshReader(FbxRecords& records, const FbxScene& scene, const FbxSkin& skin)
      : records_(records), scene_(scene), skin_(skin) {}

  Status read(FbxPlainMesh& mesh) {
    const std::string whose = fmt::format("the mesh \"{}\"", skin_.name);
    const FbxRecord* vertices = skin_.geometry->find("Vertices");
    const FbxRecord* polygons = skin_.geometry->find("PolygonVertexIndex");
    if (vertices == nullptr || polygons == nullptr) {
      return records_.error(skin_.geometry->offset, whose + " has no vertices or no polygons");
    }
    const Result<std::vector<double>> numbers = records_.numbers(*vertices, whose);
    if (!numbers) {
      return numbers.error();
    }
    if (numbers->size() % 3 != 0 || !sane(*numbers)) {
      return records_.error(vertices->offset, whose + " has vertices that are not three sane numbers each");
    }
    for (std::size_t i = 0; i + 2 < numbers->size(); i += 3) {
      mesh.positions.emplace_back((*numbers)[i], (*numbers)[i + 1], (*numbers)[i + 2]);
    }
    if (Status status = triangles(*polygons, whose, mesh); !status) {
      return status;
    }
    for (const FbxCluster& cluster : skin_.clusters) {
      if (Status status = bone(cluster, mesh.positions.size()); !status) {
        return status;
      }
    }
    for (Vector3d& p : mesh.positions) {
      p = world_from_mesh_ * p;
    }
    if (!std::ranges::all_of(mesh.positions, [](const Vector3d& p) { return p.cwiseAbs().maxCoeff() <= kLargest; })) {
      return records_.error(skin_.geometry->offset, whose + " is bound absurdly far away");
    }
    return {};
  }

  const std::map<int, Bone>& bones() const { return bones_; }

 private:
  // Polygons as fans; the last corner of each is marked by being −1 minus itself.
  Status triangles(const FbxRecord& record, const std::string& whose, FbxPlainMesh& mesh) {
    const Result<std::vector<std::int64_t>> corners = records_.integers(record, whose);
    if (!corners) {
      return corners.error();
    }
    std::vector<std::uint32_t> polygon;
    for (const std::int64_t corner : *corners) {
      const std::int64_t vertex = corner < 0 ? -1 - corner : corner;
      if (vertex >= static_cast<std::int64_t>(mesh.positions.size())) {
        return records_.error(record.offset,
                              fmt::format("{} has a corner at vertex {} of {}", whose, vertex, mesh.positions.size()));
      }
      polygon.push_back(static_cast<std::uint32_t>(vertex));
      if (corner < 0) {
        for (std::size_t i = 2; i < polygon.size(); ++i) {
          mesh.corners.insert(mesh.corners.end(), {polygon[0], polygon[i - 1], polygon[i]});
        }
        polygon.clear();
      }
    }
    if (!polygon.empty() || mesh.corners.empty()) {
      return records_.error(record.offset, whose + " has a polygon without an end, or none");
    }
    return {};
  }

  Result<Affine3d> matrix(const FbxRecord& cluster, const char* name, const std::string& whose) {
    const FbxRecord* record = cluster.find(name);
    if (record == nullptr) {
      return records_.error(cluster.offset, fmt::format("{} has no {} matrix", whose, name));
    }
    const Result<std::vector<double>> numbers = records_.numbers(*record, whose);
    if (!numbers) {
      return numbers.error();
    }
    if (numbers->size() != 16 || !sane(*numbers)) {
      return records_.error(record->offset, fmt::format("{} has a {} matrix that is none", whose, name));
    }
    Affine3d M(Eigen::Map<const Eigen::Matrix4d>(numbers->data()));
    M.makeAffine();
    return M;
  }

  Status bone(const FbxCluster& cluster, std::size_t vertices) {
    const std::string& bone_name = scene_.models[static_cast<std::size_t>(cluster.model)].name;
    const std::string whose = fmt::format("the skin of \"{}\" on \"{}\"", skin_.name, bone_name);
    const Result<Affine3d> link = matrix(*cluster.record, "TransformLink", whose);
    if (!link) {
      return link.error();
    }
    const Result<Affine3d> transform = matrix(*cluster.record, "Transform", whose);
    if (!transform) {
      return transform.error();
    }
    if (!(std::abs(link->linear().determinant()) > kSmallestScale)) {
      return records_.error(cluster.record->offset, whose + " has a bone of no size");
    }
    if (bones_.empty()) {
      world_from_mesh_ = *link * *transform * scene_.models[static_cast<std::size_t>(skin_.model)].geometric;
    }
    Bone& bone = bones_[cluster.model];
    bone.link = *link;
    const FbxRecord* indices = cluster.record->find("Indexes");
    const FbxRecord* weights = cluster.record->find("Weights");
    if (indices == nullptr || weights == nullptr) {
      return {};  // a bone that moves nothing
    }
    const Result<std::vector<std::int64_t>> at = records_.integers(*indices, whose);
    const Result<std::vector<double>> by = records_.numbers(*weights, whose);
    if (!at || !by) {
      return !at ? at.error() : by.error();
    }
    if (at->size() != by->size() || !sane(*by)) {
      return records_.error(indices->offset,
                            fmt::format("{} has {} vertices and {} weights", whose, at->size(), by->size()));
    }
    for (std::size_t i = 0; i < at->size(); ++i) {
      if ((*at)[i] < 0 || (*at)[i] >= static_cast<std::int64_t>(vertices)) {
        return records_.error(indices->offset, fmt::format("{} moves vertex {} of {}", whose, (*at)[i], vertices));
      }
      if ((*by)[i] > 0.0) {
        bone.vertices.push_back(static_cast<std::int32_t>((*at)[i]));
        bone.weights.push_back((*by)[i]);
      }
    }
    return {};
  }

  FbxRecords& records_;
  const FbxScene& scene_;
  const FbxSkin& skin_;
  std::map<int, Bone> bones_;
  Affine3d world_from_mesh_ = Affine3d::Identity();
};

FbxArray packed(const Affine3d& M) {
  const Eigen::Matrix4d& all = M.matrix();
  return fbx_array(std::span<const double>(all.data(), 16), 0);
}

}  // namespace

Result<FbxPlainMesh> plain_fbx_mesh(FbxRecords& records, const FbxScene& scene, int skin, const std::vector<FbxId>& ids,
                                    FbxRecordWriter& out, FbxSceneWriter& file) {
  FbxPlainMesh mesh;
  mesh.skin = skin;
  MeshReader reader(records, scene, scene.skins[static_cast<std::size_t>(skin)]);
  if (Status status = reader.read(mesh); !status) {
    return status.error();
  }
  const std::string name = fmt::format("m{}", skin);
  std::vector<double> vertices;
  for (const Vector3d& p : mesh.positions) {
    vertices.insert(vertices.end(), p.begin(), p.end());
  }
  std::vector<std::int32_t> corners;
  for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
    const auto vertex = static_cast<std::int32_t>(mesh.corners[i]);
    corners.push_back(i % 3 == 2 ? -1 - vertex : vertex);
  }
  const FbxId shape = file.begin_object("Geometry", name, "Geometry", "Mesh");
  out.leaf("GeometryVersion", 124);
  out.leaf_array("Vertices", fbx_array(std::span<const double>(vertices), 0));
  out.leaf_array("PolygonVertexIndex", fbx_array(std::span<const std::int32_t>(corners), 0));
  out.end();
  const FbxId model = file.begin_object("Model", name, "Model", "Mesh");
  out.leaf("Version", 232);
  out.begin("Properties70");
  out.end();
  out.end();
  file.connect(shape, model);
  file.connect(model, kFbxRoot);
  const FbxId deformer = file.begin_object("Deformer", name, "Deformer", "Skin");
  out.leaf("Version", 101);
  out.leaf("Link_DeformAcuracy", 50.0);  // so spelled by the format
  out.end();
  file.connect(deformer, shape);
  for (const auto& [bone_model, bone] : reader.bones()) {
    if (bone.vertices.empty()) {
      continue;
    }
    const FbxId cluster = file.begin_object("Deformer", name, "SubDeformer", "Cluster");
    out.leaf("Version", 100);
    out.leaf_array("Indexes", fbx_array(std::span<const std::int32_t>(bone.vertices), 0));
    out.leaf_array("Weights", fbx_array(std::span<const double>(bone.weights), 0));
    out.leaf_array("Transform", packed(bone.link.inverse()));
    out.leaf_array("TransformLink", packed(bone.link));
    out.end();
    file.connect(cluster, deformer);
    file.connect(ids[static_cast<std::size_t>(bone_model)], cluster);
  }
  return mesh;
}

}  // namespace limbwave::interchange
