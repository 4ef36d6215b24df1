#include "interchange/fbx_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "base/atomic_file.h"
#include "base/units.h"
#include "interchange/clip_check.h"
#include "interchange/euler.h"
#include "interchange/fbx_header_writer.h"
#include "interchange/fbx_mesh_writer.h"
#include "interchange/frame_rate.h"
#include "interchange/names.h"

namespace limbwave::interchange {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using motion::Interpolation;

constexpr std::int32_t kAnimationVersion = 4009;
// What other writers put beside the way of interpolation: tangents by themselves, or given and broken.
constexpr std::int32_t kLinearKey = kFbxLinear | 0x6100;
constexpr std::int32_t kConstantKey = kFbxConstant | 0x6100;
constexpr std::int32_t kCubicKey = kFbxCubic | 0x400 | 0x800;
// Default weights of tangents, packed as the SDK packs them.
constexpr std::uint32_t kDefaultWeights = 0x0D050D05;
// The level at which key times, which all curves share, are compressed once; values are compressed fast.
constexpr int kTimesLevel = 6;

std::string clean_name(const std::string& name, const char* otherwise) {
  std::string text = to_utf8(name);
  // Zero and one separate the parts of an object's name; other control characters break readers of lines.
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, '_');
  return text.empty() ? otherwise : text;
}

FbxFrames frames_of(const FbxWriteOptions& options) {
  Eigen::Matrix3d world;
  if (options.up == FbxUpAxis::kY) {
    world << 0, 1, 0, 0, 0, 1, 1, 0, 0;  // (y, z, x), as file_axes.h
  } else {
    world << 0, 1, 0, -1, 0, 0, 0, 0, 1;  // (y, −x, z)
  }
  Eigen::Matrix3d bone;
  bone << 0, 0, 1, 1, 0, 0, 0, 1, 0;  // the node's (x, y, z) are our (y, z, x)
  return {Quaterniond(world), Quaterniond(bone), 1.0 / options.metres_per_unit};
}

// One clip in the file.
struct Actor {
  const motion::Clip* clip = nullptr;
  std::vector<std::string> names;
  std::vector<FbxId> bones;
  FbxId above = kFbxRoot;  ///< What the root bone hangs on.
};

class FbxBuilder {
 public:
  FbxBuilder(AtomicFile& file, std::span<const motion::Clip* const> clips, const FbxWriteOptions& options)
      : out_(file), scene_(out_), frames_(frames_of(options)) {
    header_.fps = exact_frame_rate(options.fps > 0.0 ? options.fps : clips.front()->frame_rate_hz);
    header_.up = options.up;
    header_.metres_per_unit = options.metres_per_unit;
    times_ = {header_.fps, options.fps > 0.0, 0.0, options.keys};
    for (const motion::Clip* clip : clips) {
      Actor actor{clip, {}, {}, kFbxRoot};
      for (const body::Segment& segment : clip->skeleton.segments) {
        actor.names.push_back(unique_(clean_name(segment.name, "joint")));
      }
      actors_.push_back(std::move(actor));
      times_.duration_s = std::max(times_.duration_s, clip->duration());
    }
    count();
  }

  Status write(const Progress& progress) {
    write_fbx_header(out_, scene_, header_);
    out_.begin("Objects");
    for (Actor& actor : actors_) {
      if (actors_.size() > 1) {
        const motion::Clip& clip = *actor.clip;
        place(actor, unique_(clean_name(clip.skeleton.name.empty() ? clip.name : clip.skeleton.name, "actor")));
      }
      bones(actor);
    }
    for (const Actor& actor : actors_) {
      FbxMeshWriter meshes(out_, scene_, frames_, actor.clip->skeleton, actor.bones);
      meshes.bind_pose(*actor.clip);
      for (const auto& mesh : actor.clip->meshes) {
        meshes.mesh(*mesh, unique_(clean_name(mesh->name, "mesh")));
      }
    }
    if (Status status = header_.stack.empty() ? Status() : animation(progress); !status) {
      return status;
    }
    out_.end(true);
    scene_.write_connections();
    write_fbx_takes(out_, header_);
    out_.finish();
    if (!out_.fits()) {
      return Error{"the clip does not fit into an FBX 7.4 file (4 GB)", actors_.front().clip->name,
                   "cut it into shorter ones or write fewer frames a second"};
    }
    return {};
  }

