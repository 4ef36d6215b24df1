#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <list>

#include "base/atomic_file.h"
#include "interchange/bone_map.h"
#include "interchange/clip_check.h"
#include "interchange/file_axes.h"
#include "interchange/gltf_bones.h"
#include "interchange/gltf_buffer.h"
#include "interchange/gltf_curves.h"
#include "interchange/gltf_file.h"
#include "interchange/gltf_keys.h"
#include "interchange/names.h"

namespace limbwave::interchange {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using Eigen::Vector3f;

// A calm grey that is seen on light and dark floors.
const std::vector<double> kSkinColour{0.55, 0.57, 0.60, 1.0};

std::vector<double> numbers(const Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}
std::vector<double> numbers(const Quaterniond& q) {
  return {q.x(), q.y(), q.z(), q.w()};
}

std::string extension_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return extension;
}

class SceneWriter {
 public:
  SceneWriter() : buffer_(model_) {
    model_.asset.version = "2.0";
    model_.asset.generator = "Limbwave";
    model_.scenes.emplace_back();
    model_.defaultScene = 0;
  }

  // Something for the bones of one of several actors to hang on: importers make it the armature of its own.
  void add_actor(const motion::Clip& clip) {
    tinygltf::Node node;
    const std::string& name = clip.skeleton.name.empty() ? clip.name : clip.skeleton.name;
    node.name = unique_(to_utf8(name.empty() ? "actor" : name));
    model_.nodes.push_back(std::move(node));
    above_ = static_cast<int>(model_.nodes.size()) - 1;
    model_.scenes[0].nodes.push_back(above_);
  }

  void add_bones(const motion::Clip& clip) {
    first_ = static_cast<int>(model_.nodes.size());
    for (const body::Segment& segment : clip.skeleton.segments) {
      tinygltf::Node node;
      node.name = unique_(to_utf8(segment.name));
      node.translation = numbers(to_y_up(segment.p_PL));
      node.rotation = numbers(to_y_up(segment.R_PL_rest.normalized()));
      node.extras = tinygltf::Value(tinygltf::Value::Object{{kGltfLength, tinygltf::Value(segment.length)}});
      model_.nodes.push_back(std::move(node));
      const int index = static_cast<int>(model_.nodes.size()) - 1;
      if (segment.parent < 0) {
        (above_ < 0 ? model_.scenes[0].nodes : model_.nodes[static_cast<std::size_t>(above_)].children)
            .push_back(index);
      } else {
        model_.nodes[static_cast<std::size_t>(first_) + static_cast<std::size_t>(segment.parent)].children.push_back(
            index);
      }
    }
  }

  // The meshes of the clip whose bones were added last.
  void add_meshes(const motion::Clip& clip) {
    for (const auto& mesh : clip.meshes) {
      const int skin = add_skin(clip, *mesh);
      tinygltf::Node node;
      node.name = unique_(to_utf8(mesh->name.empty() ? "mesh" : mesh->name));
      node.mesh = add_mesh(*mesh, node.name);
      node.skin = skin;
      model_.nodes.push_back(std::move(node));
      // At the scene's root: a skinned mesh stands where its joints say, whatever node it is on.
      model_.scenes[0].nodes.push_back(static_cast<int>(model_.nodes.size()) - 1);
    }
  }

  // Long tracks are written from the clip itself, which must stay as it is until `finish`.
  void add_tracks(const motion::Clip& clip) {
    for (std::size_t i = 0; i < clip.joints.size(); ++i) {
      const int node = first_ + static_cast<int>(i);
      channel(clip.joints[i].rotation, clip.frame_rate_hz, node, "rotation", TINYGLTF_TYPE_VEC4);
      channel(clip.joints[i].position, clip.frame_rate_hz, node, "translation", TINYGLTF_TYPE_VEC3);
    }
    channel(clip.root_position, clip.frame_rate_hz, first_, "translation", TINYGLTF_TYPE_VEC3);
  }

