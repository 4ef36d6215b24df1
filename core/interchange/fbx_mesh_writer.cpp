#include "interchange/fbx_mesh_writer.h"

#include <algorithm>

namespace limbwave::interchange {

std::size_t fbx_cluster_count(const motion::SkinnedMesh& mesh, std::size_t bones) {
  std::vector<bool> used(bones, false);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    for (std::size_t k = 0; k < motion::kInfluences; ++k) {
      if (mesh.weights[v][k] > 0.0F) {
        used[mesh.segments[v][k]] = true;
      }
    }
  }
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
}

FbxArray FbxMeshWriter::matrix(const body::SegmentPose& pose) const {
  return fbx_matrix(frames_.rotation(pose.R_WL, true), frames_.position(pose.p_WL, true));
}

void FbxMeshWriter::bind_pose(const motion::Clip& clip) {
  const bool own = !clip.meshes.empty() && !clip.meshes.front()->bind_poses.empty();
  const std::vector<body::SegmentPose> poses = own ? clip.meshes.front()->bind_poses : motion::rest_poses(skeleton_);
  scene_.begin_object("Pose", "BindPose", "Pose", "BindPose");
  out_.leaf("Type", "BindPose");
  out_.leaf("Version", 100);
  out_.leaf("NbPoseNodes", static_cast<std::int32_t>(bones_.size()));
  for (std::size_t i = 0; i < bones_.size(); ++i) {
    out_.begin("PoseNode");
    out_.leaf("Node", bones_[i]);
    out_.leaf_array("Matrix", matrix(poses[i]));
    out_.end();
  }
  out_.end();
}

FbxId FbxMeshWriter::geometry(const motion::SkinnedMesh& mesh, const std::string& name) {
  std::vector<double> vertices;
  vertices.reserve(mesh.positions.size() * 3);
  for (const Eigen::Vector3f& p : mesh.positions) {
    const Eigen::Vector3d in_file = frames_.position(p.cast<double>(), true);
    vertices.insert(vertices.end(), in_file.begin(), in_file.end());
  }
  std::vector<std::int32_t> corners;
  corners.reserve(mesh.triangles.size() * 3);
  for (const auto& [a, b, c] : mesh.triangles) {
    // The last corner of a face is marked by being −1 minus itself.
    corners.insert(corners.end(),
                   {static_cast<std::int32_t>(a), static_cast<std::int32_t>(b), -1 - static_cast<std::int32_t>(c)});
  }
  const FbxId id = scene_.begin_object("Geometry", name, "Geometry", "Mesh");
  out_.leaf("GeometryVersion", 124);
  out_.leaf_array("Vertices", fbx_array(std::span<const double>(vertices)));
  out_.leaf_array("PolygonVertexIndex", fbx_array(std::span<const std::int32_t>(corners)));
  if (!mesh.normals.empty()) {
    std::vector<double> normals;
    normals.reserve(mesh.normals.size() * 3);
    for (const Eigen::Vector3f& n : mesh.normals) {
      const Eigen::Vector3d in_file = frames_.R_FW * n.cast<double>();
      normals.insert(normals.end(), in_file.begin(), in_file.end());
    }
    out_.begin("LayerElementNormal");
    out_.add(0);
    out_.leaf("Version", 101);
    out_.leaf("Name", "");
    out_.leaf("MappingInformationType", "ByVertice");
    out_.leaf("ReferenceInformationType", "Direct");
    out_.leaf_array("Normals", fbx_array(std::span<const double>(normals)));
    out_.end();
    out_.begin("Layer");
    out_.add(0);
    out_.leaf("Version", 100);
    out_.begin("LayerElement");
    out_.leaf("Type", "LayerElementNormal");
    out_.leaf("TypedIndex", 0);
    out_.end();
    out_.end();
  }
  out_.end();
  return id;
}

void FbxMeshWriter::mesh(const motion::SkinnedMesh& mesh, const std::string& name) {
  const FbxId shape = geometry(mesh, name);
  const FbxId model = scene_.begin_object("Model", name, "Model", "Mesh");
  out_.leaf("Version", 232);
  out_.begin("Properties70");
  scene_.property("InheritType", "enum", "", "", 1);
  scene_.property("DefaultAttributeIndex", "int", "Integer", "", 0);
  out_.end();
  out_.leaf("Shading", true);
  out_.leaf("Culling", "CullingOff");
  out_.end();
  scene_.connect(shape, model);
  scene_.connect(model, kFbxRoot);

  const FbxId skin = scene_.begin_object("Deformer", name, "Deformer", "Skin");
  out_.leaf("Version", 101);
  out_.leaf("Link_DeformAcuracy", 50.0);  // so spelled by the format
  out_.end();
  scene_.connect(skin, shape);

  std::vector<std::vector<std::int32_t>> vertices(bones_.size());
  std::vector<std::vector<double>> weights(bones_.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    for (std::size_t k = 0; k < motion::kInfluences; ++k) {
      const std::uint16_t segment = mesh.segments[v][k];
      const float weight = mesh.weights[v][k];
      if (weight <= 0.0F) {
        continue;
      }
      if (!vertices[segment].empty() && vertices[segment].back() == static_cast<std::int32_t>(v)) {
        weights[segment].back() += weight;  // the same bone twice
      } else {
        vertices[segment].push_back(static_cast<std::int32_t>(v));
        weights[segment].push_back(weight);
      }
    }
  }
  const std::vector<body::SegmentPose> bind = mesh.bind_poses.empty() ? motion::rest_poses(skeleton_) : mesh.bind_poses;
  for (std::size_t i = 0; i < bones_.size(); ++i) {
    if (vertices[i].empty()) {
      continue;
    }
    const Eigen::Quaterniond R = frames_.rotation(bind[i].R_WL, true);
    const Eigen::Vector3d p = frames_.position(bind[i].p_WL, true);
    const FbxId cluster = scene_.begin_object("Deformer", name, "SubDeformer", "Cluster");
    out_.leaf("Version", 100);
    out_.leaf("UserData", "", "");
    out_.leaf_array("Indexes", fbx_array(std::span<const std::int32_t>(vertices[i])));
    out_.leaf_array("Weights", fbx_array(std::span<const double>(weights[i])));
    // The mesh lies in the world, so that its place in the bone is the inverse of the bone's.
    out_.leaf_array("Transform", fbx_matrix(R.conjugate(), R.conjugate() * -p));
    out_.leaf_array("TransformLink", fbx_matrix(R, p));
    out_.end();
    scene_.connect(cluster, skin);
    scene_.connect(bones_[i], cluster);
  }
}

}  // namespace limbwave::interchange
