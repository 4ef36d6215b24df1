/// Meshes to be skinned: a person whose surface is one piece, and one with everything that goes wrong in meshes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "motion/clip.h"
#include "motion/skinning.h"

namespace limbwave::test {

/// 25 bones from head to toes and fingertips, in a T-pose, facing +x. Leaves have lengths, x along them.
inline body::Skeleton person_of_25() {
  using Eigen::Vector3d;
  struct Bone {
    const char* name;
    const char* parent;
    Vector3d joint;
    Vector3d end;  // of leaves; zero: no leaf
  };
  std::vector<Bone> bones = {{"hips", "", {0, 0, 0.95}, {0, 0, 0}},
                             {"spine", "hips", {0, 0, 1.05}, {0, 0, 0}},
                             {"chest", "spine", {0, 0, 1.25}, {0, 0, 0}},
                             {"neck", "chest", {0, 0, 1.48}, {0, 0, 0}},
                             {"head", "neck", {0.01, 0, 1.58}, {0.02, 0, 1.72}}};
  static constexpr std::array kSides = {std::pair{"left", 1.0}, std::pair{"right", -1.0}};
  static const std::vector<Bone> kSide = {
      {"Clavicle", "chest", {0, 0.04, 1.44}, {0, 0, 0}},     {"UpperArm", "Clavicle", {0, 0.18, 1.42}, {0, 0, 0}},
      {"ForeArm", "UpperArm", {0, 0.46, 1.42}, {0, 0, 0}},   {"Hand", "ForeArm", {0, 0.71, 1.42}, {0, 0, 0}},
      {"Fingers", "Hand", {0, 0.80, 1.42}, {0, 0.88, 1.42}}, {"Thumb", "Hand", {0.03, 0.73, 1.42}, {0.07, 0.78, 1.42}},
      {"Thigh", "hips", {0, 0.09, 0.92}, {0, 0, 0}},         {"Shin", "Thigh", {0, 0.10, 0.50}, {0, 0, 0}},
      {"Foot", "Shin", {-0.02, 0.10, 0.09}, {0, 0, 0}},      {"Toes", "Foot", {0.10, 0.10, 0.03}, {0.17, 0.10, 0.03}}};
  body::Skeleton skeleton;
  skeleton.name = "person";
  std::map<std::string, std::pair<int, Vector3d>> known;
  const auto add = [&](const std::string& name, const std::string& parent, const Vector3d& joint, const Vector3d& end) {
    body::Segment segment;
    segment.name = name;
    segment.parent = parent.empty() ? -1 : known.at(parent).first;
    segment.p_PL = parent.empty() ? joint : Vector3d(joint - known.at(parent).second);
    if (!end.isZero()) {
      segment.R_PL_rest = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitX(), Vector3d(end - joint));
      segment.length = (end - joint).norm();
    }
    known[name] = {static_cast<int>(skeleton.segments.size()), joint};
    skeleton.segments.push_back(segment);
  };
  for (const Bone& bone : bones) {
    add(bone.name, bone.parent, bone.joint, bone.end);
  }
  for (const auto& [side, sign] : kSides) {
    const auto mirrored = [s = sign](Vector3d v) {
      v.y() *= s;
      return v;
    };
    for (const Bone& bone : kSide) {
      const std::string parent = known.contains(bone.parent) ? bone.parent : std::string(side) + bone.parent;
      add(std::string(side) + bone.name, parent, mirrored(bone.joint), mirrored(bone.end));
    }
  }
  return skeleton;
}

/// The bones' straight pieces in W at rest: from every joint to its children, and along leaves.
inline std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> bone_pieces(const body::Skeleton& skeleton) {
  const std::vector<body::SegmentPose> rest = motion::rest_poses(skeleton);
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> pieces;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const body::Segment& segment = skeleton.segments[i];
    if (segment.parent >= 0) {
      pieces.emplace_back(rest[static_cast<std::size_t>(segment.parent)].p_WL, rest[i].p_WL);
    }
    if (segment.length > 0.0) {
      pieces.emplace_back(rest[i].p_WL, rest[i].p_WL + rest[i].R_WL * Eigen::Vector3d(segment.length, 0, 0));
    }
  }
  return pieces;
}

