#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "base/files.h"
#include "interchange/file_axes.h"
#include "interchange/frame_rate.h"
#include "interchange/gltf_bones.h"
#include "interchange/gltf_embedded.h"
#include "interchange/gltf_file.h"
#include "interchange/gltf_mesh_reader.h"
#include "interchange/gltf_model.h"
#include "interchange/gltf_playback.h"
#include "interchange/names.h"

namespace limbwave::interchange {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using motion::Interpolation;

// Joints whose places differ from rest by less, metres, do not slide: so much single precision leaves.
constexpr double kSamePlace = 1e-6;
constexpr double kLongestClip = 1e6;
// What a playback holds of a file, seconds.
constexpr double kPartLength = 300.0;
constexpr double kDefaultRate = 60.0;
constexpr std::size_t kMostClips = 1000;
// Keys of all clips together, beside one for each byte of the file: channels may share their numbers, and a few bytes
// would ask for very many.
constexpr std::size_t kMostKeys = 10'000'000;

// Keys of one channel in the file's axes.
struct Channel {
  std::vector<double> times;
  Interpolation interpolation = Interpolation::kLinear;
  std::vector<Eigen::Vector4d> values, arriving, leaving;  // positions have w = 0
};

// The part of all animations that is read, seconds: keys in it, and those that surround it.
struct Part {
  double begin = 0.0;
  double end = kLongestClip;
};

class AnimationReader {
 public:
  AnimationReader(const tinygltf::Model& model, const std::string& place, Diagnostics& diagnostics, std::size_t keys,
                  Part part)
      : model_(model), place_(place), diagnostics_(diagnostics), keys_left_(keys), part_(part) {}

  // The keys of one animation that belong to the tree, put into the clip.
  Status read(std::size_t number, const GltfTree& tree, motion::Clip& clip) {
    const tinygltf::Animation& animation = model_.animations[number];
    std::map<int, std::size_t> segment_of;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
      segment_of[tree.nodes[i]] = i;
    }
    std::set<std::pair<int, bool>> moved;
    for (std::size_t c = 0; c < animation.channels.size(); ++c) {
      const tinygltf::AnimationChannel& entry = animation.channels[c];
      const auto segment = segment_of.find(entry.target_node);
      const bool turns = entry.target_path == "rotation";
      if (!turns && entry.target_path != "translation") {
        unread_.push_back(entry.target_path);
        continue;
      }
      if (segment == segment_of.end()) {
        continue;
      }
      where_ = fmt::format("/animations/{}/channels/{}", number, c);
      if (!moved.emplace(entry.target_node, turns).second) {
        return broken(fmt::format("node {} gets its {} from two channels", entry.target_node, entry.target_path));
      }
      const Result<Channel> channel = keys(animation, entry, turns);
      if (!channel) {
        return channel.error();
      }
      turns ? rotation(*channel, tree, segment->second, clip) : position(*channel, tree, segment->second, clip);
    }
    if (!unread_.empty()) {
      std::ranges::sort(unread_);
      diagnostics_.push_back({Severity::kWarning, "gltf.unread-channels",
                              fmt::format("movement of \"{}\" is left out", unread_.front()),
                              "bake it into rotations and translations of bones", place_});
      unread_.clear();
    }
    return {};
  }

 private:
  [[nodiscard]] Error broken(const std::string& what) const {
    return {where_ + ": " + what, place_, "export it again from the program that made it"};
  }

  Result<Channel> keys(const tinygltf::Animation& animation, const tinygltf::AnimationChannel& entry, bool turns) {
    if (entry.sampler < 0 || static_cast<std::size_t>(entry.sampler) >= animation.samplers.size()) {
      return broken("its sampler does not exist");
    }
    const tinygltf::AnimationSampler& sampler = animation.samplers[static_cast<std::size_t>(entry.sampler)];
    const auto times = gltf_numbers(model_, sampler.input, {TINYGLTF_TYPE_SCALAR});
    const bool is_cubic = sampler.interpolation == "CUBICSPLINE";
    const std::size_t per_key = is_cubic ? 3 : 1;
    if (!times || gltf_count(model_, sampler.output) != times->count() * per_key) {
      return broken("its keys are not whole");
    }
    if (times->count() > keys_left_) {
      return broken("it has more keys than can be read");
    }
    keys_left_ -= times->count();
    Channel channel;
    channel.interpolation = is_cubic                          ? Interpolation::kCubic
                            : sampler.interpolation == "STEP" ? Interpolation::kStep
                                                              : Interpolation::kLinear;
    for (std::size_t i = 0; i < times->count(); ++i) {
      const double time = times->values[i];
      if (!(time >= 0.0 && time < kLongestClip && (i == 0 || time > times->values[i - 1]))) {
        return broken(fmt::format("the time of key {} is not later than the one before", i));
      }
    }
    const auto begin = std::ranges::upper_bound(times->values, part_.begin) - times->values.begin();
    const auto end = std::ranges::lower_bound(times->values, part_.end) - times->values.begin();
    const auto first = static_cast<std::size_t>(std::max<std::ptrdiff_t>(begin - 1, 0));
    const std::size_t last = std::min(static_cast<std::size_t>(end) + 1, times->count());
    const std::size_t many = last > first ? last - first : 0;
    const auto values = gltf_numbers(model_, sampler.output, {turns ? TINYGLTF_TYPE_VEC4 : TINYGLTF_TYPE_VEC3},
                                     first * per_key, many * per_key);
    if (!values) {
      return broken("its keys are not whole");
    }
    channel.times.assign(times->values.begin() + static_cast<std::ptrdiff_t>(first),
                         times->values.begin() + static_cast<std::ptrdiff_t>(last));
    for (std::size_t i = 0; i < values->count(); ++i) {
      Eigen::Vector4d value = Eigen::Vector4d::Zero();
      for (std::size_t k = 0; k < values->width; ++k) {
        value[static_cast<int>(k)] = static_cast<double>(values->values[i * values->width + k]);
      }
      const bool is_tangent = is_cubic && i % 3 != 1;
      if (!value.allFinite() || value.cwiseAbs().maxCoeff() > 1e9 || (turns && !is_tangent && value.norm() < 1e-3)) {
        return broken(fmt::format("key {} is not a usable number", first + i / per_key));
      }
      (!is_cubic || i % 3 == 1 ? channel.values : i % 3 == 0 ? channel.arriving : channel.leaving).push_back(value);
    }
    return channel;
  }

