#include "interchange/gltf_mesh_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "interchange/file_axes.h"
#include "interchange/names.h"
#include "motion/clip.h"

namespace limbwave::interchange {
namespace {

using Eigen::Vector3d;
using motion::kInfluences;
using motion::SkinnedMesh;

// Vertices and corners of all meshes together, beside one for each byte of the file's buffers: meshes may share their
// numbers, and numbers may be left out, so that a few bytes would ask for very many.
constexpr std::size_t kMostVertices = 2'000'000;

class MeshReader {
 public:
  MeshReader(const tinygltf::Model& model, const GltfTree& tree, const std::string& place, Diagnostics& diagnostics)
      : model_(model), tree_(tree), place_(place), diagnostics_(diagnostics), world_(gltf_world(model)) {
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
      segment_of_[tree.nodes[i]] = i;
    }
    for (const tinygltf::Buffer& buffer : model.buffers) {
      left_ += buffer.data.size();
    }
  }

  Result<GltfMeshes> read() {
    GltfMeshes meshes;
    for (const tinygltf::Node& node : model_.nodes) {
      if (node.mesh < 0 || node.skin < 0) {
        continue;
      }
      if (static_cast<std::size_t>(node.mesh) >= model_.meshes.size() ||
          static_cast<std::size_t>(node.skin) >= model_.skins.size()) {
        where_ = fmt::format("node \"{}\"", node.name);
        return broken("its mesh or skin does not exist");
      }
      const tinygltf::Skin& skin = model_.skins[static_cast<std::size_t>(node.skin)];
      if (skin.joints.empty() || !segment_of_.contains(skin.joints.front())) {
        continue;
      }
      where_ = fmt::format("/skins/{}", node.skin);
      SkinnedMesh mesh;
      mesh.name = to_utf8(node.name.empty() ? "mesh" : node.name);
      if (Status status = bind(skin, mesh); !status) {
        return status.error();
      }
      const tinygltf::Mesh& source = model_.meshes[static_cast<std::size_t>(node.mesh)];
      for (std::size_t p = 0; p < source.primitives.size(); ++p) {
        where_ = fmt::format("/meshes/{}/primitives/{}", node.mesh, p);
        if (Status status = add(source.primitives[p], skin, mesh); !status) {
          return status.error();
        }
      }
      if (!mesh.normals.empty() && mesh.normals.size() != mesh.positions.size()) {
        mesh.normals.clear();  // only some of its parts have them
      }
      if (!mesh.positions.empty()) {
        if (Status status = motion::validate(mesh, tree_.skeleton); !status) {
          return status.error();
        }
        meshes.push_back(std::make_shared<SkinnedMesh>(std::move(mesh)));
      }
    }
    return meshes;
  }

 private:
  [[nodiscard]] Error broken(const std::string& what) const {
    return {where_ + ": " + what, place_, "export it again from the program that made it"};
  }
  void warn(const std::string& code, const std::string& what) {
    diagnostics_.push_back({Severity::kWarning, code, where_ + ": " + what, "", place_});
  }

  // Where the joints are when the mesh is bound, and where vertices go: the first joint's rest place holds both.
  Status bind(const tinygltf::Skin& skin, SkinnedMesh& mesh) {
    std::vector<Similarity> inverse(skin.joints.size());
    if (skin.inverseBindMatrices >= 0) {
      const auto matrices = gltf_numbers(model_, skin.inverseBindMatrices, {TINYGLTF_TYPE_MAT4});
      if (!matrices || matrices->count() < inverse.size()) {
        return broken("its inverse bind matrices are not whole");
      }
      for (std::size_t j = 0; j < inverse.size(); ++j) {
        bool is_uniform = true;
        const Eigen::Map<const Eigen::Matrix4f> matrix(matrices->values.data() + 16 * j);
        inverse[j] = similarity_of(matrix.cast<double>(), is_uniform);
        if (!(inverse[j].scale > 0.0)) {
          return broken(fmt::format("inverse bind matrix {} cannot be used", j));
        }
      }
    }
    to_world_ = world_[static_cast<std::size_t>(skin.joints.front())] * inverse.front();
    mesh.bind_poses = motion::rest_poses(tree_.skeleton);
    for (std::size_t j = 0; j < inverse.size(); ++j) {
      const auto segment = segment_of_.find(skin.joints[j]);
      if (segment == segment_of_.end()) {
        return broken(fmt::format("joint {} hangs on another tree than joint 0", j));
      }
      const Similarity bound = to_world_ * inverse[j].inverse();
      mesh.bind_poses[segment->second] = {from_y_up(bound.R).normalized(), from_y_up(bound.p)};
    }
    return {};
  }

