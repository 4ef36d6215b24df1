#include "interchange/fbx_import.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "geometry/so3.h"
#include "interchange/fbx_format.h"
#include "interchange/names.h"

namespace limbwave::interchange {
namespace {

using Eigen::Affine3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

// Scales that differ by less count as one: exporters compute them back from matrices.
constexpr double kSameScale = 1e-4;
// What Assimp's 32-bit numbers leave of a thing that does not move.
constexpr double kSameAngle = 2e-6;
constexpr double kSamePlace = 3e-6;  // m

// Our bone frames from the axes of nodes, (x, y, z) = (z, x, y) of the node (file_axes.h).
const Quaterniond& bone_from_node() {
  static const Quaterniond kR = [] {
    Eigen::Matrix3d R;
    R << 0, 0, 1, 1, 0, 0, 0, 1, 0;
    return Quaterniond(R);
  }();
  return kR;
}

Vector3d vector(const aiVector3D& v) {
  return {v.x, v.y, v.z};
}
Quaterniond rotation(const aiQuaternion& q) {
  return Quaterniond(q.w, q.x, q.y, q.z).normalized();
}

Affine3d matrix(const FbxPlacement& placement) {
  return Eigen::Translation3d(placement.translation) * placement.R * Eigen::Scaling(placement.scale);
}

// Animation without effect leaves a track of one and the same value: dropped.
template <typename T, typename Same>
void drop_still(motion::Track<T>& track, const Same& same) {
  if (std::ranges::all_of(track.values, same)) {
    track = {};
  }
}

template <typename T>
void set_holds(motion::Track<T>& track, const std::vector<bool>& holds) {
  if (std::ranges::find(holds, true) != holds.end()) {
    track.key_interpolation.clear();
    for (const bool hold : holds) {
      track.key_interpolation.push_back(hold ? motion::Interpolation::kStep : motion::Interpolation::kLinear);
    }
  }
}

}  // namespace

// One node's keys, as Assimp gives them.
struct FbxImporter::NodeKeys {
  std::vector<double> times_s;
  std::vector<bool> holds;
  std::vector<FbxPlacement> values;
};

struct FbxImporter::Animation {
  std::unordered_map<int, NodeKeys> nodes;  // by model
  double begin_s = 0.0;                     // the part that the file plays; end 0: all
  double end_s = 0.0;
};

body::SegmentPose FbxImporter::pose_of(const Affine3d& M) const {
  const Eigen::Matrix3d R = geometry::nearest_rotation(scene_.R_WF * M.linear());
  return {Quaterniond(R) * bone_from_node().conjugate(), scene_.metres_per_unit * scene_.R_WF * M.translation()};
}

std::vector<FbxActor> fbx_actors(const FbxScene& scene, const FbxPlain& plain) {
  std::vector<FbxActor> actors;
  std::vector<int> actor_of(scene.models.size(), -1);
  // A node between two bones counts as a bone: whether some bone hangs on a node is known from behind.
  std::vector<bool> carries(scene.models.size(), false);
  for (std::size_t i = scene.models.size(); i-- > 0;) {
    const int parent = scene.models[i].parent;
    if (parent >= 0 && (carries[i] || scene.models[i].joint)) {
      carries[static_cast<std::size_t>(parent)] = true;
    }
  }
  for (std::size_t i = 0; i < scene.models.size(); ++i) {
    if (!plain.kept[i]) {
      continue;
    }
    const int parent = scene.models[i].parent;
    const int above = parent < 0 ? -1 : actor_of[static_cast<std::size_t>(parent)];
    if (above >= 0 && (scene.models[i].joint || carries[i])) {
      actor_of[i] = above;
      actors[static_cast<std::size_t>(above)].joints.push_back(static_cast<int>(i));
    } else if (scene.models[i].joint) {
      FbxActor actor;
      actor.joints.push_back(static_cast<int>(i));
      for (int node = parent; node >= 0; node = scene.models[static_cast<std::size_t>(node)].parent) {
        actor.above.push_back(node);
      }
      std::ranges::reverse(actor.above);
      actor_of[i] = static_cast<int>(actors.size());
      actors.push_back(std::move(actor));
    }
  }
  return actors;
}

FbxImporter::FbxImporter(const FbxScene& scene, const FbxPlain& plain, const aiScene& imported)
    : scene_(scene), plain_(plain), imported_(imported), nodes_(scene.models.size(), nullptr), R_WF_(scene.R_WF) {
  std::vector<const aiNode*> open = {imported.mRootNode};
  while (!open.empty()) {
    const aiNode* node = open.back();
    open.pop_back();
    const std::string name = node->mName.C_Str();
    if (name.size() > 1 && name[0] == 'n' &&
        std::all_of(name.begin() + 1, name.end(), [](char c) { return c >= '0' && c <= '9'; })) {
      const std::size_t index = std::stoul(name.substr(1));
      if (index < nodes_.size()) {
        nodes_[index] = node;
      }
    }
    open.insert(open.end(), node->mChildren, node->mChildren + node->mNumChildren);
  }
}

FbxPlacement FbxImporter::rest(int model) const {
  FbxPlacement placement;
  if (const aiNode* node = nodes_[static_cast<std::size_t>(model)]; node != nullptr) {
    aiVector3D scale;
    aiVector3D place;
    aiQuaternion turn;
    node->mTransformation.Decompose(scale, turn, place);
    placement = {vector(place), rotation(turn), vector(scale)};
  }
  return placement;
}

FbxImporter::Animation FbxImporter::animation(int stack) const {
  Animation result;
  if (stack < 0) {
    return result;
  }
  const auto k = static_cast<std::size_t>(stack);
  const std::vector<FbxPlainKeys>& keys = plain_.keys[k];
  std::int64_t zero = scene_.stacks[k].start;
  std::int64_t first = std::numeric_limits<std::int64_t>::max();
  std::int64_t last = std::numeric_limits<std::int64_t>::min();
  for (const FbxPlainKeys& node : keys) {
    if (!node.times.empty()) {
      first = std::min(first, node.times.front());
      last = std::max(last, node.times.back());
    }
  }
  if (first > last) {
    return result;
  }
  zero = std::min(zero, first);
  const auto seconds = [&](std::int64_t tick) { return static_cast<double>(tick - zero) / kFbxTicksPerSecond; };
  const std::int64_t start = scene_.stacks[k].start;
  const std::int64_t stop = scene_.stacks[k].stop;
  if (stop > start && (first < start - 1 || last > stop + 1)) {
    result.begin_s = seconds(start);
    result.end_s = seconds(stop);
  }
  const std::string name = fmt::format("s{}", stack);
  for (unsigned a = 0; a < imported_.mNumAnimations; ++a) {
    const aiAnimation& animation = *imported_.mAnimations[a];
    if (name != animation.mName.C_Str()) {
      continue;
    }
    const double rate = animation.mTicksPerSecond > 0.0 ? animation.mTicksPerSecond : 60.0;
    for (unsigned c = 0; c < animation.mNumChannels; ++c) {
      const aiNodeAnim& channel = *animation.mChannels[c];
      const auto model = std::ranges::find_if(
          nodes_, [&](const aiNode* node) { return node != nullptr && node->mName == channel.mNodeName; });
      const unsigned n = channel.mNumRotationKeys;
      if (model == nodes_.end() || n == 0 || channel.mNumPositionKeys != n || channel.mNumScalingKeys != n) {
        continue;
      }
      const auto index = static_cast<std::size_t>(model - nodes_.begin());
      NodeKeys& node = result.nodes[static_cast<int>(index)];
      const bool exact = n == keys[index].times.size();
      for (unsigned i = 0; i < n; ++i) {
        // Its times are those that were written, counted from the first of all.
        node.times_s.push_back(exact ? seconds(keys[index].times[i])
                                     : channel.mRotationKeys[i].mTime / rate + seconds(first));
        node.holds.push_back(exact && keys[index].holds[i]);
        node.values.push_back({vector(channel.mPositionKeys[i].mValue), rotation(channel.mRotationKeys[i].mValue),
                               vector(channel.mScalingKeys[i].mValue)});
      }
    }
  }
  return result;
}

Affine3d FbxImporter::global_at(const std::vector<int>& chain, const Animation& animation, double time_s) const {
  Affine3d M = Affine3d::Identity();
  for (const int model : chain) {
    FbxPlacement placement = rest(model);
    if (const auto found = animation.nodes.find(model); found != animation.nodes.end()) {
      const NodeKeys& keys = found->second;
      const auto after = std::upper_bound(keys.times_s.begin(), keys.times_s.end(), time_s);
      const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - keys.times_s.begin() - 1, 0));
      placement = keys.values[i];
      if (i + 1 < keys.values.size() && time_s > keys.times_s[i] && !keys.holds[i]) {
        const double u = (time_s - keys.times_s[i]) / (keys.times_s[i + 1] - keys.times_s[i]);
        const FbxPlacement& next = keys.values[i + 1];
        placement.translation += u * (next.translation - placement.translation);
        placement.scale += u * (next.scale - placement.scale);
        placement.R = placement.R.slerp(u, next.R);
      }
    }
    M = M * matrix(placement);
  }
  return M;
}