  void add_vrm(const motion::Clip& clip) {
    tinygltf::Value::Object bones;
    const std::vector<std::string> roles = roles_of(clip.skeleton);
    for (std::size_t i = 0; i < roles.size(); ++i) {
      if (!roles[i].empty()) {
        bones[roles[i]] =
            tinygltf::Value(tinygltf::Value::Object{{"node", tinygltf::Value(first_ + static_cast<int>(i))}});
      }
    }
    const auto text = [](const char* words) { return tinygltf::Value(std::string(words)); };
    tinygltf::Value::Object meta{
        {"name", tinygltf::Value(to_utf8(clip.name.empty() ? "Limbwave" : clip.name))},
        {"authors", tinygltf::Value(tinygltf::Value::Array{text("Limbwave")})},
        {"licenseUrl", text("https://vrm.dev/licenses/1.0/")},
    };
    tinygltf::Value::Object vrm{
        {"specVersion", text("1.0")},
        {"meta", tinygltf::Value(std::move(meta))},
        {"humanoid", tinygltf::Value(tinygltf::Value::Object{{"humanBones", tinygltf::Value(std::move(bones))}})}};
    model_.extensions["VRMC_vrm"] = tinygltf::Value(std::move(vrm));
    model_.extensionsUsed.push_back("VRMC_vrm");
  }

  Status finish(const motion::Clip& first, const std::filesystem::path& path, const Progress& progress) {
    model_.scenes[0].name = to_utf8(first.name.empty() ? "clip" : first.name);
    animation_.name = model_.scenes[0].name;
    if (!animation_.channels.empty()) {
      model_.animations.push_back(std::move(animation_));
    }
    // glTF knows no frames; ours are read again.
    model_.asset.extras =
        tinygltf::Value(tinygltf::Value::Object{{"frame_rate_hz", tinygltf::Value(first.frame_rate_hz)}});
    AtomicFile file(path);
    if (Status status = write_gltf_file(model_, buffer_, extension_of(path) != ".gltf", file, path.string(), progress);
        !status) {
      return status;
    }
    return file.commit();
  }

 private:
  int add_skin(const motion::Clip& clip, const motion::SkinnedMesh& mesh) {
    tinygltf::Skin skin;
    std::vector<float> matrices;
    const std::vector<body::SegmentPose> bind =
        mesh.bind_poses.empty() ? motion::rest_poses(clip.skeleton) : mesh.bind_poses;
    for (std::size_t i = 0; i < clip.skeleton.segments.size(); ++i) {
      skin.joints.push_back(first_ + static_cast<int>(i));
      const Quaterniond R = to_y_up(bind[i].R_WL).conjugate();
      Eigen::Matrix4f inverse = Eigen::Matrix4f::Identity();
      inverse.topLeftCorner<3, 3>() = R.toRotationMatrix().cast<float>();
      inverse.topRightCorner<3, 1>() = (-(R * to_y_up(bind[i].p_WL))).cast<float>();
      matrices.insert(matrices.end(), inverse.data(), inverse.data() + 16);  // column by column, as glTF wants
    }
    skin.inverseBindMatrices = buffer_.add_floats(matrices, TINYGLTF_TYPE_MAT4);
    skin.skeleton = first_;
    model_.skins.push_back(std::move(skin));
    return static_cast<int>(model_.skins.size()) - 1;
  }