 private:
  // A joint's two tracks, in the clip or empty.
  static const motion::RotationTrack& rotation(const Actor& actor, std::size_t i) {
    static const motion::RotationTrack kNone;
    return i < actor.clip->joints.size() ? actor.clip->joints[i].rotation : kNone;
  }
  static const motion::PositionTrack& position(const Actor& actor, std::size_t i) {
    static const motion::PositionTrack kNone;
    if (i == 0) {
      return actor.clip->root_position;
    }
    return i < actor.clip->joints.size() ? actor.clip->joints[i].position : kNone;
  }

  void count() {
    std::int32_t bones = 0;
    std::int32_t meshes = 0;
    std::int32_t clusters = 0;
    for (const Actor& actor : actors_) {
      bones += static_cast<std::int32_t>(actor.names.size());
      meshes += static_cast<std::int32_t>(actor.clip->meshes.size());
      for (const auto& mesh : actor.clip->meshes) {
        clusters += static_cast<std::int32_t>(fbx_cluster_count(*mesh, actor.names.size()));
      }
      for (std::size_t i = 0; i < actor.names.size(); ++i) {
        moving_ += (rotation(actor, i).empty() ? 0 : 1) + (position(actor, i).empty() ? 0 : 1);
      }
    }
    const std::int32_t stacks = moving_ > 0 ? 1 : 0;
    const auto places = static_cast<std::int32_t>(actors_.size() > 1 ? actors_.size() : 0);
    header_.counts = {{"Model", places + bones + meshes},
                      {"NodeAttribute", places + bones},
                      {"Geometry", meshes},
                      {"Deformer", meshes + clusters},
                      {"Pose", static_cast<std::int32_t>(actors_.size())},
                      {"AnimationStack", stacks},
                      {"AnimationLayer", stacks},
                      {"AnimationCurveNode", moving_},
                      {"AnimationCurve", 3 * moving_}};
    if (stacks > 0) {
      header_.stack = clean_name(actors_.front().clip->name, "clip");
      const std::size_t frames = motion::frame_count(times_.duration_s, times_.fps);
      const double stop = times_.only_frames ? static_cast<double>(frames - 1) / times_.fps : times_.duration_s;
      header_.stop_ticks = std::llround(stop * kFbxTicksPerSecond);
    }
  }

  void vector_property(const char* name, const char* flags, const Vector3d& v) {
    scene_.property(name, name, "", flags, v.x(), v.y(), v.z());
  }

  // Something for the bones of one of several actors to hang on: programs make it the armature of its own.
  void place(Actor& actor, const std::string& name) {
    const FbxId attribute = scene_.begin_object("NodeAttribute", name, "NodeAttribute", "Null");
    out_.leaf("TypeFlags", "Null");
    out_.end();
    actor.above = scene_.begin_object("Model", name, "Model", "Null");
    out_.leaf("Version", 232);
    out_.begin("Properties70");
    scene_.property("InheritType", "enum", "", "", 1);
    scene_.property("DefaultAttributeIndex", "int", "Integer", "", 0);
    out_.end();
    out_.leaf("Shading", true);
    out_.leaf("Culling", "CullingOff");
    out_.end();
    scene_.connect(attribute, actor.above);
    scene_.connect(actor.above, kFbxRoot);
  }

