#include <fmt/format.h>
#include <tiny_gltf.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/files.h"
#include "interchange/file_axes.h"
#include "interchange/gltf_clip.h"
#include "interchange/gltf_keys.h"
#include "interchange/names.h"

namespace limbwave::interchange {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF is little-endian");

tinygltf::Value to_value(const nlohmann::json& json) {
  if (json.is_object()) {
    tinygltf::Value::Object object;
    for (const auto& [key, child] : json.items()) {
      object.emplace(key, to_value(child));
    }
    return tinygltf::Value(std::move(object));
  }
  if (json.is_array()) {
    tinygltf::Value::Array array;
    for (const nlohmann::json& child : json) {
      array.push_back(to_value(child));
    }
    return tinygltf::Value(std::move(array));
  }
  if (json.is_boolean()) {
    return tinygltf::Value(json.get<bool>());
  }
  if (json.is_number_integer() && json.get<std::int64_t>() == json.get<std::int32_t>()) {
    return tinygltf::Value(json.get<int>());
  }
  if (json.is_number()) {
    return tinygltf::Value(json.get<double>());
  }
  return json.is_string() ? tinygltf::Value(json.get<std::string>()) : tinygltf::Value();
}

const char* interpolation_name(motion::Interpolation interpolation) {
  switch (interpolation) {
    case motion::Interpolation::kStep:
      return "step";
    case motion::Interpolation::kCubic:
      return "cubic";
    default:
      return "linear";
  }
}

template <typename T>
Status check(const motion::Track<T>& track, const std::string& name, const std::string& clip) {
  double previous = -1.0;
  if (track.times.size() != track.values.size()) {
    return Error{fmt::format("\"{}\" has {} times and {} values", name, track.times.size(), track.values.size()), clip,
                 "solve the take again"};
  }
  for (const double time : track.times) {
    if (!(time >= 0.0 && time > previous && time < 1e9)) {
      return Error{fmt::format("the key times of \"{}\" do not increase from 0", name), clip, "solve the take again"};
    }
    previous = time;
  }
  for (std::size_t i = 0; i < track.values.size(); ++i) {
    bool finite = false;
    if constexpr (std::is_same_v<T, Eigen::Quaterniond>) {
      finite = track.values[i].coeffs().allFinite() && track.values[i].norm() > 0.5;
    } else {
      finite = track.values[i].allFinite();
    }
    if (!finite) {
      return Error{fmt::format("the pose of \"{}\" at {:.3f} s is not a number", name, track.times[i]), clip,
                   "solve the take again"};
    }
  }
  return {};
}

// What would be lost silently.
Status check_fits(const motion::Clip& clip) {
  const auto no_place = [&](const std::string& what) {
    return Error{"a take's clip has no place for " + what, clip.name, "export it to a file of its own"};
  };
  if (!clip.meshes.empty()) {
    return no_place("meshes");
  }
  const auto is_plain = [](const auto& track) {
    return track.key_interpolation.empty() && track.arriving.empty() && track.leaving.empty();
  };
  bool plain = is_plain(clip.root_position);
  for (std::size_t i = 0; i < clip.joints.size(); ++i) {
    if (!clip.joints[i].position.empty()) {
      return no_place(i < clip.skeleton.segments.size()
                          ? fmt::format("\"{}\", which slides", clip.skeleton.segments[i].name)
                          : "joints without a bone");
    }
    plain = plain && is_plain(clip.joints[i].rotation);
  }
  return plain ? Status() : Status(no_place("velocities and ways of single keys"));
}

class GlbBuilder {
 public:
  explicit GlbBuilder(const motion::Clip& clip) : clip_(clip) {
    model_.asset.version = "2.0";
    model_.asset.generator = "Limbwave";
    model_.buffers.emplace_back();
  }

  Status nodes() {
    tinygltf::Scene scene;
    scene.name = to_utf8(clip_.name);
    scene.nodes = {0};
    model_.scenes.push_back(scene);
    model_.defaultScene = 0;
    const auto& segments = clip_.skeleton.segments;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const body::Segment& segment = segments[i];
      if (!segment.p_PL.allFinite() || !segment.R_PL_rest.coeffs().allFinite() || !std::isfinite(segment.length)) {
        return Error{fmt::format("the rest pose of \"{}\" is not a number", segment.name), clip_.name,
                     "correct the skeleton"};
      }
      tinygltf::Node node;
      node.name = to_utf8(segment.name);
      const Eigen::Vector3d p = to_y_up(segment.p_PL);
      const Eigen::Quaterniond q = to_y_up(segment.R_PL_rest.normalized());
      node.translation = {p.x(), p.y(), p.z()};
      node.rotation = {q.x(), q.y(), q.z(), q.w()};
      node.extras = to_value({{"length_m", segment.length}});
      model_.nodes.push_back(node);
      if (segment.parent >= 0) {
        model_.nodes[static_cast<std::size_t>(segment.parent)].children.push_back(static_cast<int>(i));
      }
    }
    return {};
  }

  Status animation() {
    tinygltf::Animation animation;
    animation.name = to_utf8(clip_.name.empty() ? "clip" : clip_.name);
    for (std::size_t i = 0; i < clip_.joints.size() && i < model_.nodes.size(); ++i) {
      const motion::RotationTrack& track = clip_.joints[i].rotation;
      if (Status status = check(track, clip_.skeleton.segments[i].name, clip_.name); !status) {
        return status;
      }
      if (!track.empty()) {
        channel(animation, track, static_cast<int>(i), "rotation", TINYGLTF_TYPE_VEC4, gltf_rotations(track.values));
      }
    }
    if (Status status = check(clip_.root_position, "root position", clip_.name); !status) {
      return status;
    }
    if (!clip_.root_position.empty()) {
      channel(animation, clip_.root_position, 0, "translation", TINYGLTF_TYPE_VEC3,
              gltf_positions(clip_.root_position.values));
    }
    if (!animation.channels.empty()) {
      model_.animations.push_back(std::move(animation));
    }
    return {};
  }