inline double distance(const Eigen::Vector3d& p, const std::pair<Eigen::Vector3d, Eigen::Vector3d>& piece) {
  const Eigen::Vector3d way = piece.second - piece.first;
  const double u = std::clamp((p - piece.first).dot(way) / way.squaredNorm(), 0.0, 1.0);
  return (piece.first + u * way - p).norm();
}

namespace detail {

/// The union of capsules around all pieces, thicker where they are longer, by marching tetrahedra on a grid.
inline motion::TriangleMesh capsules(const body::Skeleton& skeleton, double step) {
  using Eigen::Vector3d;
  const auto pieces = bone_pieces(skeleton);
  const auto outside = [&](const Vector3d& p) {
    double nearest = 1e9;
    for (const auto& piece : pieces) {
      const double radius = std::clamp(0.25 * (piece.second - piece.first).norm(), 0.02, 0.08);
      nearest = std::min(nearest, distance(p, piece) - radius);
    }
    return nearest;
  };
  Eigen::AlignedBox3d box;
  for (const auto& [a, b] : pieces) {
    box.extend(a);
    box.extend(b);
  }
  const Vector3d low = box.min() - Vector3d::Constant(0.1 + 0.37 * step);
  const Eigen::Vector3i cells =
      ((box.max() - low + Vector3d::Constant(0.1)) / step).cast<int>() + Eigen::Vector3i::Ones();
  const auto index = [&](const Eigen::Vector3i& c) {
    return static_cast<std::size_t>((c.z() * (cells.y() + 1) + c.y()) * (cells.x() + 1) + c.x());
  };
  const auto place = [&](const Eigen::Vector3i& c) { return Vector3d(low + step * c.cast<double>()); };
  std::vector<double> field(index(cells) + 1);
  for (int z = 0; z <= cells.z(); ++z) {
    for (int y = 0; y <= cells.y(); ++y) {
      for (int x = 0; x <= cells.x(); ++x) {
        field[index({x, y, z})] = outside(place({x, y, z}));
      }
    }
  }
  motion::TriangleMesh mesh;
  mesh.name = "person";
  std::map<std::pair<std::size_t, std::size_t>, std::uint32_t> on_edge;
  const auto vertex = [&](const Eigen::Vector3i& a, const Eigen::Vector3i& b) {
    const std::pair<std::size_t, std::size_t> key = std::minmax({index(a), index(b)});
    const auto [found, is_new] = on_edge.try_emplace(key, static_cast<std::uint32_t>(mesh.positions.size()));
    if (is_new) {
      const double u = field[index(a)] / (field[index(a)] - field[index(b)]);
      mesh.positions.push_back((place(a) + u * (place(b) - place(a))).cast<float>());
    }
    return found->second;
  };
  // Six tetrahedra along a cube's diagonal, each a way from corner 0 to corner 7.
  static constexpr std::array<std::array<int, 4>, 6> kTetrahedra = {
      {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};
  const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, const Vector3d& inside) {
    if (a == b || b == c || c == a) {
      return;
    }
    const Vector3d p = mesh.positions[a].cast<double>();
    const Vector3d normal = (mesh.positions[b].cast<double>() - p).cross(mesh.positions[c].cast<double>() - p);
    normal.dot(inside - p) < 0.0 ? mesh.triangles.push_back({a, b, c}) : mesh.triangles.push_back({a, c, b});
  };
  for (int z = 0; z < cells.z(); ++z) {
    for (int y = 0; y < cells.y(); ++y) {
      for (int x = 0; x < cells.x(); ++x) {
        for (const auto& corners : kTetrahedra) {
          std::vector<Eigen::Vector3i> in;
          std::vector<Eigen::Vector3i> out;
          for (const int corner : corners) {
            const Eigen::Vector3i c(x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2 & 1));
            (field[index(c)] < 0.0 ? in : out).push_back(c);
          }
          if (in.size() == 1 || in.size() == 3) {
            const auto& one = in.size() == 1 ? in : out;
            const auto& three = in.size() == 1 ? out : in;
            triangle(vertex(one[0], three[0]), vertex(one[0], three[1]), vertex(one[0], three[2]), place(in[0]));
          } else if (in.size() == 2) {
            const std::uint32_t a = vertex(in[0], out[0]);
            const std::uint32_t b = vertex(in[0], out[1]);
            const std::uint32_t c = vertex(in[1], out[1]);
            const std::uint32_t d = vertex(in[1], out[0]);
            triangle(a, b, c, place(in[0]));
            triangle(a, c, d, place(in[0]));
          }
        }
      }
    }
  }
  return mesh;
}

}  // namespace detail