// Whether no scale changes or differs by direction, and what the root hangs on stands still.
bool FbxImporter::rigid(const FbxActor& actor, const Animation& animation) const {
  const auto still = [&](int model, bool place_too) {
    const FbxPlacement at_rest = rest(model);
    const double scale = at_rest.scale.x();
    const auto same = [&](const Vector3d& s) {
      return (s - Vector3d::Constant(scale)).cwiseAbs().maxCoeff() <= kSameScale * scale;
    };
    const auto found = animation.nodes.find(model);
    return scale > 0.0 && same(at_rest.scale) &&
           (found == animation.nodes.end() || std::ranges::all_of(found->second.values, [&](const FbxPlacement& value) {
              return same(value.scale) &&
                     (!place_too ||
                      (geometry::geodesic_angle(value.R, at_rest.R) < kSameAngle &&
                       (value.translation - at_rest.translation).norm() * scene_.metres_per_unit < kSamePlace));
            }));
  };
  return std::ranges::all_of(actor.above, [&](int model) { return still(model, true); }) &&
         std::ranges::all_of(actor.joints, [&](int model) { return still(model, false); });
}

void FbxImporter::follow(motion::Clip& clip, const FbxActor& actor, const Animation& animation) const {
  const Affine3d above = global_at(actor.above, {}, 0.0);
  const Quaterniond R_above(geometry::nearest_rotation(above.linear()));
  // Metres of a unit in the node's parent, all scales above it taken together.
  std::unordered_map<int, double> unit;
  const double root_unit = std::cbrt(above.linear().determinant()) * scene_.metres_per_unit;
  const Quaterniond& R_LN = bone_from_node();
  for (std::size_t i = 0; i < actor.joints.size(); ++i) {
    const int model = actor.joints[i];
    const int parent = scene_.models[static_cast<std::size_t>(model)].parent;
    const double parent_unit = i == 0 ? root_unit : unit.at(parent);
    unit[model] = parent_unit * rest(model).scale.x();
    const auto found = animation.nodes.find(model);
    if (found == animation.nodes.end()) {
      continue;
    }
    const body::Segment& segment = clip.skeleton.segments[i];
    motion::RotationTrack rotation;
    motion::PositionTrack position;
    rotation.times = found->second.times_s;
    position.times = found->second.times_s;
    for (const FbxPlacement& value : found->second.values) {
      if (i == 0) {
        rotation.values.push_back((R_WF_ * R_above * value.R * R_LN.conjugate()).normalized());
        position.values.push_back(scene_.metres_per_unit * scene_.R_WF * (above * value.translation));
      } else {
        rotation.values.push_back((R_LN * value.R * R_LN.conjugate()).normalized());
        position.values.push_back(parent_unit * (R_LN * value.translation));
      }
    }
    set_holds(rotation, found->second.holds);
    set_holds(position, found->second.holds);
    drop_still(position, [&](const Vector3d& p) { return (p - segment.p_PL).norm() < kSamePlace; });
    if (!position.empty()) {
      drop_still(rotation,
                 [&](const Quaterniond& R) { return geometry::geodesic_angle(R, segment.R_PL_rest) < kSameAngle; });
    }
    clip.joints[i].rotation = std::move(rotation);
    (i == 0 ? clip.root_position : clip.joints[i].position) = std::move(position);
  }
}

