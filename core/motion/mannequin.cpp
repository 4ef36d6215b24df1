#include "motion/mannequin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "motion/clip.h"

namespace limbwave::motion {
namespace {

using Eigen::Vector3d;

constexpr std::uint32_t kSides = 10;
// A limb from end to end: where its rings are and how thick it is there, as parts of length and radius.
constexpr std::array<std::pair<double, double>, 7> kRings{
    {{-0.06, 0.45}, {0.0, 0.8}, {0.08, 1.0}, {0.35, 0.95}, {0.75, 0.75}, {1.0, 0.6}, {1.04, 0.35}}};
// Rings this near an end follow both bones.
constexpr double kBlend = 0.05;
// Thickness as a part of length, and its limits in metres.
constexpr double kSlenderness = 0.16;
constexpr double kThinnest = 0.012;
constexpr double kThickest = 0.085;
constexpr double kShortest = 0.01;

class Builder {
 public:
  explicit Builder(SkinnedMesh& mesh) : mesh_(mesh) {}

  // `other_begin` and `other_end`: bones that move the ends half; -1 for none.
  void limb(const Vector3d& from, const Vector3d& to, int bone, int other_begin, int other_end) {
    const Vector3d along = to - from;
    const double length = along.norm();
    const double radius = std::clamp(kSlenderness * length, kThinnest, kThickest);
    const Vector3d axis = along / length;
    const Vector3d side = axis.unitOrthogonal();
    const Vector3d other = axis.cross(side);
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    for (const auto& [place, thickness] : kRings) {
      const int with = place < kBlend ? other_begin : place > 1.0 - kBlend ? other_end : -1;
      for (std::uint32_t k = 0; k < kSides; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / kSides;
        vertex(from + place * along + radius * thickness * (std::cos(angle) * side + std::sin(angle) * other), bone,
               with);
      }
    }
    vertex(from + (kRings.front().first * length - 0.3 * radius) * axis, bone, other_begin);
    vertex(from + (kRings.back().first * length + 0.3 * radius) * axis, bone, other_end);
    const auto rings = static_cast<std::uint32_t>(kRings.size());
    const std::uint32_t begin = first + rings * kSides;
    for (std::uint32_t k = 0; k < kSides; ++k) {
      const std::uint32_t next = (k + 1) % kSides;
      mesh_.triangles.push_back({begin, first + next, first + k});
      for (std::uint32_t r = 0; r + 1 < rings; ++r) {
        const std::uint32_t a = first + r * kSides;
        const std::uint32_t b = a + kSides;
        mesh_.triangles.push_back({a + k, a + next, b + k});
        mesh_.triangles.push_back({a + next, b + next, b + k});
      }
      const std::uint32_t last = first + (rings - 1) * kSides;
      mesh_.triangles.push_back({begin + 1, last + k, last + next});
    }
  }

 private:
  void vertex(const Vector3d& p, int bone, int with) {
    mesh_.positions.push_back(p.cast<float>());
    mesh_.segments.push_back({static_cast<std::uint16_t>(bone), static_cast<std::uint16_t>(std::max(with, 0)), 0, 0});
    mesh_.weights.push_back(with < 0 ? std::array{1.0F, 0.0F, 0.0F, 0.0F} : std::array{0.5F, 0.5F, 0.0F, 0.0F});
  }

  SkinnedMesh& mesh_;
};

}  // namespace

std::shared_ptr<const SkinnedMesh> mannequin(const body::Skeleton& skeleton, const Vector3d& along) {
  auto mesh = std::make_shared<SkinnedMesh>();
  mesh->name = "mannequin";
  mesh->bind_poses = rest_poses(skeleton);
  const std::vector<body::SegmentPose>& rest = mesh->bind_poses;
  std::vector<int> children(skeleton.segments.size(), 0);
  for (const body::Segment& segment : skeleton.segments) {
    if (segment.parent >= 0) {
      ++children[static_cast<std::size_t>(segment.parent)];
    }
  }
  Builder builder(*mesh);
  for (std::size_t i = 0; i < skeleton.segments.size(); ++i) {
    const body::Segment& segment = skeleton.segments[i];
    const int self = static_cast<int>(i);
    if (segment.parent >= 0) {
      const auto parent = static_cast<std::size_t>(segment.parent);
      if ((rest[i].p_WL - rest[parent].p_WL).norm() > kShortest) {
        builder.limb(rest[parent].p_WL, rest[i].p_WL, segment.parent, skeleton.segments[parent].parent, self);
      }
    }
    if (children[i] == 0 && segment.length > kShortest) {
      builder.limb(rest[i].p_WL, rest[i].p_WL + rest[i].R_WL * (segment.length * along), self, segment.parent, -1);
    }
  }
  if (mesh->positions.empty() && !rest.empty()) {
    builder.limb(rest[0].p_WL, rest[0].p_WL + Vector3d(0, 0, 2.0 * kShortest), 0, -1, -1);
  }
  mesh->normals = smooth_normals(mesh->positions, mesh->triangles);
  return mesh;
}

}  // namespace limbwave::motion