  // The same keys as doubles, channel after channel: times, unless they are the previous channel's, then values.
  void exact() {
    std::vector<unsigned char>& bytes = model_.buffers[0].data;
    bytes.resize((bytes.size() + 7) / 8 * 8);
    const std::size_t start = bytes.size();
    const std::vector<double>* times = nullptr;
    const auto put = [&](const auto& track, const auto& numbers_of, std::size_t count) {
      if (!track.empty() && (times == nullptr || *times != track.times)) {
        times = &track.times;
        append(track.times.data(), track.times.size());
      }
      for (const auto& value : track.values) {
        append(numbers_of(value), count);
      }
    };
    for (std::size_t i = 0; i < clip_.joints.size() && i < model_.nodes.size(); ++i) {
      put(
          clip_.joints[i].rotation, [](const Eigen::Quaterniond& R) { return R.coeffs().data(); }, 4);
    }
    put(
        clip_.root_position, [](const Eigen::Vector3d& p) { return p.data(); }, 3);
    extras_["keys_offset"] = static_cast<std::int64_t>(start);
  }

  Result<std::string> finish() {
    body::Skeleton skeleton = clip_.skeleton;
    skeleton.name = to_utf8(skeleton.name);
    for (body::Segment& segment : skeleton.segments) {
      segment.name = to_utf8(segment.name);
    }
    extras_["schema"] = 1;
    extras_["name"] = to_utf8(clip_.name);
    extras_["frame_rate_hz"] = clip_.frame_rate_hz;
    extras_["skeleton"] = body::skeleton_to_json(skeleton);
    if (!interpolations_.empty()) {  // tinygltf writes an empty list as null
      extras_["interpolations"] = interpolations_;
    }
    model_.scenes[0].extras = to_value({{"limbwave", extras_}});
    if (model_.buffers[0].data.empty()) {
      model_.buffers.clear();
    } else if (model_.buffers[0].data.size() > std::numeric_limits<std::uint32_t>::max() - (1U << 24)) {
      return Error{"the clip does not fit into a glTF file (4 GB)", clip_.name, "cut it into shorter ones"};
    }
    std::ostringstream stream;
    tinygltf::TinyGLTF writer;
    if (!writer.WriteGltfSceneToStream(&model_, stream, false, true)) {
      return Error{"the clip cannot be written as glTF", clip_.name, ""};
    }
    return std::move(stream).str();
  }

 private:
  template <typename T>
  std::size_t append(const T* values, std::size_t count) {
    std::vector<unsigned char>& bytes = model_.buffers[0].data;
    const std::size_t start = bytes.size();
    bytes.resize(start + count * sizeof(T));
    std::memcpy(bytes.data() + start, values, count * sizeof(T));
    return start;
  }

  int accessor(const std::vector<float>& values, int type, std::size_t count) {
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = append(values.data(), values.size());
    view.byteLength = values.size() * sizeof(float);
    model_.bufferViews.push_back(view);
    tinygltf::Accessor accessor;
    accessor.bufferView = static_cast<int>(model_.bufferViews.size()) - 1;
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
    accessor.type = type;
    accessor.count = count;
    if (type == TINYGLTF_TYPE_SCALAR) {
      accessor.minValues = {values.front()};
      accessor.maxValues = {values.back()};
    }
    model_.accessors.push_back(accessor);
    return static_cast<int>(model_.accessors.size()) - 1;
  }

  template <typename T>
  void channel(tinygltf::Animation& animation, const motion::Track<T>& track, int node, const char* path, int type,
               const std::vector<float>& values) {
    if (times_ == nullptr || *times_ != track.times) {
      times_ = &track.times;
      times_accessor_ = accessor(gltf_times(track.times), TINYGLTF_TYPE_SCALAR, track.times.size());
    }
    tinygltf::AnimationSampler sampler;
    sampler.input = times_accessor_;
    sampler.output = accessor(values, type, track.times.size());
    sampler.interpolation = track.interpolation == motion::Interpolation::kStep ? "STEP" : "LINEAR";
    animation.samplers.push_back(sampler);
    tinygltf::AnimationChannel entry;
    entry.sampler = static_cast<int>(animation.samplers.size()) - 1;
    entry.target_node = node;
    entry.target_path = path;
    animation.channels.push_back(entry);
    interpolations_.push_back(interpolation_name(track.interpolation));
  }

  const motion::Clip& clip_;
  tinygltf::Model model_;
  nlohmann::json extras_;
  nlohmann::json interpolations_ = nlohmann::json::array();
  const std::vector<double>* times_ = nullptr;
  int times_accessor_ = -1;
};

}  // namespace

Result<std::string> glb_from_clip(const motion::Clip& clip) {
  if (clip.skeleton.segments.empty()) {
    return Error{"the clip has no skeleton", clip.name, "solve the take first"};
  }
  if (const Status status = check_fits(clip); !status) {
    return status.error();
  }
  GlbBuilder builder(clip);
  if (const Status status = builder.nodes(); !status) {
    return status.error();
  }
  if (const Status status = builder.animation(); !status) {
    return status.error();
  }
  builder.exact();
  return builder.finish();
}

Status write_glb(const motion::Clip& clip, const std::filesystem::path& path) {
  const Result<std::string> bytes = glb_from_clip(clip);
  if (!bytes) {
    return bytes.error();
  }
  return write_file(path, *bytes);
}

}  // namespace limbwave::interchange
