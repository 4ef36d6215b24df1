#include "motion/transforms.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

namespace limbwave::motion {
namespace {

// Shorter bones have no direction.
constexpr double kShortestBone = 1e-6;
// Poses that differ by less are one, metres and radians.
constexpr double kSamePlace = 2e-5;
constexpr double kSameTurn = 1e-5;
// A frame this close to a key, in frames, is the key.
constexpr double kSameFrame = 1e-3;

// What "the skeleton's rest" meant for a mesh, written down before the rest changes.
void bind_where_it_is(Clip& clip) {
  for (std::shared_ptr<const SkinnedMesh>& mesh : clip.meshes) {
    if (mesh->bind_poses.empty()) {
      auto bound = std::make_shared<SkinnedMesh>(*mesh);
      bound->bind_poses = rest_poses(clip.skeleton);
      mesh = std::move(bound);
    }
  }
}

// A track without keys means rest; when the rest changes, a key keeps what it was.
void fill_rotations(Clip& clip) {
  clip.joints.resize(clip.skeleton.segments.size());
  for (std::size_t i = 0; i < clip.joints.size(); ++i) {
    RotationTrack& rotation = clip.joints[i].rotation;
    if (rotation.empty()) {
      rotation = {{0.0}, {clip.skeleton.segments[i].R_PL_rest}};
    }
  }
}

template <typename T>
std::vector<T> with_first(const T& first, const std::vector<T>& rest) {
  std::vector<T> all;
  all.reserve(rest.size() + 1);
  all.push_back(first);
  for (const T& value : rest) {
    all.push_back(value);
  }
  return all;
}

// A key at `time_s` before all others that holds until the next one.
template <typename T>
void hold_first(Track<T>& track, double time_s, const T& value) {
  track.times = with_first(time_s, track.times);
  track.values = with_first(value, track.values);
  track.key_interpolation = with_first(Interpolation::kStep, track.key_interpolation);
  if (!track.leaving.empty()) {
    track.arriving = with_first(Vector3d(0, 0, 0), track.arriving);
    track.leaving = with_first(Vector3d(0, 0, 0), track.leaving);
  }
}

// Moves the track by one frame and puts a key with `value` in front.
template <typename T>
void put_first(double frame_s, Track<T>& track, const T& value) {
  if (track.key_interpolation.empty()) {
    track.key_interpolation.assign(track.times.size(), track.interpolation);
  }
  for (double& t : track.times) {
    t += frame_s;
  }
  if (track.times.front() > frame_s) {
    // What was held before the first key is held again.
    hold_first(track, frame_s, T(track.values.front()));
  }
  hold_first(track, 0.0, value);
}

void turn_vectors(std::vector<Vector3d>& vectors, const Quaterniond& turn) {
  for (Vector3d& v : vectors) {
    v = turn * v;
  }
}

}  // namespace

Clip with_rest(Clip clip, const std::vector<Quaterniond>& R_WL) {
  assert(R_WL.size() == clip.skeleton.segments.size());
  bind_where_it_is(clip);
  fill_rotations(clip);
  for (std::size_t i = 0; i < R_WL.size(); ++i) {
    body::Segment& segment = clip.skeleton.segments[i];
    segment.R_PL_rest =
        segment.parent < 0 ? R_WL[i] : (R_WL[static_cast<std::size_t>(segment.parent)].conjugate() * R_WL[i]);
    segment.R_PL_rest.normalize();
  }
  return clip;
}

Clip with_bone_frames(Clip clip, const std::vector<Quaterniond>& R_LN) {
  assert(R_LN.size() == clip.skeleton.segments.size());
  bind_where_it_is(clip);
  clip.joints.resize(R_LN.size());
  for (std::size_t i = 0; i < R_LN.size(); ++i) {
    body::Segment& segment = clip.skeleton.segments[i];
    const Quaterniond to_parent =
        segment.parent < 0 ? Quaterniond::Identity() : R_LN[static_cast<std::size_t>(segment.parent)].conjugate();
    const Quaterniond to_own = R_LN[i].conjugate();
    segment.R_PL_rest = (to_parent * segment.R_PL_rest * R_LN[i]).normalized();
    segment.p_PL = to_parent * segment.p_PL;
    segment.joint.axis = to_own * segment.joint.axis;
    segment.joint.axis2 = to_own * segment.joint.axis2;
    if (segment.joint.kind == body::JointKind::kSpherical) {
      segment.joint.minimum.setConstant(-std::numbers::pi);
      segment.joint.maximum.setConstant(std::numbers::pi);
    }
    RotationTrack& rotation = clip.joints[i].rotation;
    for (Quaterniond& R : rotation.values) {
      R = (to_parent * R * R_LN[i]).normalized();
    }
    turn_vectors(rotation.arriving, to_own);
    turn_vectors(rotation.leaving, to_own);
    PositionTrack& position = clip.joints[i].position;
    turn_vectors(position.values, to_parent);
    turn_vectors(position.arriving, to_parent);
    turn_vectors(position.leaving, to_parent);
  }
  for (std::shared_ptr<const SkinnedMesh>& mesh : clip.meshes) {
    auto turned = std::make_shared<SkinnedMesh>(*mesh);
    for (std::size_t i = 0; i < R_LN.size(); ++i) {
      turned->bind_poses[i].R_WL = (turned->bind_poses[i].R_WL * R_LN[i]).normalized();
    }
    mesh = std::move(turned);
  }
  return clip;
}

Clip with_rest_height(Clip clip, double height) {
  bind_where_it_is(clip);
  Vector3d& root = clip.skeleton.segments.front().p_PL;
  if (clip.root_position.empty()) {
    clip.root_position = {{0.0}, {root}};
  }
  root.z() += height - lowest_point_at_rest(clip.skeleton);
  return clip;
}

Clip with_root_bone(Clip clip, const std::string& name) {
  std::vector<body::Segment>& segments = clip.skeleton.segments;
  clip.joints.resize(segments.size());
  for (std::shared_ptr<const SkinnedMesh>& mesh : clip.meshes) {
    auto moved = std::make_shared<SkinnedMesh>(*mesh);
    for (auto& indices : moved->segments) {
      for (std::uint16_t& index : indices) {
        ++index;
      }
    }
    if (!moved->bind_poses.empty()) {
      moved->bind_poses.insert(moved->bind_poses.begin(), body::SegmentPose{});
    }
    mesh = std::move(moved);
  }
  for (body::Segment& segment : segments) {
    ++segment.parent;
  }
  body::Segment root;
  root.name = name;
  segments.insert(segments.begin(), root);
  clip.joints.insert(clip.joints.begin(), JointTracks{});
  clip.joints[1].position = std::move(clip.root_position);
  clip.root_position = {};
  return clip;
}

Clip with_root_motion(Clip clip, RootMotion motion) {
  const auto flatten = [](PositionTrack& track, const Vector3d& place) {
    for (Vector3d& p : track.values) {
      p.head<2>() = place.head<2>();
    }
    for (std::vector<Vector3d>* velocities : {&track.arriving, &track.leaving}) {
      for (Vector3d& v : *velocities) {
        v.head<2>().setZero();
      }
    }
  };
  if (motion == RootMotion::kInPlace) {
    // The hips' way may be on the root or, under a root bone, on its child.
    PositionTrack& way =
        clip.root_position.empty() && clip.joints.size() > 1 ? clip.joints[1].position : clip.root_position;
    if (!way.empty()) {
      flatten(way, Vector3d(way.values.front()));
    }
  }
  if (motion == RootMotion::kOnRoot) {
    assert(clip.skeleton.segments.size() > 1 && clip.root_position.empty());
    PositionTrack& hips = clip.joints[1].position;
    if (!hips.empty()) {
      clip.root_position = hips;
      flatten(hips, Vector3d::Zero());
      for (Vector3d& p : clip.root_position.values) {
        p.z() = 0.0;
      }
      for (std::vector<Vector3d>* velocities : {&clip.root_position.arriving, &clip.root_position.leaving}) {
        for (Vector3d& v : *velocities) {
          v.z() = 0.0;
        }
      }
    }
  }
  return clip;
}

Clip with_rest_frame(Clip clip, const Vector3d& root_p_W) {
  fill_rotations(clip);
  const double frame = 1.0 / clip.frame_rate_hz;
  for (std::size_t i = 0; i < clip.joints.size(); ++i) {
    const body::Segment& segment = clip.skeleton.segments[i];
    put_first(frame, clip.joints[i].rotation, segment.R_PL_rest);
    if (!clip.joints[i].position.empty()) {
      put_first(frame, clip.joints[i].position, segment.p_PL);
    }
  }
  if (clip.root_position.empty()) {
    clip.root_position = {{0.0}, {clip.skeleton.segments.front().p_PL}};
  }
  put_first(frame, clip.root_position, root_p_W);
  return clip;
}

Clip with_straight_pieces(Clip clip) {
  const auto straighten = [&](auto& track) {
    auto straight = track;
    straight.times.clear();
    straight.values.clear();
    straight.interpolation = Interpolation::kLinear;
    straight.key_interpolation.clear();
    straight.arriving.clear();
    straight.leaving.clear();
    bool cubic = false;
    for (std::size_t i = 0; i < track.times.size(); ++i) {
      const Interpolation after = track.interpolation_after(i);
      straight.times.push_back(track.times[i]);
      straight.values.push_back(track.values[i]);
      straight.key_interpolation.push_back(after == Interpolation::kStep ? after : Interpolation::kLinear);
      if (after != Interpolation::kCubic || i + 1 == track.times.size()) {
        continue;
      }
      cubic = true;
      double frame = std::floor(track.times[i] * clip.frame_rate_hz + kSameFrame) + 1.0;
      for (const double end = track.times[i + 1] * clip.frame_rate_hz - kSameFrame; frame < end; frame += 1.0) {
        straight.times.push_back(frame / clip.frame_rate_hz);
        straight.values.push_back(sample(track, straight.times.back()));
        straight.key_interpolation.push_back(Interpolation::kLinear);
      }
    }
    if (std::ranges::find(straight.key_interpolation, Interpolation::kStep) == straight.key_interpolation.end()) {
      straight.key_interpolation.clear();
    }
    if (cubic) {
      track = std::move(straight);
    }
  };
  for (JointTracks& joint : clip.joints) {
    straighten(joint.rotation);
    straighten(joint.position);
  }
  straighten(clip.root_position);
  return clip;
}

Clip with_meshes_at_rest(Clip clip) {
  const std::vector<body::SegmentPose> rest = rest_poses(clip.skeleton);
  for (std::shared_ptr<const SkinnedMesh>& mesh : clip.meshes) {
    if (mesh->bind_poses.empty()) {
      continue;
    }
    std::vector<bool> used(rest.size(), false);
    for (std::size_t v = 0; v < mesh->positions.size(); ++v) {
      for (std::size_t k = 0; k < kInfluences; ++k) {
        used[mesh->segments[v][k]] = used[mesh->segments[v][k]] || mesh->weights[v][k] > 0.0F;
      }
    }
    const auto first = static_cast<std::size_t>(std::ranges::find(used, true) - used.begin());
    if (first == used.size()) {
      continue;
    }
    // The way from where it was bound to rest, which must be the same for all bones.
    const auto way = [&](std::size_t i) {
      const Quaterniond R = (rest[i].R_WL * mesh->bind_poses[i].R_WL.conjugate()).normalized();
      return body::SegmentPose{R, rest[i].p_WL - R * mesh->bind_poses[i].p_WL};
    };
    const body::SegmentPose common = way(first);
    bool same = true;
    for (std::size_t i = 0; i < rest.size(); ++i) {
      const body::SegmentPose own = way(i);
      same = same && (!used[i] || (own.R_WL.angularDistance(common.R_WL) < kSameTurn &&
                                   (own.p_WL - common.p_WL).norm() < kSamePlace));
    }
    if (same) {
      auto moved = std::make_shared<SkinnedMesh>(*mesh);
      for (Eigen::Vector3f& p : moved->positions) {
        p = (common.R_WL * p.cast<double>() + common.p_WL).cast<float>();
      }
      for (Eigen::Vector3f& n : moved->normals) {
        n = (common.R_WL * n.cast<double>()).cast<float>();
      }
      moved->bind_poses.clear();
      mesh = std::move(moved);
    }
  }
  return clip;
}

std::vector<Vector3d> bone_directions(const body::Skeleton& skeleton) {
  const std::size_t n = skeleton.segments.size();
  std::vector<Vector3d> sums(n, Vector3d::Zero());
  for (const body::Segment& segment : skeleton.segments) {
    if (segment.parent >= 0) {
      sums[static_cast<std::size_t>(segment.parent)] += segment.p_PL;
    }
  }
  for (Vector3d& sum : sums) {
    sum = sum.norm() > kShortestBone ? Vector3d(sum.normalized()) : Vector3d(Vector3d::UnitX());
  }
  return sums;
}

double lowest_point_at_rest(const body::Skeleton& skeleton) {
  const std::vector<body::SegmentPose> poses = rest_poses(skeleton);
  double lowest = poses.empty() ? 0.0 : poses.front().p_WL.z();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Vector3d end = poses[i].p_WL + poses[i].R_WL * Vector3d(skeleton.segments[i].length, 0, 0);
    lowest = std::min({lowest, poses[i].p_WL.z(), end.z()});
  }
  return lowest;
}

}  // namespace limbwave::motion