  void bones(Actor& actor) {
    const auto& segments = actor.clip->skeleton.segments;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const bool root = segments[i].parent < 0;
      const FbxId attribute = scene_.begin_object("NodeAttribute", actor.names[i], "NodeAttribute", "LimbNode");
      out_.leaf("TypeFlags", "Skeleton");
      out_.end();
      const FbxId model = scene_.begin_object("Model", actor.names[i], "Model", "LimbNode");
      out_.leaf("Version", 232);
      out_.begin("Properties70");
      const EulerAngles pre = to_euler(frames_.rotation(segments[i].R_PL_rest, root), kZYX);
      scene_.property("RotationOrder", "enum", "", "", 0);
      scene_.property("PreRotation", "Vector3D", "Vector", "", degrees(pre[2]), degrees(pre[1]), degrees(pre[0]));
      // Without it PreRotation does not count.
      scene_.property("RotationActive", "bool", "", "", 1);
      scene_.property("InheritType", "enum", "", "", 1);
      scene_.property("DefaultAttributeIndex", "int", "Integer", "", 0);
      vector_property("Lcl Translation", position(actor, i).empty() ? "A" : "A+",
                      frames_.position(segments[i].p_PL, root));
      vector_property("Lcl Rotation", rotation(actor, i).empty() ? "A" : "A+", Vector3d::Zero());
      vector_property("Lcl Scaling", "A", Vector3d::Ones());
      // FBX has no place for the length of the last bones. Metres.
      scene_.property(kFbxLengthProperty, "double", "Number", "AU", segments[i].length);
      out_.end();
      out_.leaf("Shading", true);
      out_.leaf("Culling", "CullingOff");
      out_.end();
      scene_.connect(attribute, model);
      scene_.connect(model, root ? actor.above : actor.bones[static_cast<std::size_t>(segments[i].parent)]);
      actor.bones.push_back(model);
    }
  }

  Status animation(const Progress& progress) {
    const FbxId stack = scene_.begin_object("AnimationStack", header_.stack, "AnimStack", "");
    out_.begin("Properties70");
    for (const char* name : {"LocalStart", "ReferenceStart"}) {
      scene_.property(name, "KTime", "Time", "", std::int64_t{0});
    }
    for (const char* name : {"LocalStop", "ReferenceStop"}) {
      scene_.property(name, "KTime", "Time", "", header_.stop_ticks);
    }
    out_.end();
    out_.end();
    const FbxId layer = scene_.begin_object("AnimationLayer", "Layer", "AnimLayer", "");
    out_.end(true);
    scene_.connect(layer, stack);

    FbxKeys keys;
    int done = 0;
    for (const Actor& actor : actors_) {
      const auto& segments = actor.clip->skeleton.segments;
      for (std::size_t i = 0; i < segments.size(); ++i) {
        if (!progress.report(static_cast<double>(done) / moving_, "writing") || !out_.fits()) {
          break;
        }
        const bool root = segments[i].parent < 0;
        if (!position(actor, i).empty()) {
          fbx_keys(position(actor, i), root, frames_, times_, keys);
          curves(keys, layer, actor.bones[i], "T", "Lcl Translation", frames_.position(segments[i].p_PL, root));
          ++done;
        }
        if (!rotation(actor, i).empty()) {
          fbx_keys(rotation(actor, i), segments[i].R_PL_rest, root, frames_, times_, keys);
          curves(keys, layer, actor.bones[i], "R", "Lcl Rotation", Vector3d::Zero());
          ++done;
        }
      }
    }
    // Left early: cancelled, or found too large by `write`.
    return done == moving_ || !out_.fits() ? Status() : Status(cancelled());
  }

  void curves(const FbxKeys& keys, FbxId layer, FbxId bone, const char* short_name, const char* property,
              const Vector3d& rest) {
    const FbxId node = scene_.begin_object("AnimationCurveNode", short_name, "AnimCurveNode", "");
    constexpr std::array kAxes = {"d|X", "d|Y", "d|Z"};
    out_.begin("Properties70");
    for (std::size_t axis = 0; axis < 3; ++axis) {
      scene_.property(kAxes[axis], "Number", "", "A", rest[static_cast<int>(axis)]);
    }
    out_.end();
    out_.end();
    scene_.connect(node, layer);
    scene_.connect(node, bone, property);
    if (keys.times != packed_for_) {
      packed_for_ = keys.times;
      packed_times_ = fbx_array(std::span<const std::int64_t>(keys.times), kTimesLevel);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const FbxId curve = scene_.begin_object("AnimationCurve", "", "AnimCurve", "");
      out_.leaf("Default", rest[static_cast<int>(axis)]);
      out_.leaf("KeyVer", kAnimationVersion);
      out_.leaf_array("KeyTime", packed_times_);
      out_.leaf_array("KeyValueFloat", fbx_array(std::span<const float>(keys.values[axis])));
      attributes(keys, axis);
      out_.end();
      scene_.connect(curve, node, kAxes[axis]);
    }
  }

  // Flags and slopes of all keys; neighbours with the same count as one.
  void attributes(const FbxKeys& keys, std::size_t axis) {
    std::vector<std::int32_t> flags;
    std::vector<float> data;
    std::vector<std::int32_t> counts;
    const std::size_t n = keys.times.size();
    const auto slope = [](const std::vector<float>& slopes, std::size_t i) {
      return i < slopes.size() ? slopes[i] : 0.0F;
    };
    for (std::size_t i = 0; i < n; ++i) {
      const Interpolation after = keys.after.empty() ? Interpolation::kLinear : keys.after[i];
      const bool cubic = after == Interpolation::kCubic;
      const std::int32_t flag = cubic ? kCubicKey : after == Interpolation::kStep ? kConstantKey : kLinearKey;
      if (!cubic && !flags.empty() && flags.back() == flag) {
        ++counts.back();
        continue;
      }
      flags.push_back(flag);
      counts.push_back(1);
      data.push_back(cubic ? slope(keys.leaving[axis], i) : 0.0F);
      data.push_back(cubic ? slope(keys.arriving[axis], i + 1) : 0.0F);
      data.push_back(std::bit_cast<float>(kDefaultWeights));
      data.push_back(0.0F);
      if (keys.after.empty()) {
        counts.back() = static_cast<std::int32_t>(n);
        break;
      }
    }
    out_.leaf_array("KeyAttrFlags", fbx_array(std::span<const std::int32_t>(flags)));
    out_.leaf_array("KeyAttrDataFloat", fbx_array(std::span<const float>(data)));
    out_.leaf_array("KeyAttrRefCount", fbx_array(std::span<const std::int32_t>(counts)));
  }

  FbxRecordWriter out_;
  FbxSceneWriter scene_;
  FbxHeader header_;
  FbxFrames frames_;
  FbxKeyTimes times_;
  UniqueNames unique_;  ///< Of bones, actors and meshes: Assimp knows nodes by their names alone.
  std::vector<Actor> actors_;
  int moving_ = 0;
  std::vector<std::int64_t> packed_for_;
  FbxArray packed_times_;
};

}  // namespace