  int add_mesh(const motion::SkinnedMesh& mesh, const std::string& name) {
    if (model_.materials.empty()) {
      tinygltf::Material material;
      material.name = "skin";
      material.pbrMetallicRoughness.baseColorFactor = kSkinColour;
      material.pbrMetallicRoughness.metallicFactor = 0.0;
      material.pbrMetallicRoughness.roughnessFactor = 0.8;
      model_.materials.push_back(std::move(material));
    }
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.material = 0;
    const auto vectors = [](const std::vector<Vector3f>& of) {
      std::vector<float> flat;
      flat.reserve(of.size() * 3);
      for (const Vector3f& v : of) {
        const Vector3f turned = to_y_up(v.cast<double>()).cast<float>();
        flat.insert(flat.end(), turned.data(), turned.data() + 3);
      }
      return flat;
    };
    primitive.attributes["POSITION"] =
        buffer_.add_floats(vectors(mesh.positions), TINYGLTF_TYPE_VEC3, TINYGLTF_TARGET_ARRAY_BUFFER, true);
    if (!mesh.normals.empty()) {
      primitive.attributes["NORMAL"] =
          buffer_.add_floats(vectors(mesh.normals), TINYGLTF_TYPE_VEC3, TINYGLTF_TARGET_ARRAY_BUFFER);
    }
    std::vector<std::uint16_t> joints;
    std::vector<float> weights;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      float sum = 0.0F;
      for (std::size_t k = 0; k < motion::kInfluences; ++k) {
        sum += mesh.weights[v][k];
      }
      for (std::size_t k = 0; k < motion::kInfluences; ++k) {
        // A joint without weight must be joint 0; the sum must be 1 as nearly as floats allow.
        joints.push_back(mesh.weights[v][k] > 0.0F ? mesh.segments[v][k] : std::uint16_t{0});
        weights.push_back(mesh.weights[v][k] / sum);
      }
    }
    primitive.attributes["JOINTS_0"] =
        buffer_.add(std::span<const std::uint16_t>(joints), 4, TINYGLTF_TYPE_VEC4,
                    TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TARGET_ARRAY_BUFFER, false);
    primitive.attributes["WEIGHTS_0"] = buffer_.add_floats(weights, TINYGLTF_TYPE_VEC4, TINYGLTF_TARGET_ARRAY_BUFFER);
    std::vector<std::uint32_t> corners;
    for (const auto& triangle : mesh.triangles) {
      corners.insert(corners.end(), triangle.begin(), triangle.end());
    }
    primitive.indices = buffer_.add(std::span<const std::uint32_t>(corners), 1, TINYGLTF_TYPE_SCALAR,
                                    TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER, false);
    tinygltf::Mesh entry;
    entry.name = name;
    entry.primitives.push_back(std::move(primitive));
    model_.meshes.push_back(std::move(entry));
    return static_cast<int>(model_.meshes.size()) - 1;
  }

  template <typename T>
  void channel(const motion::Track<T>& track, double fps, int node, const char* path, int type) {
    if (track.empty()) {
      return;
    }
    tinygltf::AnimationSampler sampler;
    if (const char* way = gltf_plain(track); way != nullptr) {
      sampler.input = times(track.times);
      sampler.output = buffer_.add_keys(track.values);
      sampler.interpolation = way;
    } else {
      GltfCurve curve = gltf_curve(track, fps);
      curves_.push_back(std::move(curve.times));
      sampler.input = times(curves_.back());
      sampler.output = buffer_.add_floats(curve.values, type);
      sampler.interpolation = curve.interpolation;
    }
    animation_.samplers.push_back(std::move(sampler));
    tinygltf::AnimationChannel entry;
    entry.sampler = static_cast<int>(animation_.samplers.size()) - 1;
    entry.target_node = node;
    entry.target_path = path;
    animation_.channels.push_back(std::move(entry));
  }

  // Most tracks have the same key times as the one before: once is enough. `seconds` must stay.
  int times(const std::vector<double>& seconds) {
    if (times_ == nullptr || *times_ != seconds) {
      times_ = &seconds;
      times_accessor_ = buffer_.add_floats(gltf_times(seconds), TINYGLTF_TYPE_SCALAR, 0, true);
    }
    return times_accessor_;
  }

  tinygltf::Model model_;
  GltfBuffer buffer_;
  UniqueNames unique_;
  tinygltf::Animation animation_;
  int first_ = 0;                          // node of the present clip's root
  int above_ = -1;                         // what it hangs on; -1: nothing
  std::list<std::vector<double>> curves_;  // key times of curves that were made
  const std::vector<double>* times_ = nullptr;
  int times_accessor_ = -1;
};

}  // namespace

Status write_gltf(std::span<const motion::Clip* const> clips, const std::filesystem::path& path,
                  const GltfWriteOptions& options, const Progress& progress) {
  if (Status status = check_actors(clips, path.string()); !status) {
    return status;
  }
  SceneWriter writer;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    if (!progress.report(0.0, "writing")) {
      return cancelled();
    }
    if (clips.size() > 1) {
      writer.add_actor(*clips[i]);
    }
    writer.add_bones(*clips[i]);
    writer.add_meshes(*clips[i]);
    writer.add_tracks(*clips[i]);
    if (options.vrm && i == 0) {
      writer.add_vrm(*clips[i]);
    }
  }
  return writer.finish(*clips.front(), path, progress);
}

}  // namespace limbwave::interchange
