#include <tiny_gltf.h>

#include <cmath>
#include <cstring>
#include <optional>
#include <span>

#include "base/files.h"
#include "base/json_reader.h"
#include "interchange/gltf_clip.h"
#include "interchange/gltf_keys.h"
#include "interchange/gltf_model.h"

namespace limbwave::interchange {
namespace {

// All numbers of an accessor of the wanted type; nothing when there are none or it is not whole.
std::optional<std::vector<float>> floats(const tinygltf::Model& model, int index, int type) {
  std::optional<GltfNumbers> numbers = gltf_numbers(model, index, {type});
  return numbers && !numbers->values.empty() ? std::optional(std::move(numbers->values)) : std::nullopt;
}

std::optional<motion::Interpolation> interpolation(const std::string& name) {
  if (name == "step") {
    return motion::Interpolation::kStep;
  }
  if (name == "linear") {
    return motion::Interpolation::kLinear;
  }
  return name == "cubic" ? std::optional(motion::Interpolation::kCubic) : std::nullopt;
}

class ClipBuilder {
 public:
  ClipBuilder(const tinygltf::Model& model, std::string place) : model_(model), place_(std::move(place)) {}

  Result<motion::Clip> build() {
    if (Status status = header(); !status) {
      return status.error();
    }
    clip_.joints.resize(clip_.skeleton.segments.size());
    if (model_.animations.empty()) {
      return std::move(clip_);
    }
    const tinygltf::Animation& animation = model_.animations.front();
    for (std::size_t i = 0; i < animation.channels.size(); ++i) {
      const tinygltf::AnimationChannel& channel = animation.channels[i];
      if (channel.sampler < 0 || static_cast<std::size_t>(channel.sampler) >= animation.samplers.size() ||
          channel.target_node < 0 || static_cast<std::size_t>(channel.target_node) >= clip_.joints.size()) {
        return broken("an animation channel leads nowhere");
      }
      const tinygltf::AnimationSampler& sampler = animation.samplers[static_cast<std::size_t>(channel.sampler)];
      const bool turns = channel.target_path == "rotation";
      if (!turns && !(channel.target_path == "translation" && channel.target_node == 0)) {
        continue;  // added by another program
      }
      const auto times = floats(model_, sampler.input, TINYGLTF_TYPE_SCALAR);
      const auto values = floats(model_, sampler.output, turns ? TINYGLTF_TYPE_VEC4 : TINYGLTF_TYPE_VEC3);
      if (!times || !values || values->size() != times->size() * (turns ? 4 : 3)) {
        return broken("the keys of an animation channel are not whole or not of the kind that Limbwave writes");
      }
      Status status;
      if (turns) {
        motion::RotationTrack& track = clip_.joints[static_cast<std::size_t>(channel.target_node)].rotation;
        track.values = rotations_from_gltf(*values);
        status = keys(track, *times, *values, i, gltf_rotations, 4, sampler.input);
      } else {
        clip_.root_position.values = positions_from_gltf(*values);
        status = keys(clip_.root_position, *times, *values, i, gltf_positions, 3, sampler.input);
      }
      if (!status) {
        return status.error();
      }
    }
    return std::move(clip_);
  }

 private:
  [[nodiscard]] Error broken(const std::string& message) const {
    return {message, place_, "check that the file was not changed"};
  }

