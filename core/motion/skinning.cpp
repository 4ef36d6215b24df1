#include "motion/skinning.h"

#include <fmt/format.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "motion/surface.h"

namespace limbwave::motion {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
using Sparse = Eigen::SparseMatrix<double>;

// Nearer than this part of the mesh's size counts as this: a vertex on a bone would be infinitely hot.
constexpr double kNearest = 1e-3;
// Bones this much further than the nearest one heat a vertex just as much.
constexpr double kSameDistance = 1.0001;
// Weights below this are left out.
constexpr float kSmallest = 1e-3F;
// Angles of slivers: their cotangents would swamp all others.
constexpr double kLargestCotangent = 1e3;

// A head is above its joint and soles are below the ankles: parts of the joints' own height.
constexpr double kTaller = 1.12;
constexpr double kSoles = 0.05;
// A mesh within these of where it should be is left where it is: logarithm of heights, part of the height.
constexpr double kMuchTaller = 0.25;
constexpr double kFarOff = 0.15;

// One straight piece of a bone and the segment that it belongs to.
struct Piece {
  Vector3d a, b;
  std::size_t segment = 0;

  [[nodiscard]] Vector3d nearest(const Vector3d& p) const {
    const Vector3d way = b - a;
    const double length2 = way.squaredNorm();
    const double u = length2 > 0.0 ? std::clamp((p - a).dot(way) / length2, 0.0, 1.0) : 0.0;
    return a + u * way;
  }
};

// From every joint to each of its children, and along bones that end.
std::vector<Piece> pieces_of(const body::Skeleton& skeleton, const std::vector<body::SegmentPose>& bind) {
  std::vector<Piece> pieces;
  std::vector<bool> has_child(skeleton.segments.size(), false);
  for (std::size_t i = 0; i < skeleton.segments.size(); ++i) {
    const int parent = skeleton.segments[i].parent;
    if (parent >= 0) {
      has_child[static_cast<std::size_t>(parent)] = true;
      pieces.push_back({bind[static_cast<std::size_t>(parent)].p_WL, bind[i].p_WL, static_cast<std::size_t>(parent)});
    }
  }
  for (std::size_t i = 0; i < skeleton.segments.size(); ++i) {
    if (!has_child[i]) {
      const Vector3d end = bind[i].p_WL + bind[i].R_WL * Vector3d(skeleton.segments[i].length, 0, 0);
      pieces.push_back({bind[i].p_WL, end, i});
    }
  }
  return pieces;
}

// A mesh whose vertices at one place are one, and where each old vertex went.
struct Welded {
  std::vector<Vector3d> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> index;
};

Welded welded(const TriangleMesh& mesh) {
  Welded result;
  std::map<std::tuple<float, float, float>, std::uint32_t> at;
  for (const Vector3f& p : mesh.positions) {
    const auto [found, is_new] = at.try_emplace({p.x(), p.y(), p.z()}, static_cast<std::uint32_t>(at.size()));
    if (is_new) {
      result.positions.push_back(p.cast<double>());
    }
    result.index.push_back(found->second);
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::array<std::uint32_t, 3> triangle{result.index[a], result.index[b], result.index[c]};
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0]) {
      result.triangles.push_back(triangle);
    }
  }
  return result;
}

double cotangent(const Vector3d& at, const Vector3d& b, const Vector3d& c) {
  const double sine = (b - at).cross(c - at).norm();
  const double cosine = (b - at).dot(c - at);
  return std::clamp(sine > 0.0 ? cosine / sine : kLargestCotangent, -kLargestCotangent, kLargestCotangent);
}

// Cotangent Laplacian (positive semidefinite) and the vertices' areas, a third of each triangle's.
void laplacian(const Welded& mesh, std::vector<Eigen::Triplet<double>>& entries, Eigen::VectorXd& areas) {
  areas = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh.positions.size()));
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto i = static_cast<int>(triangle[(k + 1) % 3]);
      const auto j = static_cast<int>(triangle[(k + 2) % 3]);
      const Vector3d& apex = mesh.positions[triangle[k]];
      const Vector3d& p = mesh.positions[triangle[(k + 1) % 3]];
      const Vector3d& q = mesh.positions[triangle[(k + 2) % 3]];
      const double half = 0.5 * cotangent(apex, p, q);
      entries.emplace_back(i, i, half);
      entries.emplace_back(j, j, half);
      entries.emplace_back(i, j, -half);
      entries.emplace_back(j, i, -half);
      areas[static_cast<int>(triangle[k])] += (p - apex).cross(q - apex).norm() / 6.0;
    }
  }
}

