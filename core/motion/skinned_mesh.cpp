#include "motion/skinned_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "motion/clip.h"

namespace limbwave::motion {
namespace {

constexpr double kWeightSumTolerance = 1e-4;

Error wrong(const SkinnedMesh& mesh, const std::string& what) {
  return {what, mesh.name, "export the mesh again from the program that made it"};
}

bool finite(const std::vector<Eigen::Vector3f>& vectors, std::size_t& first_wrong) {
  const auto found = std::ranges::find_if(vectors, [](const Eigen::Vector3f& v) { return !v.allFinite(); });
  first_wrong = static_cast<std::size_t>(found - vectors.begin());
  return found == vectors.end();
}

}  // namespace

std::vector<Eigen::Vector3f> deformed(const SkinnedMesh& mesh, const body::Skeleton& skeleton,
                                      const std::vector<body::SegmentPose>& poses) {
  const std::vector<body::SegmentPose> bind = mesh.bind_poses.empty() ? rest_poses(skeleton) : mesh.bind_poses;
  assert(bind.size() == poses.size());
  std::vector<Eigen::Matrix3f> turns(poses.size());
  std::vector<Eigen::Vector3f> shifts(poses.size());
  for (std::size_t s = 0; s < poses.size(); ++s) {
    const Eigen::Quaterniond turn = poses[s].R_WL * bind[s].R_WL.conjugate();
    turns[s] = turn.toRotationMatrix().cast<float>();
    shifts[s] = (poses[s].p_WL - turn * bind[s].p_WL).cast<float>();
  }
  std::vector<Eigen::Vector3f> result(mesh.positions.size());
  for (std::size_t v = 0; v < result.size(); ++v) {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (std::size_t k = 0; k < kInfluences; ++k) {
      const std::uint16_t s = mesh.segments[v][k];
      if (mesh.weights[v][k] != 0.0F) {
        sum += mesh.weights[v][k] * (turns[s] * mesh.positions[v] + shifts[s]);
      }
    }
    result[v] = sum;
  }
  return result;
}

Status validate(const SkinnedMesh& mesh, const body::Skeleton& skeleton) {
  const std::size_t n = mesh.positions.size();
  if (mesh.segments.size() != n || mesh.weights.size() != n || (!mesh.normals.empty() && mesh.normals.size() != n)) {
    return wrong(mesh, fmt::format("{} vertices have {} normals, {} rows of bones and {} of weights", n,
                                   mesh.normals.size(), mesh.segments.size(), mesh.weights.size()));
  }
  if (!mesh.bind_poses.empty() && mesh.bind_poses.size() != skeleton.segments.size()) {
    return wrong(mesh, fmt::format("{} bind poses for {} bones", mesh.bind_poses.size(), skeleton.segments.size()));
  }
  std::size_t first = 0;
  if (!finite(mesh.positions, first) || !finite(mesh.normals, first)) {
    return wrong(mesh, fmt::format("vertex {} has a number that is not finite", first));
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (std::ranges::any_of(mesh.triangles[t], [&](std::uint32_t v) { return v >= n; })) {
      return wrong(mesh, fmt::format("triangle {} has a corner beyond the {} vertices", t, n));
    }
  }
  for (std::size_t v = 0; v < n; ++v) {
    double sum = 0.0;
    for (std::size_t k = 0; k < kInfluences; ++k) {
      const float weight = mesh.weights[v][k];
      if (mesh.segments[v][k] >= skeleton.segments.size() || !(weight >= 0.0F)) {
        return wrong(mesh, fmt::format("vertex {} has a wrong bone or weight", v));
      }
      sum += weight;
    }
    if (!(std::abs(sum - 1.0) <= kWeightSumTolerance)) {
      return wrong(mesh, fmt::format("the weights of vertex {} sum to {:.4g}, not 1", v, sum));
    }
  }
  return {};
}

}  // namespace limbwave::motion