void FbxImporter::bake(motion::Clip& clip, const FbxActor& actor, const Animation& animation) const {
  std::vector<int> chain = actor.above;
  chain.insert(chain.end(), actor.joints.begin(), actor.joints.end());
  std::vector<double> times;
  for (const int model : chain) {
    if (const auto found = animation.nodes.find(model); found != animation.nodes.end()) {
      times.insert(times.end(), found->second.times_s.begin(), found->second.times_s.end());
    }
  }
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  const std::size_t n = actor.joints.size();
  std::unordered_map<int, std::size_t> index;
  for (std::size_t i = 0; i < n; ++i) {
    index[actor.joints[i]] = i;
  }
  std::vector<Affine3d> globals(n);
  std::vector<body::SegmentPose> poses(n);
  for (const double time_s : times) {
    const Affine3d above = global_at(actor.above, animation, time_s);
    for (std::size_t i = 0; i < n; ++i) {
      const int model = actor.joints[i];
      const int parent = clip.skeleton.segments[i].parent;
      globals[i] = (i == 0 ? above : globals[static_cast<std::size_t>(parent)]) * global_at({model}, animation, time_s);
      poses[i] = pose_of(globals[i]);
      motion::RotationTrack& rotation = clip.joints[i].rotation;
      motion::PositionTrack& position = i == 0 ? clip.root_position : clip.joints[i].position;
      rotation.times.push_back(time_s);
      position.times.push_back(time_s);
      if (i == 0) {
        rotation.values.push_back(poses[i].R_WL);
        position.values.push_back(poses[i].p_WL);
      } else {
        const body::SegmentPose& pose = poses[static_cast<std::size_t>(parent)];
        rotation.values.push_back((pose.R_WL.conjugate() * poses[i].R_WL).normalized());
        position.values.push_back(pose.R_WL.conjugate() * (poses[i].p_WL - pose.p_WL));
      }
    }
  }
  for (std::size_t i = 1; i < n; ++i) {
    const Vector3d& rest = clip.skeleton.segments[i].p_PL;
    drop_still(clip.joints[i].position, [&](const Vector3d& p) { return (p - rest).norm() < kSamePlace; });
  }
}