/// A closed surface around `person_of_25` with at least `vertices` vertices, and slivers as marching tetrahedra leave.
inline motion::TriangleMesh person_mesh(std::size_t vertices) {
  const body::Skeleton skeleton = person_of_25();
  motion::TriangleMesh mesh;
  for (double step = 2.0 / std::sqrt(static_cast<double>(vertices)); mesh.positions.size() < vertices; step *= 0.95) {
    mesh = detail::capsules(skeleton, step);
  }
  return mesh;
}

/// The same person badly made: a hole in the back, hands cut off and open, a third of all triangles with corners of
/// their own, triangles twice or without area, corners that nothing uses, and an open hat far from every bone.
inline motion::TriangleMesh nasty_mesh(std::size_t vertices) {
  using Eigen::Vector3f;
  const motion::TriangleMesh person = person_mesh(vertices * 7 / 10);
  motion::TriangleMesh mesh;
  mesh.name = "nasty";
  mesh.positions = person.positions;
  std::mt19937 random(7);
  for (const auto& triangle : person.triangles) {
    Vector3f middle = Vector3f::Zero();
    for (const std::uint32_t corner : triangle) {
      middle += person.positions[corner] / 3.0F;
    }
    const bool in_hole = (middle - Vector3f(-0.08F, 0, 1.2F)).norm() < 0.06F;
    const bool at_wrist = std::abs(std::abs(middle.y()) - 0.69F) < 0.02F;
    if (in_hole || at_wrist) {
      continue;
    }
    mesh.triangles.push_back(triangle);
    const unsigned luck = random() % 30;
    if (luck < 10 && mesh.positions.size() + 3 < vertices) {
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      for (const std::uint32_t corner : triangle) {
        const Vector3f p = mesh.positions[corner];
        mesh.positions.push_back(p);
      }
      mesh.triangles.back() = {first, first + 1, first + 2};
    } else if (luck == 10) {
      mesh.triangles.push_back(triangle);
    } else if (luck == 11) {
      mesh.triangles.push_back({triangle[0], triangle[1], triangle[1]});
    } else if (luck == 12) {
      mesh.positions.push_back(0.5F * (mesh.positions[triangle[0]] + mesh.positions[triangle[1]]));
      mesh.triangles.push_back({triangle[0], triangle[1], static_cast<std::uint32_t>(mesh.positions.size() - 1)});
    }
  }
  const auto hat = static_cast<std::uint32_t>(mesh.positions.size());
  for (const float x : {-0.1F, 0.1F}) {
    for (const float y : {-0.1F, 0.1F}) {
      mesh.positions.emplace_back(x, y, 2.1F);
    }
  }
  mesh.triangles.push_back({hat, hat + 2, hat + 3});
  mesh.triangles.push_back({hat, hat + 3, hat + 1});
  return mesh;
}

}  // namespace limbwave::test
