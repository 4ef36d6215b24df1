#include "viewer/bone_shapes.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace limbwave::ui {

namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

void add_triangle(TriangleMesh& mesh, const Vector3f& a, const Vector3f& b, const Vector3f& c) {
  const Vector3f normal = (b - a).cross(c - a).normalized();
  for (const Vector3f& corner : {a, b, c}) {
    mesh.positions.push_back(corner);
    mesh.normals.push_back(normal);
  }
}

void add_box(TriangleMesh& mesh, const Vector3f& low, const Vector3f& high) {
  const auto corner = [&](int i) {
    return Vector3f((i & 1) != 0 ? high.x() : low.x(), (i & 2) != 0 ? high.y() : low.y(),
                    (i & 4) != 0 ? high.z() : low.z());
  };
  constexpr std::array<std::array<int, 4>, 6> kFaces{
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  for (const auto& face : kFaces) {
    add_triangle(mesh, corner(face[0]), corner(face[1]), corner(face[2]));
    add_triangle(mesh, corner(face[0]), corner(face[2]), corner(face[3]));
  }
}

// A stroke of a letter: a flat bar from a to b, seen from both sides.
void add_stroke(TriangleMesh& mesh, const Vector3f& a, const Vector3f& b) {
  constexpr float kHalf = 0.075F;
  const Vector3f along = (b - a).normalized();
  const Vector3f across = kHalf * Vector3f(-along.y(), along.x(), 0.0F);
  const Vector3f start = a - kHalf * along;
  const Vector3f end = b + kHalf * along;
  add_triangle(mesh, start - across, end - across, end + across);
  add_triangle(mesh, start - across, end + across, start + across);
}

// Squared distance between a ray (from its origin on) and the segment p–q, and how far along the ray it is.
struct Approach {
  double distance = 0.0;
  double along = 0.0;
};

Approach nearest_approach(const ViewRay& ray, const Vector3d& p, const Vector3d& q) {
  const Vector3d bone = q - p;
  const Vector3d offset = ray.origin - p;
  const double b = ray.direction.dot(bone);
  const double c = bone.squaredNorm();
  const double d = ray.direction.dot(offset);
  const double e = bone.dot(offset);
  const double determinant = c - b * b;
  double on_bone = 0.0;
  if (c > 1e-12) {
    // Parallel lines: every point of the bone is as near; the start will do.
    on_bone = determinant > 1e-12 * c ? std::clamp((e - b * d) / determinant, 0.0, 1.0) : 0.0;
  }
  const double along = std::max(0.0, ray.direction.dot(p + on_bone * bone - ray.origin));
  return {(ray.origin + along * ray.direction - p - on_bone * bone).norm(), along};
}

Vector3d bone_end(const body::Skeleton& skeleton, const std::vector<body::SegmentPose>& poses, std::size_t i) {
  return poses[i].p_WL + poses[i].R_WL * Vector3d(skeleton.segments[i].length, 0, 0);
}

}  // namespace

TriangleMesh bone_mesh() {
  TriangleMesh mesh;
  static constexpr float kShoulder = 0.14F;  // Where the bone is thickest, as a fraction of its length.
  const Vector3f head(0, 0, 0);
  const Vector3f tail(1, 0, 0);
  constexpr int kSides = 4;
  for (int i = 0; i < kSides; ++i) {
    const auto ring = [](int k) {
      const float angle = std::numbers::pi_v<float> * (0.25F + 0.5F * static_cast<float>(k));
      return Vector3f(kShoulder, std::sqrt(2.0F) * std::cos(angle), std::sqrt(2.0F) * std::sin(angle));
    };
    add_triangle(mesh, head, ring(i + 1), ring(i));
    add_triangle(mesh, tail, ring(i), ring(i + 1));
  }
  return mesh;
}

TriangleMesh sphere_mesh() {
  constexpr int kRings = 12;
  constexpr int kSlices = 20;
  const auto point = [](int ring, int slice) {
    const float polar = std::numbers::pi_v<float> * static_cast<float>(ring) / kRings;
    const float around = 2 * std::numbers::pi_v<float> * static_cast<float>(slice) / kSlices;
    return Vector3f(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar));
  };
  TriangleMesh mesh;
  const auto add = [&](const Vector3f& p) {
    mesh.positions.push_back(p);
    mesh.normals.push_back(p);
  };
  for (int ring = 0; ring < kRings; ++ring) {
    for (int slice = 0; slice < kSlices; ++slice) {
      const Vector3f a = point(ring, slice);
      const Vector3f b = point(ring + 1, slice);
      const Vector3f c = point(ring + 1, slice + 1);
      const Vector3f d = point(ring, slice + 1);
      for (const Vector3f& p : {a, b, c, a, c, d}) {
        add(p);
      }
    }
  }
  return mesh;
}