motion::Clip FbxImporter::clip(const FbxActor& actor, int stack) const {
  motion::Clip clip;
  clip.frame_rate_hz = scene_.fps;
  clip.name = stack < 0 ? "" : scene_.stacks[static_cast<std::size_t>(stack)].name;
  const auto model = [&](int index) -> const FbxModel& { return scene_.models[static_cast<std::size_t>(index)]; };
  clip.skeleton.name = actor.above.empty() ? model(actor.joints.front()).name : model(actor.above.back()).name;
  UniqueNames unique;
  std::unordered_map<int, int> index;
  std::vector<Affine3d> globals;
  std::vector<body::SegmentPose> poses;
  for (const int joint : actor.joints) {
    body::Segment segment;
    segment.name = unique(model(joint).name.empty() ? "joint" : model(joint).name);
    const auto parent = index.find(model(joint).parent);
    segment.parent = parent == index.end() ? -1 : parent->second;
    const Affine3d above =
        segment.parent < 0 ? global_at(actor.above, {}, 0.0) : globals[static_cast<std::size_t>(segment.parent)];
    globals.push_back(above * matrix(rest(joint)));
    poses.push_back(pose_of(globals.back()));
    if (segment.parent < 0) {
      segment.R_PL_rest = poses.back().R_WL;
      segment.p_PL = poses.back().p_WL;
    } else {
      const body::SegmentPose& pose = poses[static_cast<std::size_t>(segment.parent)];
      segment.R_PL_rest = (pose.R_WL.conjugate() * poses.back().R_WL).normalized();
      segment.p_PL = pose.R_WL.conjugate() * (poses.back().p_WL - pose.p_WL);
    }
    index[joint] = static_cast<int>(clip.skeleton.segments.size());
    clip.skeleton.segments.push_back(segment);
  }
  // As long as it is far to the mean of what hangs on it, unless the file says it.
  std::vector<Vector3d> ends(actor.joints.size(), Vector3d::Zero());
  std::vector<int> children(actor.joints.size(), 0);
  for (const body::Segment& segment : clip.skeleton.segments) {
    if (segment.parent >= 0) {
      ends[static_cast<std::size_t>(segment.parent)] += segment.p_PL;
      ++children[static_cast<std::size_t>(segment.parent)];
    }
  }
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const double stated = model(actor.joints[i]).length_m;
    clip.skeleton.segments[i].length = stated >= 0.0 ? stated : children[i] > 0 ? ends[i].norm() / children[i] : 0.0;
  }
  clip.joints.resize(actor.joints.size());
  const Animation moving = animation(stack);
  if (rigid(actor, moving)) {
    follow(clip, actor, moving);
  } else {
    bake(clip, actor, moving);
  }
  if (moving.end_s > moving.begin_s) {
    clip = motion::trimmed(clip, moving.begin_s, moving.end_s);
  }
  return clip;
}

}  // namespace limbwave::interchange