  static void rotation(const Channel& channel, const GltfTree& tree, std::size_t segment, motion::Clip& clip) {
    motion::RotationTrack track;
    track.times = channel.times;
    track.interpolation = channel.interpolation;
    for (std::size_t i = 0; i < channel.values.size(); ++i) {
      const Quaterniond q(channel.values[i]);
      const Quaterniond R = q.normalized();
      track.values.push_back(from_y_up(segment == 0 ? Quaterniond(tree.above.R * R) : R).normalized());
      if (channel.interpolation == Interpolation::kCubic) {
        // w = 2 q⁻¹ q', in the joint's own frame.
        const auto velocity = [&](const Eigen::Vector4d& tangent) {
          return from_y_up(Vector3d(2.0 * (q.inverse() * Quaterniond(tangent)).vec()));
        };
        track.arriving.push_back(velocity(channel.arriving[i]));
        track.leaving.push_back(velocity(channel.leaving[i]));
      }
    }
    clip.joints[segment].rotation = std::move(track);
  }

  static void position(const Channel& channel, const GltfTree& tree, std::size_t segment, motion::Clip& clip) {
    const double scale = tree.scales[segment];
    const Quaterniond turn = segment == 0 ? tree.above.R : Quaterniond::Identity();
    const Vector3d shift = segment == 0 ? tree.above.p : Vector3d::Zero();
    motion::PositionTrack track;
    track.times = channel.times;
    track.interpolation = channel.interpolation;
    const Vector3d rest = clip.skeleton.segments[segment].p_PL;
    double movement = 0.0;
    for (std::size_t i = 0; i < channel.values.size(); ++i) {
      track.values.push_back(from_y_up(Vector3d(shift + scale * (turn * channel.values[i].head<3>()))));
      movement = std::max(movement, (track.values.back() - rest).norm());
      if (channel.interpolation == Interpolation::kCubic) {
        track.arriving.push_back(from_y_up(Vector3d(scale * (turn * channel.arriving[i].head<3>()))));
        track.leaving.push_back(from_y_up(Vector3d(scale * (turn * channel.leaving[i].head<3>()))));
      }
    }
    if (segment == 0) {
      clip.root_position = std::move(track);
    } else if (movement > kSamePlace) {
      clip.joints[segment].position = std::move(track);
    }
  }

  const tinygltf::Model& model_;
  const std::string& place_;
  Diagnostics& diagnostics_;
  std::size_t keys_left_;
  Part part_;
  std::string where_;
  std::vector<std::string> unread_;
};

// glTF knows no frames: what the file says beside it, else the rate at which the densest track has its keys.
double frame_rate(const tinygltf::Model& model, const motion::Clip& clip) {
  const tinygltf::Value& extras = model.asset.extras;
  if (extras.IsObject() && extras.Has("frame_rate_hz") && extras.Get("frame_rate_hz").IsNumber()) {
    const double rate = extras.Get("frame_rate_hz").GetNumberAsDouble();
    if (rate > 1e-3 && rate < kHighestFrameRate) {
      return rate;
    }
  }
  const std::vector<double>* densest = &clip.root_position.times;
  for (const motion::JointTracks& joint : clip.joints) {
    densest = joint.rotation.times.size() > densest->size() ? &joint.rotation.times : densest;
  }
  if (densest->size() < 2) {
    return kDefaultRate;
  }
  const double step = (densest->back() - densest->front()) / static_cast<double>(densest->size() - 1);
  return std::clamp(frame_rate_from_text(step, fmt::format("{:.6f}", step)), 1e-3, kHighestFrameRate);
}

