#include "interchange/gltf_bones.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "interchange/file_axes.h"
#include "interchange/names.h"

namespace limbwave::interchange {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

// Scales that differ by less are one.
constexpr double kUniform = 1e-4;
constexpr double kSmallestScale = 1e-9;
constexpr std::size_t kMostNodes = 65535;
constexpr double kLongestBone = 1e6;

Similarity local(const tinygltf::Node& node, bool& is_uniform) {
  is_uniform = true;
  if (node.matrix.size() == 16) {
    return similarity_of(Eigen::Map<const Eigen::Matrix4d>(node.matrix.data()), is_uniform);
  }
  Similarity place;
  if (node.translation.size() == 3) {
    place.p = Vector3d(node.translation[0], node.translation[1], node.translation[2]);
  }
  if (node.rotation.size() == 4) {
    const Quaterniond q(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
    place.R = q.norm() > kSmallestScale && q.coeffs().allFinite() ? q.normalized() : Quaterniond::Identity();
  }
  if (node.scale.size() == 3) {
    const Vector3d scale(node.scale[0], node.scale[1], node.scale[2]);
    place.scale = scale.mean();
    is_uniform = (scale.array() - place.scale).abs().maxCoeff() <= kUniform * std::abs(place.scale);
  }
  return place;
}

// How long the bone is, when Limbwave wrote it; in the unit of the file.
std::optional<double> length_in(const tinygltf::Node& node) {
  if (!node.extras.IsObject() || !node.extras.Has(kGltfLength) || !node.extras.Get(kGltfLength).IsNumber()) {
    return {};
  }
  const double length = node.extras.Get(kGltfLength).GetNumberAsDouble();
  return length >= 0.0 && length < kLongestBone ? std::optional(length) : std::nullopt;
}

bool is_usable(const Similarity& place) {
  return place.p.allFinite() && std::isfinite(place.scale) && place.scale > kSmallestScale;
}

class Trees {
 public:
  Trees(const tinygltf::Model& model, const std::string& place, Diagnostics& diagnostics)
      : model_(model),
        place_(place),
        diagnostics_(diagnostics),
        parent_(model.nodes.size(), -1),
        is_marked_(model.nodes.size(), false),
        is_fixed_(model.nodes.size(), true) {}

  Result<std::vector<GltfTree>> find() {
    if (model_.nodes.size() > kMostNodes) {
      return broken(fmt::format("it has {} nodes", model_.nodes.size()));
    }
    if (Status status = link(); !status) {
      return status.error();
    }
    if (Status status = mark(); !status) {
      return status.error();
    }
    std::vector<GltfTree> trees;
    for (std::size_t node = 0; node < parent_.size(); ++node) {
      if (parent_[node] < 0 && is_marked_[node]) {
        Result<GltfTree> tree = build(static_cast<int>(node));
        if (!tree) {
          return tree.error();
        }
        trees.push_back(*std::move(tree));
      }
    }
    return trees;
  }

 private:
  [[nodiscard]] Error broken(const std::string& what) const {
    return {what, place_, "export it again from the program that made it"};
  }
  [[nodiscard]] bool exists(int node) const {
    return node >= 0 && static_cast<std::size_t>(node) < model_.nodes.size();
  }

  // Parents, and no circles: a node with one parent whose chain of parents ends.
  Status link() {
    for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
      for (const int child : model_.nodes[i].children) {
        if (!exists(child)) {
          return broken(fmt::format("/nodes/{}/children: node {} does not exist", i, child));
        }
        if (parent_[static_cast<std::size_t>(child)] >= 0) {
          return broken(fmt::format("/nodes/{}: is the child of two nodes", child));
        }
        parent_[static_cast<std::size_t>(child)] = static_cast<int>(i);
      }
    }
    std::vector<int> state(parent_.size(), 0);  // 1: on the present way up, 2: known to end
    for (std::size_t i = 0; i < parent_.size(); ++i) {
      std::vector<std::size_t> way;
      for (int node = static_cast<int>(i); node >= 0 && state[static_cast<std::size_t>(node)] != 2;
           node = parent_[static_cast<std::size_t>(node)]) {
        const auto n = static_cast<std::size_t>(node);
        if (state[n] == 1) {
          return broken(fmt::format("/nodes/{}: is its own ancestor", node));
        }
        state[n] = 1;
        way.push_back(n);
      }
      for (const std::size_t n : way) {
        state[n] = 2;
      }
    }
    return {};
  }

  void mark_up(int node) {
    for (; node >= 0 && !is_marked_[static_cast<std::size_t>(node)]; node = parent_[static_cast<std::size_t>(node)]) {
      is_marked_[static_cast<std::size_t>(node)] = true;
    }
  }

  // Joints, what moves and what Limbwave wrote as a bone, with all their ancestors; without any, all nodes that are no
  // meshes, cameras or lights.
  Status mark() {
    for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
      if (length_in(model_.nodes[i])) {
        mark_up(static_cast<int>(i));
        is_fixed_[i] = false;
      }
    }
    for (std::size_t s = 0; s < model_.skins.size(); ++s) {
      for (const int joint : model_.skins[s].joints) {
        if (!exists(joint)) {
          return broken(fmt::format("/skins/{}/joints: node {} does not exist", s, joint));
        }
        mark_up(joint);
        is_fixed_[static_cast<std::size_t>(joint)] = false;
      }
    }
    for (std::size_t a = 0; a < model_.animations.size(); ++a) {
      for (const auto& channel : model_.animations[a].channels) {
        const bool moves = channel.target_path == "rotation" || channel.target_path == "translation";
        if (moves && exists(channel.target_node)) {
          mark_up(channel.target_node);
          is_fixed_[static_cast<std::size_t>(channel.target_node)] = false;
        }
      }
    }
    if (std::ranges::find(is_marked_, true) == is_marked_.end()) {
      for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
        if (model_.nodes[i].mesh < 0 && model_.nodes[i].camera < 0) {
          mark_up(static_cast<int>(i));
          is_fixed_[i] = false;
        }
      }
    }
    return {};
  }

  [[nodiscard]] std::vector<int> bones_below(int node) const {
    std::vector<int> bones;
    for (const int child : model_.nodes[static_cast<std::size_t>(node)].children) {
      if (is_marked_[static_cast<std::size_t>(child)]) {
        bones.push_back(child);
      }
    }
    return bones;
  }

  Similarity checked_local(int node, bool& is_good) {
    bool is_uniform = true;
    const auto& entry = model_.nodes[static_cast<std::size_t>(node)];
    Similarity place = local(entry, is_uniform);
    is_good = is_usable(place);
    if (!is_uniform && is_good) {
      diagnostics_.push_back({Severity::kWarning, "gltf.scale",
                              fmt::format("\"{}\" is scaled differently along its axes; the mean counts", entry.name),
                              "apply the scale in the program that made it", place_});
    }
    return place;
  }

  Result<GltfTree> build(int root) {
    GltfTree tree;
    bool is_good = true;
    const auto bad = [&](int node) {
      return broken(fmt::format("/nodes/{}: its place or scale is not a usable number", node));
    };
    // What holds still above the first joint or branch is no bone: an armature's node, a change of axes or of unit.
    for (std::vector<int> below = bones_below(root); is_fixed_[static_cast<std::size_t>(root)] && below.size() == 1;
         below = bones_below(root)) {
      tree.above = tree.above * checked_local(root, is_good);
      if (!is_good || !is_usable(tree.above)) {
        return bad(root);
      }
      root = below.front();
    }
    struct Next {
      int node, parent;
      double scale;
    };
    std::vector<Next> open{{root, -1, tree.above.scale}};
    UniqueNames unique;
    while (!open.empty()) {
      const Next next = open.back();
      open.pop_back();
      const Similarity place = checked_local(next.node, is_good);
      const double scale = next.scale * place.scale;
      if (!is_good || !(scale > kSmallestScale)) {
        return bad(next.node);
      }
      const auto index = static_cast<int>(tree.nodes.size());
      body::Segment segment;
      const std::string& name = model_.nodes[static_cast<std::size_t>(next.node)].name;
      segment.name = unique(name.empty() ? fmt::format("node{}", next.node) : to_utf8(name));
      segment.parent = next.parent;
      const Similarity world = next.parent < 0 ? tree.above * place : place;
      segment.p_PL = from_y_up(next.parent < 0 ? world.p : Vector3d(place.p * next.scale));
      segment.R_PL_rest = from_y_up(world.R);
      tree.nodes.push_back(next.node);
      tree.scales.push_back(next.scale);
      tree.skeleton.segments.push_back(std::move(segment));
      const std::vector<int> below = bones_below(next.node);
      for (auto child = below.rbegin(); child != below.rend(); ++child) {
        open.push_back({*child, index, scale});
      }
    }
    set_lengths(tree);
    return tree;
  }

  // As the file says, else to the mean of the children's joints, as bones are drawn.
  void set_lengths(GltfTree& tree) const {
    body::Skeleton& skeleton = tree.skeleton;
    std::vector<int> children(skeleton.segments.size(), 0);
    std::vector<Vector3d> sums(skeleton.segments.size(), Vector3d::Zero());
    for (const body::Segment& segment : skeleton.segments) {
      if (segment.parent >= 0) {
        ++children[static_cast<std::size_t>(segment.parent)];
        sums[static_cast<std::size_t>(segment.parent)] += segment.p_PL;
      }
    }
    for (std::size_t i = 0; i < children.size(); ++i) {
      const std::optional<double> said = length_in(model_.nodes[static_cast<std::size_t>(tree.nodes[i])]);
      const double drawn = children[i] > 0 ? sums[i].norm() / children[i] : 0.0;
      skeleton.segments[i].length = said ? *said * tree.scales[i] : drawn;
    }
  }

  const tinygltf::Model& model_;
  const std::string& place_;
  Diagnostics& diagnostics_;
  std::vector<int> parent_;
  std::vector<bool> is_marked_;  // bones and what is above them
  std::vector<bool> is_fixed_;   // neither joints nor moving
};

}  // namespace