Status write_fbx(std::span<const motion::Clip* const> clips, const std::filesystem::path& path,
                 const FbxWriteOptions& options, const Progress& progress) {
  if (Status status = check_actors(clips, path.string()); !status) {
    return status;
  }
  const double fps = options.fps > 0.0 ? options.fps : clips.front()->frame_rate_hz;
  if (!(fps > 0.0 && fps <= kHighestFrameRate) || !(options.fps >= 0.0)) {
    return Error{fmt::format("{} is not a frame rate", fps), clips.front()->name,
                 "give the frames per second, for example 60"};
  }
  for (const motion::Clip* clip : clips) {
    if (clip->duration() * fps > kMostNumbers / 10.0) {
      return Error{fmt::format("{:.0f} s at {} frames per second are too many frames", clip->duration(), fps),
                   clip->name, "write fewer frames per second or a part of it"};
    }
  }
  AtomicFile file(path);
  FbxBuilder builder(file, clips, options);
  if (Status status = builder.write(progress); !status) {
    return status;
  }
  return file.commit();
}

Status write_fbx(const motion::Clip& clip, const std::filesystem::path& path, const FbxWriteOptions& options,
                 const Progress& progress) {
  const motion::Clip* const clips[] = {&clip};
  return write_fbx(clips, path, options, progress);
}

}  // namespace limbwave::interchange