TriangleMesh box_mesh() {
  TriangleMesh mesh;
  add_box(mesh, Vector3f::Constant(-1), Vector3f::Constant(1));
  return mesh;
}

TriangleMesh rod_mesh(bool arrow) {
  TriangleMesh mesh;
  constexpr int kSides = 10;
  constexpr float kTipRadius = 2.6F;
  const float neck = arrow ? 0.78F : 1.0F;
  const auto ring = [](int k, float x, float radius) {
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(k) / kSides;
    return Vector3f(x, radius * std::cos(angle), radius * std::sin(angle));
  };
  for (int i = 0; i < kSides; ++i) {
    add_triangle(mesh, ring(i, 0, 1), ring(i, neck, 1), ring(i + 1, neck, 1));
    add_triangle(mesh, ring(i, 0, 1), ring(i + 1, neck, 1), ring(i + 1, 0, 1));
    add_triangle(mesh, Vector3f(0, 0, 0), ring(i, 0, 1), ring(i + 1, 0, 1));
    const float end_radius = arrow ? kTipRadius : 1.0F;
    add_triangle(mesh, Vector3f(neck, 0, 0), ring(i, neck, end_radius), ring(i + 1, neck, end_radius));
    if (arrow) {
      add_triangle(mesh, ring(i, neck, kTipRadius), Vector3f(1, 0, 0), ring(i + 1, neck, kTipRadius));
    }
  }
  return mesh;
}

TriangleMesh letter_mesh(char letter) {
  TriangleMesh mesh;
  const float w = 0.32F;
  const float h = 0.5F;
  switch (letter) {
    case 'X':
      add_stroke(mesh, {-w, -h, 0}, {w, h, 0});
      add_stroke(mesh, {-w, h, 0}, {w, -h, 0});
      break;
    case 'Y':
      add_stroke(mesh, {0, 0, 0}, {w, h, 0});
      add_stroke(mesh, {-w, h, 0}, {0, 0, 0});
      add_stroke(mesh, {0, -h, 0}, {0, 0, 0});
      break;
    default:
      assert(letter == 'Z');
      add_stroke(mesh, {-w, h, 0}, {w, h, 0});
      add_stroke(mesh, {-w, -h, 0}, {w, h, 0});
      add_stroke(mesh, {-w, -h, 0}, {w, -h, 0});
      break;
  }
  return mesh;
}

double bone_radius(const body::Segment& segment) {
  return std::clamp(0.09 * segment.length, 0.006, 0.035);
}

Sphere bounds(const body::Skeleton& skeleton, const std::vector<body::SegmentPose>& poses) {
  const std::size_t count = std::min(poses.size(), skeleton.segments.size());
  if (count == 0) {
    return {};
  }
  Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity());
  Vector3d high = -low;
  for (std::size_t i = 0; i < count; ++i) {
    for (const Vector3d& p : {poses[i].p_WL, bone_end(skeleton, poses, i)}) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  return {(low + high) / 2, std::max(0.05, (high - low).norm() / 2)};
}

Sphere segment_bounds(const body::Skeleton& skeleton, const std::vector<body::SegmentPose>& poses, int segment) {
  const auto i = static_cast<std::size_t>(segment);
  assert(segment >= 0 && i < poses.size() && i < skeleton.segments.size());
  const Vector3d end = bone_end(skeleton, poses, i);
  return {(poses[i].p_WL + end) / 2, std::max(0.05, (end - poses[i].p_WL).norm() / 2)};
}

int pick_segment(const body::Skeleton& skeleton, const std::vector<body::SegmentPose>& poses, const ViewRay& ray,
                 double slack_per_metre) {
  int best = -1;
  double best_along = std::numeric_limits<double>::infinity();
  const std::size_t count = std::min(poses.size(), skeleton.segments.size());
  for (std::size_t i = 0; i < count; ++i) {
    const Approach approach = nearest_approach(ray, poses[i].p_WL, bone_end(skeleton, poses, i));
    const double reach = bone_radius(skeleton.segments[i]) + slack_per_metre * approach.along;
    if (approach.distance <= reach && approach.along < best_along) {
      best = static_cast<int>(i);
      best_along = approach.along;
    }
  }
  return best;
}

}  // namespace limbwave::ui