// Parts of the surface that hang together: the number of each vertex's part.
std::vector<std::uint32_t> parts_of(const Welded& mesh) {
  std::vector<std::uint32_t> leader(mesh.positions.size());
  std::iota(leader.begin(), leader.end(), 0U);
  const auto find = [&](std::uint32_t v) {
    while (leader[v] != v) {
      v = leader[v] = leader[leader[v]];
    }
    return v;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    leader[find(a)] = find(b);
    leader[find(b)] = find(c);
  }
  for (std::uint32_t v = 0; v < leader.size(); ++v) {
    leader[v] = find(v);
  }
  return leader;
}

// How hot each vertex is, and which segments share the heat.
struct Heat {
  Eigen::VectorXd h;
  std::vector<std::vector<std::size_t>> segments;
};

class Heating {
 public:
  Heating(const Welded& mesh, std::vector<Piece> pieces, double heat)
      : mesh_(mesh), surface_(mesh.positions, mesh.triangles), pieces_(std::move(pieces)), heat_(heat) {
    Eigen::AlignedBox3d box;
    for (const Vector3d& p : mesh.positions) {
      box.extend(p);
    }
    nearest_ = kNearest * box.diagonal().norm();
    result_.h = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh.positions.size()));
    result_.segments.resize(mesh.positions.size());
  }

  Result<Heat> all(const Progress& progress) {
    const std::vector<std::uint32_t> parts = parts_of(mesh_);
    std::vector<bool> is_warm(mesh_.positions.size(), false);
    for (std::uint32_t v = 0; v < mesh_.positions.size(); ++v) {
      if (v % 1024 == 0 &&
          !progress.report(static_cast<double>(v) / static_cast<double>(mesh_.positions.size()), "finding bones")) {
        return cancelled();
      }
      if (vertex(v, true)) {
        is_warm[parts[v]] = true;
      }
    }
    for (std::uint32_t v = 0; v < mesh_.positions.size(); ++v) {
      if (!is_warm[parts[v]]) {
        vertex(v, false);
      }
    }
    return std::move(result_);
  }

 private:
  bool vertex(std::uint32_t v, bool must_see) {
    const Vector3d& p = mesh_.positions[v];
    std::vector<std::pair<double, std::size_t>> distances;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      distances.emplace_back((pieces_[i].nearest(p) - p).norm(), i);
    }
    std::ranges::sort(distances);
    double found = -1.0;
    for (const auto& [distance, piece] : distances) {
      if (found >= 0.0 && distance > kSameDistance * found) {
        break;
      }
      // Only the nearest bone and its equals count: what is behind a wall is not looked for further away.
      if (found < 0.0 && distance > kSameDistance * distances.front().first) {
        break;
      }
      if (!must_see || surface_.sees(v, pieces_[piece].nearest(p))) {
        found = found < 0.0 ? distance : found;
        const std::size_t segment = pieces_[piece].segment;
        if (std::ranges::find(result_.segments[v], segment) == result_.segments[v].end()) {
          result_.segments[v].push_back(segment);
        }
      }
    }
    if (found < 0.0) {
      return false;
    }
    const double distance = std::max(found, nearest_);
    result_.h[static_cast<Eigen::Index>(v)] = heat_ / (distance * distance);
    return true;
  }

  const Welded& mesh_;
  Surface surface_;
  std::vector<Piece> pieces_;
  double heat_;
  double nearest_ = 0.0;
  Heat result_;
};

// The strongest influences so far of every vertex.
struct Influences {
  std::array<std::uint16_t, kInfluences> segments{};
  std::array<float, kInfluences> weights{};

  void add(std::size_t segment, float weight) {
    std::size_t place = kInfluences;
    while (place > 0 && weights[place - 1] < weight) {
      --place;
    }
    if (place == kInfluences) {
      return;
    }
    for (std::size_t k = kInfluences - 1; k > place; --k) {
      weights[k] = weights[k - 1];
      segments[k] = segments[k - 1];
    }
    weights[place] = weight;
    segments[place] = static_cast<std::uint16_t>(segment);
  }
  void normalise() {
    float sum = 0.0F;
    for (const float weight : weights) {
      sum += weight;
    }
    for (std::size_t k = 0; k < kInfluences; ++k) {
      weights[k] = sum > 0.0F ? weights[k] / sum : (k == 0 ? 1.0F : 0.0F);
      segments[k] = weights[k] > 0.0F ? segments[k] : std::uint16_t{0};
    }
  }
};

Status check(const TriangleMesh& mesh, const body::Skeleton& skeleton, const std::vector<body::SegmentPose>& bind) {
  const auto wrong = [&](const std::string& what) {
    return Error{what, mesh.name, "choose a mesh of triangles that stands around the skeleton"};
  };
  if (mesh.triangles.empty()) {
    return wrong("the mesh has no triangles");
  }
  if (skeleton.segments.empty() || bind.size() != skeleton.segments.size()) {
    return wrong("there is no skeleton to bind it to");
  }
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (!mesh.positions[v].allFinite()) {
      return wrong(fmt::format("vertex {} is not a number", v));
    }
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (std::ranges::any_of(mesh.triangles[t], [&](std::uint32_t v) { return v >= mesh.positions.size(); })) {
      return wrong(fmt::format("triangle {} has a corner that does not exist", t));
    }
  }
  return {};
}

}  // namespace