  Status header() {
    const std::string text = model_.scenes.empty() ? "" : model_.scenes.front().extras_json_string;
    const Result<nlohmann::json> extras = parse_json(text.empty() ? "{}" : text, place_);
    if (!extras) {
      return extras.error();
    }
    if (!extras->is_object() || !extras->contains("limbwave")) {
      return Error{"is not a clip that Limbwave wrote", place_, "use one from a take's solves"};
    }
    const std::string where = place_ + ": scenes/0/extras";
    JsonReader::State state{where, {}};
    const JsonReader reader = JsonReader(*extras, "", state).at("limbwave");
    reader.allow({"schema", "name", "frame_rate_hz", "skeleton", "interpolations", "keys_offset"});
    reader.at("schema").integer(1, 1);
    clip_.name = reader.at("name").string();
    clip_.frame_rate_hz = reader.at("frame_rate_hz").number(1e-3, 1e6);
    next_exact_ = static_cast<std::size_t>(reader.at("keys_offset").integer(0, std::int64_t{1} << 32));
    const bool has_keys = reader.has("interpolations");
    for (const JsonReader& item : has_keys ? reader.at("interpolations").items() : std::vector<JsonReader>()) {
      const std::optional<motion::Interpolation> known = interpolation(item.string());
      if (!known) {
        item.fail("is not step, linear or cubic");
      }
      interpolations_.push_back(known.value_or(motion::Interpolation::kLinear));
    }
    const nlohmann::json skeleton_json = reader.at("skeleton").raw();
    if (state.error) {
      return *state.error;
    }
    Result<body::Skeleton> skeleton = body::skeleton_from_json(skeleton_json, where + "/limbwave/skeleton");
    if (!skeleton) {
      return skeleton.error();
    }
    clip_.skeleton = std::move(*skeleton);
    if (clip_.skeleton.segments.size() > model_.nodes.size()) {
      return broken("it has fewer nodes than its skeleton has segments");
    }
    return {};
  }

  // `count` doubles of the exact block, which lies behind everything that glTF refers to.
  bool take_exact(double* out, std::size_t count) {
    const std::span<const unsigned char> bytes =
        model_.buffers.empty() ? std::span<const unsigned char>() : std::span(model_.buffers.front().data);
    if (next_exact_ > bytes.size() || count > (bytes.size() - next_exact_) / sizeof(double)) {
      return false;
    }
    std::memcpy(out, bytes.data() + next_exact_, count * sizeof(double));
    next_exact_ += count * sizeof(double);
    return true;
  }

  // Fills in the times, and replaces times and values by the exact ones if those are what the floats were made from.
  template <typename T>
  Status keys(motion::Track<T>& track, const std::vector<float>& times, const std::vector<float>& values,
              std::size_t channel, std::vector<float> (*to_floats)(const std::vector<T>&), std::size_t width,
              int times_accessor) {
    track.times.assign(times.begin(), times.end());
    track.interpolation = channel < interpolations_.size() ? interpolations_[channel] : motion::Interpolation::kLinear;
    if (times_accessor != times_accessor_) {
      times_accessor_ = times_accessor;
      exact_times_.resize(times.size());
      exact_ = exact_ && take_exact(exact_times_.data(), times.size()) && gltf_times(exact_times_) == times;
    }
    std::vector<T> exact(times.size());
    for (std::size_t i = 0; i < exact.size() && exact_; ++i) {
      double numbers[4] = {};
      exact_ = take_exact(numbers, width);
      if constexpr (std::is_same_v<T, Eigen::Quaterniond>) {
        exact[i] = Eigen::Quaterniond(numbers[3], numbers[0], numbers[1], numbers[2]);
      } else {
        exact[i] = T(numbers[0], numbers[1], numbers[2]);
      }
    }
    exact_ = exact_ && to_floats(exact) == values;
    if (exact_) {
      track.times = exact_times_;
      track.values = std::move(exact);
    }
    for (std::size_t i = 0; i < track.times.size(); ++i) {
      if (!(std::isfinite(track.times[i]) && (i == 0 || track.times[i] > track.times[i - 1]))) {
        return broken("the times of its keys do not increase");
      }
    }
    for (const float value : values) {
      if (!std::isfinite(value)) {
        return broken("a key is not a number");
      }
    }
    return {};
  }

  const tinygltf::Model& model_;
  std::string place_;
  motion::Clip clip_;
  std::vector<motion::Interpolation> interpolations_;
  std::size_t next_exact_ = 0;
  bool exact_ = true;        // until something does not fit: from there on the floats count
  int times_accessor_ = -1;  // of the previous channel, whose exact times serve again
  std::vector<double> exact_times_;
};

}  // namespace

Result<motion::Clip> clip_from_glb(std::string_view bytes, const std::string& place) {
  const Result<tinygltf::Model> model = parse_gltf(bytes, place);
  if (!model) {
    return model.error();
  }
  return ClipBuilder(*model, place).build();
}

Result<motion::Clip> load_glb(const std::filesystem::path& path) {
  const Result<std::string> bytes = read_file(path, std::size_t{1} << 32);
  if (!bytes) {
    return bytes.error();
  }
  return clip_from_glb(*bytes, path.string());
}

}  // namespace limbwave::interchange