void put_on_frames(motion::Clip& clip) {
  const auto put = [&](std::vector<double>& times) {
    for (double& time : times) {
      time = single_time(time, clip.frame_rate_hz);
    }
  };
  put(clip.root_position.times);
  for (motion::JointTracks& joint : clip.joints) {
    put(joint.rotation.times);
    put(joint.position.times);
  }
}

// `size`: of the file, bytes.
Result<std::vector<motion::Clip>> clips_of(const Result<tinygltf::Model>& model, std::size_t size,
                                           const std::string& place, Diagnostics* diagnostics, Part part = {}) {
  Diagnostics unread;
  Diagnostics& findings = diagnostics != nullptr ? *diagnostics : unread;
  if (!model) {
    return model.error();
  }
  const Result<std::vector<GltfTree>> trees = gltf_trees(*model, place, findings);
  if (!trees) {
    return trees.error();
  }
  if (trees->empty()) {
    return Error{"has no skeleton", place, "export it with its armature"};
  }
  if (trees->size() * std::max<std::size_t>(model->animations.size(), 1) > kMostClips) {
    return Error{fmt::format("has {} skeletons and {} animations", trees->size(), model->animations.size()), place,
                 "export only what is to be animated"};
  }
  std::vector<motion::Clip> clips;
  AnimationReader animations(*model, place, findings, kMostKeys + size, part);
  for (const GltfTree& tree : *trees) {
    motion::Clip at_rest;
    at_rest.skeleton = tree.skeleton;
    at_rest.joints.resize(tree.nodes.size());
    Result<GltfMeshes> meshes = gltf_meshes(*model, tree, place, findings);
    if (!meshes) {
      return meshes.error();
    }
    at_rest.meshes = *std::move(meshes);
    for (std::size_t a = 0; a < std::max<std::size_t>(model->animations.size(), 1); ++a) {
      motion::Clip clip = at_rest;
      if (a < model->animations.size()) {
        clip.name = to_utf8(model->animations[a].name);
        if (Status status = animations.read(a, tree, clip); !status) {
          return status.error();
        }
      }
      if (clip.name.empty()) {
        clip.name = std::filesystem::path(place).stem().string();
      }
      clip.skeleton.name = clip.name;
      clip.frame_rate_hz = frame_rate(*model, clip);
      put_on_frames(clip);
      clips.push_back(std::move(clip));
    }
  }
  return clips;
}

struct LoadedGltf {
  Result<tinygltf::Model> model;
  std::size_t size = 0;  // of the file, bytes
};

// The file's bytes are given back: the model holds them once more, and the keys will. `lean`: text files in less
// memory, for those that Limbwave wrote.
LoadedGltf loaded(const std::filesystem::path& path, bool lean) {
  Result<std::string> bytes = read_file(path, std::size_t{1} << 32);
  if (!bytes) {
    return {bytes.error()};
  }
  if (lean) {
    bytes = gltf_as_binary(*std::move(bytes));
  }
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  return {parse_gltf(*bytes, path.string(), folder), bytes->size()};
}

}  // namespace

Result<std::vector<motion::Clip>> read_gltf(std::string_view bytes, const std::string& place,
                                            const std::filesystem::path& folder, Diagnostics* diagnostics) {
  return clips_of(parse_gltf(bytes, place, folder), bytes.size(), place, diagnostics);
}

Result<std::vector<motion::Clip>> load_gltf(const std::filesystem::path& path, Diagnostics* diagnostics) {
  const LoadedGltf file = loaded(path, false);
  return clips_of(file.model, file.size, path.string(), diagnostics);
}

struct GltfPlayback::State {
  LoadedGltf file;
  std::string place;
  Part part;
  std::vector<motion::Clip> clips;
  std::vector<body::SegmentPose> poses;

  Status load(double begin_s) {
    part = {begin_s, begin_s + kPartLength};
    Result<std::vector<motion::Clip>> read = clips_of(file.model, file.size, place, nullptr, part);
    if (!read) {
      return read.error();
    }
    clips = *std::move(read);
    return {};
  }
};

GltfPlayback::GltfPlayback(std::unique_ptr<State> state) : state_(std::move(state)) {}
GltfPlayback::GltfPlayback(GltfPlayback&&) noexcept = default;
GltfPlayback::~GltfPlayback() = default;

Result<GltfPlayback> GltfPlayback::open(const std::filesystem::path& path) {
  auto state = std::make_unique<State>(State{loaded(path, true), path.string(), {}, {}, {}});
  if (Status status = state->load(0.0); !status) {
    return status.error();
  }
  return GltfPlayback(std::move(state));
}

const std::vector<motion::Clip>& GltfPlayback::clips() const {
  return state_->clips;
}

Status GltfPlayback::places(std::size_t clip, double time_s, std::vector<Vector3d>& p_W) {
  State& state = *state_;
  const double time = single_time(time_s, state.clips[clip].frame_rate_hz);
  if (time < state.part.begin || time > state.part.end) {
    if (Status status = state.load(time); !status) {
      return status;
    }
  }
  motion::pose_at(state.clips[clip], time, state.poses);
  p_W.clear();
  for (const body::SegmentPose& pose : state.poses) {
    p_W.push_back(pose.p_WL);
  }
  return {};
}

}  // namespace limbwave::interchange