Result<SkinnedMesh> skinned(const TriangleMesh& mesh, const body::Skeleton& skeleton,
                            const std::vector<body::SegmentPose>& bind, const SkinningOptions& options,
                            const Progress& progress) {
  if (const Status fine = check(mesh, skeleton, bind); !fine) {
    return fine.error();
  }
  const Welded surface = welded(mesh);
  const Result<Heat> heat = Heating(surface, pieces_of(skeleton, bind), options.heat).all(progress.part(0.0, 0.5));
  if (!heat) {
    return heat.error();
  }
  const auto n = static_cast<Eigen::Index>(surface.positions.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd areas;
  laplacian(surface, entries, areas);
  // Vertices without area (on no triangle, or on slivers) are held by a little heat of their own.
  areas = areas.cwiseMax(1e-12 * std::max(areas.sum(), 1e-12));
  for (Eigen::Index v = 0; v < n; ++v) {
    entries.emplace_back(static_cast<int>(v), static_cast<int>(v), areas[v] * (heat->h[v] + 1e-9));
  }
  Sparse matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  if (!progress.report(0.5, "solving")) {
    return cancelled();
  }
  const Eigen::SimplicialLDLT<Sparse> solver(matrix);
  if (solver.info() != Eigen::Success) {
    return Error{"the equations of the skin cannot be solved", mesh.name,
                 "repair the mesh: close holes, merge slivers"};
  }
  std::vector<Influences> influences(surface.positions.size());
  for (std::size_t s = 0; s < skeleton.segments.size(); ++s) {
    if (!progress.report(0.6 + 0.4 * static_cast<double>(s) / static_cast<double>(skeleton.segments.size()),
                         "spreading heat")) {
      return cancelled();
    }
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
    bool heats = false;
    for (Eigen::Index v = 0; v < n; ++v) {
      const std::vector<std::size_t>& shared = heat->segments[static_cast<std::size_t>(v)];
      if (std::ranges::find(shared, s) != shared.end()) {
        right[v] = areas[v] * heat->h[v] / static_cast<double>(shared.size());
        heats = true;
      }
    }
    if (!heats) {
      continue;
    }
    const Eigen::VectorXd weights = solver.solve(right);
    for (Eigen::Index v = 0; v < n; ++v) {
      const auto weight = static_cast<float>(weights[v]);
      if (weight > kSmallest) {
        influences[static_cast<std::size_t>(v)].add(s, weight);
      }
    }
  }
  SkinnedMesh result;
  result.name = mesh.name;
  result.positions = mesh.positions;
  result.triangles = mesh.triangles;
  result.normals = smooth_normals(mesh.positions, mesh.triangles);
  result.bind_poses = bind;
  for (Influences& influence : influences) {
    influence.normalise();
  }
  for (const std::uint32_t v : surface.index) {
    result.segments.push_back(influences[v].segments);
    result.weights.push_back(influences[v].weights);
  }
  return result;
}

TriangleMesh fitted(TriangleMesh mesh, const std::vector<body::SegmentPose>& bind) {
  Eigen::AlignedBox3d joints;
  for (const body::SegmentPose& pose : bind) {
    joints.extend(pose.p_WL);
  }
  Eigen::AlignedBox3d box;
  for (const Vector3f& p : mesh.positions) {
    box.extend(p.cast<double>());
  }
  if (joints.isEmpty() || box.isEmpty() || !(box.sizes().z() > 0.0) || !(joints.sizes().z() > 0.0)) {
    return mesh;
  }
  const double height = joints.sizes().z() * kTaller;
  const double below = kSoles * joints.sizes().z();
  const Vector3d off = box.center() - joints.center();
  const bool stands_there = std::abs(std::log(box.sizes().z() / height)) < kMuchTaller &&
                            off.head<2>().norm() < kFarOff * height &&
                            std::abs(box.min().z() - joints.min().z() + below) < kFarOff * height;
  if (stands_there) {
    return mesh;
  }
  const double scale = height / box.sizes().z();
  const Vector3d from(box.center().x(), box.center().y(), box.min().z());
  const Vector3d to(joints.center().x(), joints.center().y(), joints.min().z() - below);
  for (Vector3f& p : mesh.positions) {
    p = (to + scale * (p.cast<double>() - from)).cast<float>();
  }
  return mesh;
}

}  // namespace limbwave::motion
