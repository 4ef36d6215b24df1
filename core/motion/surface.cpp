#include "motion/surface.h"

#include <algorithm>
#include <numeric>

namespace limbwave::motion {
namespace {

using Eigen::Vector3d;
using Box = Eigen::AlignedBox3d;

// Triangles in a leaf of the tree.
constexpr std::size_t kLeaf = 8;
// A way that ends this near (part of its length) before a triangle does not meet it.
constexpr double kNear = 1e-6;

// Whether the segment from a to b passes through the triangle (Möller & Trumbore 1997), ends left out.
bool crosses(const Vector3d& a, const Vector3d& b, const Vector3d& p, const Vector3d& q, const Vector3d& r) {
  const Vector3d way = b - a;
  const Vector3d pq = q - p;
  const Vector3d pr = r - p;
  const Vector3d h = way.cross(pr);
  const double determinant = pq.dot(h);
  if (determinant == 0.0) {
    return false;
  }
  const Vector3d s = a - p;
  const double u = s.dot(h) / determinant;
  const Vector3d k = s.cross(pq);
  const double v = way.dot(k) / determinant;
  const double t = pr.dot(k) / determinant;
  return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > kNear && t < 1.0 - kNear;
}

// Whether a segment touches a box: slabs.
bool touches(const Box& box, const Vector3d& a, const Vector3d& way) {
  double begin = 0.0;
  double end = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    if (way[axis] == 0.0) {
      if (a[axis] < box.min()[axis] || a[axis] > box.max()[axis]) {
        return false;
      }
      continue;
    }
    const double first = (box.min()[axis] - a[axis]) / way[axis];
    const double second = (box.max()[axis] - a[axis]) / way[axis];
    begin = std::max(begin, std::min(first, second));
    end = std::min(end, std::max(first, second));
  }
  return begin <= end;
}

}  // namespace

// A tree of boxes, split at the median of the longest side.
struct Surface::Tree {
  struct Node {
    Box box;
    std::size_t first = 0, count = 0;  // triangles of a leaf
    std::size_t left = 0, right = 0;   // children, 0: leaf
  };
  std::vector<Node> nodes;
  std::vector<std::uint32_t> order;

  std::size_t build(std::size_t first, std::size_t count, const std::vector<Box>& boxes) {
    const std::size_t self = nodes.size();
    nodes.emplace_back();
    Box box;
    Box centres;
    for (std::size_t i = first; i < first + count; ++i) {
      box.extend(boxes[order[i]]);
      centres.extend(boxes[order[i]].center());
    }
    nodes[self].box = box;
    if (count <= kLeaf) {
      nodes[self].first = first;
      nodes[self].count = count;
      return self;
    }
    Eigen::Index axis = 0;
    centres.sizes().maxCoeff(&axis);
    const std::size_t half = count / 2;
    const auto begin = order.begin() + static_cast<std::ptrdiff_t>(first);
    std::nth_element(
        begin, begin + static_cast<std::ptrdiff_t>(half), begin + static_cast<std::ptrdiff_t>(count),
        [&](std::uint32_t a, std::uint32_t b) { return boxes[a].center()[axis] < boxes[b].center()[axis]; });
    const std::size_t left = build(first, half, boxes);
    const std::size_t right = build(first + half, count - half, boxes);
    nodes[self].left = left;
    nodes[self].right = right;
    return self;
  }
};

Surface::Surface(const std::vector<Vector3d>& positions, const std::vector<std::array<std::uint32_t, 3>>& triangles)
    : positions_(positions),
      triangles_(triangles),
      normals_(positions.size(), Vector3d(0, 0, 0)),
      tree_(std::make_unique<Tree>()) {
  std::vector<Box> boxes;
  boxes.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) {
    Box box(positions[a]);
    box.extend(positions[b]);
    box.extend(positions[c]);
    boxes.push_back(box);
    const Vector3d area = (positions[b] - positions[a]).cross(positions[c] - positions[a]);
    for (const std::uint32_t corner : {a, b, c}) {
      normals_[corner] += area;
    }
  }
  tree_->order.resize(triangles.size());
  std::iota(tree_->order.begin(), tree_->order.end(), 0U);
  if (!triangles.empty()) {
    tree_->build(0, triangles.size(), boxes);
  }
}

Surface::~Surface() = default;

bool Surface::sees(std::uint32_t from, const Vector3d& to) const {
  const Vector3d& a = positions_[from];
  const Vector3d way = to - a;
  if (normals_[from].dot(way) > 0.0) {
    return false;
  }
  std::vector<std::size_t> open{0};
  while (!open.empty()) {
    const Tree::Node& node = tree_->nodes[open.back()];
    open.pop_back();
    if (!touches(node.box, a, way)) {
      continue;
    }
    for (std::size_t i = node.first; i < node.first + node.count; ++i) {
      const auto& [p, q, r] = triangles_[tree_->order[i]];
      if (p != from && q != from && r != from && crosses(a, to, positions_[p], positions_[q], positions_[r])) {
        return false;
      }
    }
    if (node.count == 0) {
      open.push_back(node.left);
      open.push_back(node.right);
    }
  }
  return true;
}

}  // namespace limbwave::motion
