/// Gives clips a skinned mesh that leaves nothing out: one to four bones per vertex, normals, its own bind pose.
#pragma once

#include <algorithm>
#include <memory>
#include <random>

#include "geometry/so3.h"
#include "motion/clip.h"

namespace limbwave::test {

/// A mesh with a tetrahedron on every bone; its vertices are moved by the bone, its parent and others.
inline std::shared_ptr<const motion::SkinnedMesh> tetrahedra(const motion::Clip& clip, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<float> uniform(-1.0F, 1.0F);
  auto mesh = std::make_shared<motion::SkinnedMesh>();
  mesh->name = "body";
  const std::vector<body::SegmentPose> rest = motion::rest_poses(clip.skeleton);
  for (std::size_t s = 0; s < rest.size(); ++s) {
    const auto first = static_cast<std::uint32_t>(mesh->positions.size());
    for (int corner = 0; corner < 4; ++corner) {
      const Eigen::Vector3f off(uniform(random), uniform(random), uniform(random));
      mesh->positions.push_back(rest[s].p_WL.cast<float>() + 0.1F * off);
      mesh->normals.push_back(off.normalized());
      std::array<std::uint16_t, motion::kInfluences> segments{};
      std::array<float, motion::kInfluences> weights{};
      const int used = std::min<int>(corner + 1, static_cast<int>(rest.size()));
      float sum = 0.0F;
      for (int k = 0; k < used; ++k) {
        const std::size_t bone = (s + rest.size() - static_cast<std::size_t>(k)) % rest.size();
        segments[static_cast<std::size_t>(k)] = static_cast<std::uint16_t>(bone);
        weights[static_cast<std::size_t>(k)] = 1.5F + uniform(random);
        sum += weights[static_cast<std::size_t>(k)];
      }
      for (float& weight : weights) {
        weight /= sum;
      }
      mesh->segments.push_back(segments);
      mesh->weights.push_back(weights);
    }
    for (const auto& [a, b, c] : {std::array{0U, 1U, 2U}, {0U, 2U, 3U}, {0U, 3U, 1U}, {1U, 3U, 2U}}) {
      mesh->triangles.push_back({first + a, first + b, first + c});
    }
  }
  return mesh;
}

}  // namespace limbwave::test