  Status add(const tinygltf::Primitive& primitive, const tinygltf::Skin& skin, SkinnedMesh& mesh) {
    if (primitive.mode != TINYGLTF_MODE_TRIANGLES && primitive.mode != -1) {
      warn("gltf.not-triangles", "is no list of triangles and is left out");
      return {};
    }
    const auto accessor = [&](const char* name) {
      const auto found = primitive.attributes.find(name);
      return found == primitive.attributes.end() ? -1 : found->second;
    };
    const auto positions = gltf_numbers(model_, accessor("POSITION"), {TINYGLTF_TYPE_VEC3});
    if (!positions) {
      return broken("its positions are not whole");
    }
    const std::size_t n = positions->count();
    if (n > left_) {
      return broken("there are more vertices than can be read");
    }
    left_ -= n;
    const std::size_t first = mesh.positions.size();
    const auto vector = [](const GltfNumbers& of, std::size_t i) {
      return Vector3d(static_cast<double>(of.values[3 * i]), static_cast<double>(of.values[3 * i + 1]),
                      static_cast<double>(of.values[3 * i + 2]));
    };
    for (std::size_t v = 0; v < n; ++v) {
      const Vector3d p = to_world_.p + to_world_.scale * (to_world_.R * vector(*positions, v));
      mesh.positions.emplace_back(from_y_up(p).cast<float>());
    }
    if (const auto normals = gltf_numbers(model_, accessor("NORMAL"), {TINYGLTF_TYPE_VEC3});
        normals && normals->count() == n && mesh.normals.size() == first) {
      for (std::size_t v = 0; v < n; ++v) {
        mesh.normals.emplace_back(from_y_up(Vector3d(to_world_.R * vector(*normals, v))).cast<float>());
      }
    }
    if (Status status = weights(primitive, skin, n, mesh); !status) {
      return status;
    }
    return triangles(primitive, n, first, mesh);
  }

  // The four strongest influences of each vertex, their weights summing to 1.
  Status weights(const tinygltf::Primitive& primitive, const tinygltf::Skin& skin, std::size_t n, SkinnedMesh& mesh) {
    std::vector<std::pair<std::vector<std::uint32_t>, GltfNumbers>> sets;
    for (int set = 0;; ++set) {
      const auto joints = primitive.attributes.find(fmt::format("JOINTS_{}", set));
      const auto weights = primitive.attributes.find(fmt::format("WEIGHTS_{}", set));
      if (joints == primitive.attributes.end() || weights == primitive.attributes.end()) {
        break;
      }
      auto indices = gltf_integers(model_, joints->second, {TINYGLTF_TYPE_VEC4});
      auto numbers = gltf_numbers(model_, weights->second, {TINYGLTF_TYPE_VEC4});
      if (!indices || !numbers || indices->size() != 4 * n || numbers->count() != n) {
        return broken("its joints and weights are not whole");
      }
      sets.emplace_back(*std::move(indices), *std::move(numbers));
    }
    if (sets.empty()) {
      return broken("has a skin but no joints and weights");
    }
    if (sets.size() > 1) {
      warn("gltf.influences", "vertices follow more than four bones; the four strongest are kept");
    }
    for (std::size_t v = 0; v < n; ++v) {
      std::vector<std::pair<float, std::uint32_t>> all;
      for (const auto& [joints, numbers] : sets) {
        for (std::size_t k = 0; k < 4; ++k) {
          const float weight = numbers.values[4 * v + k];
          if (weight > 0.0F) {
            all.emplace_back(weight, joints[4 * v + k]);
          }
        }
      }
      std::ranges::sort(all, std::greater<>());
      all.resize(std::min(all.size(), kInfluences));
      float sum = 0.0F;
      for (const auto& [weight, joint] : all) {
        sum += weight;
        if (joint >= skin.joints.size()) {
          return broken(fmt::format("vertex {} follows joint {} of {}", v, joint, skin.joints.size()));
        }
      }
      std::array<std::uint16_t, kInfluences> segments{};
      std::array<float, kInfluences> shares{};
      if (!(sum > 0.0F) || !std::isfinite(sum)) {
        all = {{1.0F, 0}};  // without weight: with the first joint
        sum = 1.0F;
      }
      for (std::size_t k = 0; k < all.size(); ++k) {
        segments[k] = static_cast<std::uint16_t>(segment_of_.at(skin.joints[all[k].second]));
        shares[k] = all[k].first / sum;
      }
      mesh.segments.push_back(segments);
      mesh.weights.push_back(shares);
    }
    return {};
  }

  Status triangles(const tinygltf::Primitive& primitive, std::size_t n, std::size_t first, SkinnedMesh& mesh) {
    std::vector<std::uint32_t> corners;
    if (primitive.indices >= 0) {
      auto indices = gltf_integers(model_, primitive.indices, {TINYGLTF_TYPE_SCALAR});
      if (!indices) {
        return broken("its indices are not whole");
      }
      corners = *std::move(indices);
    } else {
      for (std::size_t v = 0; v < n; ++v) {
        corners.push_back(static_cast<std::uint32_t>(v));
      }
    }
    if (corners.size() > left_) {
      return broken("there are more triangles than can be read");
    }
    left_ -= corners.size();
    for (std::size_t c = 0; c + 2 < corners.size(); c += 3) {
      std::array<std::uint32_t, 3> triangle{};
      for (std::size_t k = 0; k < 3; ++k) {
        if (corners[c + k] >= n) {
          return broken(fmt::format("index {} is {} of {} vertices", c + k, corners[c + k], n));
        }
        triangle[k] = static_cast<std::uint32_t>(first + corners[c + k]);
      }
      mesh.triangles.push_back(triangle);
    }
    return {};
  }

  const tinygltf::Model& model_;
  const GltfTree& tree_;
  const std::string& place_;
  Diagnostics& diagnostics_;
  std::vector<Similarity> world_;
  std::map<int, std::size_t> segment_of_;
  Similarity to_world_;  // from the mesh's own space to the file's world, as it is bound
  std::string where_;
  std::size_t left_ = kMostVertices;
};

}  // namespace

Result<GltfMeshes> gltf_meshes(const tinygltf::Model& model, const GltfTree& tree, const std::string& place,
                               Diagnostics& diagnostics) {
  return MeshReader(model, tree, place, diagnostics).read();
}

}  // namespace limbwave::interchange