Similarity similarity_of(const Eigen::Matrix4d& matrix, bool& is_uniform) {
  Similarity place;
  const Eigen::Matrix3d linear = matrix.topLeftCorner<3, 3>();
  const Vector3d scales = linear.colwise().norm();
  const double scale = scales.mean();
  const bool usable = matrix.allFinite() && scales.minCoeff() > kSmallestScale && linear.determinant() > 0.0;
  if (!usable) {
    place.scale = 0.0;
    is_uniform = true;
    return place;
  }
  is_uniform = (scales.array() - scale).abs().maxCoeff() <= kUniform * scale;
  // The nearest rotation, whatever shear there is.
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(linear, Eigen::ComputeFullU | Eigen::ComputeFullV);
  place.R = Quaterniond(Eigen::Matrix3d(svd.matrixU() * svd.matrixV().transpose())).normalized();
  place.p = matrix.topRightCorner<3, 1>();
  place.scale = scale;
  return place;
}

Result<std::vector<GltfTree>> gltf_trees(const tinygltf::Model& model, const std::string& place,
                                         Diagnostics& diagnostics) {
  return Trees(model, place, diagnostics).find();
}

std::vector<Similarity> gltf_world(const tinygltf::Model& model) {
  std::vector<Similarity> world(model.nodes.size());
  std::vector<bool> is_child(model.nodes.size(), false);
  for (const tinygltf::Node& node : model.nodes) {
    for (const int child : node.children) {
      is_child[static_cast<std::size_t>(child)] = true;
    }
  }
  std::vector<std::size_t> open;
  bool ignored = true;
  for (std::size_t i = 0; i < world.size(); ++i) {
    if (!is_child[i]) {
      world[i] = local(model.nodes[i], ignored);
      open.push_back(i);
    }
  }
  while (!open.empty()) {
    const std::size_t node = open.back();
    open.pop_back();
    for (const int child : model.nodes[node].children) {
      const auto c = static_cast<std::size_t>(child);
      world[c] = world[node] * local(model.nodes[c], ignored);
      open.push_back(c);
    }
  }
  return world;
}

}  // namespace limbwave::interchange
