#include "motion/clip.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace limbwave::motion {
namespace {

// Times this close are the same key; files round to about this.
constexpr double kSameTime = 1e-6;

// A clip without its keys.
Clip without_tracks(const Clip& clip) {
  Clip result;
  result.name = clip.name;
  result.skeleton = clip.skeleton;
  result.frame_rate_hz = clip.frame_rate_hz;
  result.meshes = clip.meshes;
  result.joints.reserve(clip.joints.size());
  return result;
}

}  // namespace

double Clip::duration() const {
  double last = root_position.empty() ? 0.0 : root_position.times.back();
  for (const JointTracks& joint : joints) {
    last = joint.rotation.empty() ? last : std::max(last, joint.rotation.times.back());
    last = joint.position.empty() ? last : std::max(last, joint.position.times.back());
  }
  return std::max(last, 0.0);
}

void pose_at(const Clip& clip, double time_s, std::vector<body::SegmentPose>& poses) {
  const std::vector<body::Segment>& segments = clip.skeleton.segments;
  poses.resize(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const body::Segment& segment = segments[i];
    const bool moves = i < clip.joints.size() && !clip.joints[i].rotation.empty();
    const Quaterniond R_PL = moves ? sample(clip.joints[i].rotation, time_s) : segment.R_PL_rest;
    if (segment.parent < 0) {
      poses[i].R_WL = R_PL;
      poses[i].p_WL = clip.root_position.empty() ? segment.p_PL : sample(clip.root_position, time_s);
    } else {
      const body::SegmentPose& parent = poses[static_cast<std::size_t>(segment.parent)];
      poses[i].R_WL = (parent.R_WL * R_PL).normalized();
      const bool slides = i < clip.joints.size() && !clip.joints[i].position.empty();
      const Vector3d p_PL = slides ? sample(clip.joints[i].position, time_s) : segment.p_PL;
      poses[i].p_WL = parent.p_WL + parent.R_WL * p_PL;
    }
  }
}

std::vector<body::SegmentPose> pose_at(const Clip& clip, double time_s) {
  std::vector<body::SegmentPose> poses;
  pose_at(clip, time_s, poses);
  return poses;
}

std::vector<body::SegmentPose> rest_poses(const body::Skeleton& skeleton) {
  std::vector<body::SegmentPose> poses(skeleton.segments.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const body::Segment& segment = skeleton.segments[i];
    if (segment.parent < 0) {
      poses[i] = {segment.R_PL_rest, segment.p_PL};
    } else {
      const body::SegmentPose& parent = poses[static_cast<std::size_t>(segment.parent)];
      poses[i].R_WL = (parent.R_WL * segment.R_PL_rest).normalized();
      poses[i].p_WL = parent.p_WL + parent.R_WL * segment.p_PL;
    }
  }
  return poses;
}

std::vector<double> key_times(const Clip& clip) {
  std::vector<double> all = clip.root_position.times;
  const std::vector<double>* previous = &clip.root_position.times;
  const auto add = [&](const std::vector<double>& times) {
    // Most clips have the same keys in every track: taking those once keeps this linear.
    if (times != *previous) {
      all.insert(all.end(), times.begin(), times.end());
      previous = &times;
    }
  };
  for (const JointTracks& joint : clip.joints) {
    add(joint.rotation.times);
    if (!joint.position.empty()) {
      add(joint.position.times);
    }
  }
  std::sort(all.begin(), all.end());
  const auto same = [](double a, double b) { return b - a < kSameTime; };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  return all;
}

std::size_t frame_count(double duration_s, double fps) {
  assert(fps > 0.0);
  // A last key that rounding has moved a little before its frame still counts.
  return static_cast<std::size_t>(std::floor(std::max(duration_s, 0.0) * fps + 1e-3)) + 1;
}

Clip resampled(const Clip& clip, double fps) {
  const std::size_t frames = frame_count(clip.duration(), fps);
  Clip result = without_tracks(clip);
  result.frame_rate_hz = fps;
  for (const JointTracks& joint : clip.joints) {
    result.joints.push_back({resampled(joint.rotation, frames, fps), resampled(joint.position, frames, fps)});
  }
  result.root_position = resampled(clip.root_position, frames, fps);
  return result;
}

Clip trimmed(const Clip& clip, double begin_s, double end_s) {
  assert(0.0 <= begin_s && begin_s < end_s);
  Clip result = without_tracks(clip);
  for (const JointTracks& joint : clip.joints) {
    result.joints.push_back({trimmed(joint.rotation, begin_s, end_s), trimmed(joint.position, begin_s, end_s)});
  }
  result.root_position = trimmed(clip.root_position, begin_s, end_s);
  return result;
}

Result<Clip> concatenated(const Clip& first, const Clip& second) {
  const auto& a = first.skeleton.segments;
  const auto& b = second.skeleton.segments;
  if (a.size() != b.size()) {
    return Error{fmt::format("the skeletons have {} and {} segments", a.size(), b.size()), second.name,
                 "join clips of the same skeleton"};
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].name != b[i].name || a[i].parent != b[i].parent) {
      return Error{fmt::format("segment {} is \"{}\" in one clip and \"{}\" in the other", i, a[i].name, b[i].name),
                   second.name, "join clips of the same skeleton"};
    }
  }
  Clip result = first;
  const double end = first.duration();
  const double shift = end + 1.0 / first.frame_rate_hz;
  result.joints.resize(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    static const JointTracks kNone;
    const JointTracks& tail = i < second.joints.size() ? second.joints[i] : kNone;
    append(result.joints[i].rotation, tail.rotation, end, shift, a[i].R_PL_rest);
    append(result.joints[i].position, tail.position, end, shift, a[i].p_PL);
  }
  if (!a.empty()) {
    append(result.root_position, second.root_position, end, shift, a.front().p_PL);
  }
  return result;
}

}  // namespace limbwave::motion
