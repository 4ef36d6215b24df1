#include "motion/clip.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "geometry/so3.h"

namespace limbwave::motion {
namespace {

// Times this close are the same key; files round to about this.
constexpr double kSameTime = 1e-6;

// Where a time lies: between keys `index` and `index + 1`, `fraction` of the way; fraction 0 on a key and outside.
struct Place {
  std::size_t index = 0;
  double fraction = 0.0;
};

Place locate(const std::vector<double>& times, double time_s) {
  // Written so that a time that is not a number counts as the first key.
  if (!(time_s > times.front())) {
    return {0, 0.0};
  }
  if (time_s >= times.back()) {
    return {times.size() - 1, 0.0};
  }
  const auto after = std::upper_bound(times.begin(), times.end(), time_s);
  const auto index = static_cast<std::size_t>(after - times.begin()) - 1;
  return {index, (time_s - times[index]) / (times[index + 1] - times[index])};
}

Vector3d difference(const Vector3d& from, const Vector3d& to) {
  return to - from;
}
Vector3d difference(const Quaterniond& from, const Quaterniond& to) {
  return geometry::log_so3(from.conjugate() * to);
}

// Velocity at a key: the mean of the slopes on both sides, the nearer one counting more; one slope at the ends.
// Rotations: rotation vector per second in the key's own frame.
template <typename T>
Vector3d velocity(const Track<T>& track, std::size_t i) {
  const std::size_t last = track.times.size() - 1;
  const auto slope = [&](std::size_t a) {
    return Vector3d(difference(track.values[a], track.values[a + 1]) / (track.times[a + 1] - track.times[a]));
  };
  if (i == 0) {
    return slope(0);
  }
  if (i == last) {
    return slope(last - 1);
  }
  const double before = track.times[i] - track.times[i - 1];
  const double after = track.times[i + 1] - track.times[i];
  return (slope(i - 1) * after + slope(i) * before) / (before + after);
}

Vector3d between(const PositionTrack& track, const Place& place) {
  const Vector3d& a = track.values[place.index];
  const Vector3d& b = track.values[place.index + 1];
  const double u = place.fraction;
  if (track.interpolation == Interpolation::kLinear) {
    return a + u * (b - a);
  }
  const double h = track.times[place.index + 1] - track.times[place.index];
  const Vector3d va = velocity(track, place.index) * h;
  const Vector3d vb = velocity(track, place.index + 1) * h;
  const double u2 = u * u;
  const double u3 = u2 * u;
  return (2.0 * u3 - 3.0 * u2 + 1.0) * a + (u3 - 2.0 * u2 + u) * va + (3.0 * u2 - 2.0 * u3) * b + (u3 - u2) * vb;
}

Quaterniond between(const RotationTrack& track, const Place& place) {
  const Quaterniond& a = track.values[place.index];
  const Quaterniond& b = track.values[place.index + 1];
  const double u = place.fraction;
  if (track.interpolation == Interpolation::kLinear) {
    return a.slerp(u, b).normalized();
  }
  // Cumulative Bézier curve with control rotations a, a exp(w1), a exp(w1) exp(w2), b.
  const double third = (track.times[place.index + 1] - track.times[place.index]) / 3.0;
  const Vector3d w1 = velocity(track, place.index) * third;
  const Vector3d w3 = velocity(track, place.index + 1) * third;
  const Quaterniond start = a * geometry::exp_so3(w1);
  const Quaterniond end = b * geometry::exp_so3(-w3);
  const Vector3d w2 = geometry::log_so3(start.conjugate() * end);
  const double v = 1.0 - u;
  const double b1 = 1.0 - v * v * v;
  const double b2 = 3.0 * u * u - 2.0 * u * u * u;
  const double b3 = u * u * u;
  return (a * geometry::exp_so3(w1 * b1) * geometry::exp_so3(w2 * b2) * geometry::exp_so3(w3 * b3)).normalized();
}

template <typename T>
T sample_track(const Track<T>& track, double time_s) {
  assert(!track.empty() && track.times.size() == track.values.size());
  const Place place = locate(track.times, time_s);
  if (place.fraction == 0.0 || track.interpolation == Interpolation::kStep) {
    return track.values[place.index];
  }
  return between(track, place);
}

template <typename T>
Track<T> resampled_track(const Track<T>& track, std::size_t frames, double fps) {
  Track<T> result;
  if (track.empty()) {
    return result;
  }
  result.times.reserve(frames);
  result.values.reserve(frames);
  for (std::size_t i = 0; i < frames; ++i) {
    result.times.push_back(static_cast<double>(i) / fps);
    result.values.push_back(sample_track(track, result.times.back()));
  }
  return result;
}

template <typename T>
Track<T> trimmed_track(const Track<T>& track, double begin_s, double end_s) {
  Track<T> result;
  result.interpolation = track.interpolation;
  if (track.empty()) {
    return result;
  }
  result.times.push_back(0.0);
  result.values.push_back(sample_track(track, begin_s));
  for (std::size_t i = 0; i < track.times.size(); ++i) {
    if (track.times[i] > begin_s && track.times[i] < end_s) {
      result.times.push_back(track.times[i] - begin_s);
      result.values.push_back(track.values[i]);
    }
  }
  if (end_s <= track.times.back()) {
    result.times.push_back(end_s - begin_s);
    result.values.push_back(sample_track(track, end_s));
  }
  return result;
}

// Appends `tail`, moved by `shift`, to a track of a clip that ends at `end`. Both hold their outer keys, so that
// nothing moves outside the one frame between them. Where only one of them has keys, the other stays at `rest`.
template <typename T>
void append(Track<T>& track, const Track<T>& tail, double end, double shift, const T& rest) {
  if (track.empty() && tail.empty()) {
    return;
  }
  if (track.empty()) {
    track.interpolation = tail.interpolation;
    track.times = {0.0};
    track.values = {rest};
  }
  if (track.times.back() < end) {
    track.times.push_back(end);
    track.values.push_back(T(track.values.back()));
  }
  if (tail.empty() || tail.times.front() > 0.0) {
    track.times.push_back(shift);
    track.values.push_back(tail.empty() ? rest : tail.values.front());
  }
  for (std::size_t i = 0; i < tail.times.size(); ++i) {
    track.times.push_back(shift + tail.times[i]);
    track.values.push_back(tail.values[i]);
  }
}

}  // namespace

double Clip::duration() const {
  double last = root_position.empty() ? 0.0 : root_position.times.back();
  for (const JointTracks& joint : joints) {
    last = joint.rotation.empty() ? last : std::max(last, joint.rotation.times.back());
  }
  return std::max(last, 0.0);
}

Quaterniond sample(const RotationTrack& track, double time_s) {
  return sample_track(track, time_s);
}

Vector3d sample(const PositionTrack& track, double time_s) {
  return sample_track(track, time_s);
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
      poses[i].p_WL = parent.p_WL + parent.R_WL * segment.p_PL;
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
  for (const JointTracks& joint : clip.joints) {
    // Most clips have the same keys in every track: taking those once keeps this linear.
    if (joint.rotation.times != *previous) {
      all.insert(all.end(), joint.rotation.times.begin(), joint.rotation.times.end());
      previous = &joint.rotation.times;
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
  Clip result;
  result.name = clip.name;
  result.skeleton = clip.skeleton;
  result.frame_rate_hz = fps;
  result.joints.reserve(clip.joints.size());
  for (const JointTracks& joint : clip.joints) {
    result.joints.push_back({resampled_track(joint.rotation, frames, fps)});
  }
  result.root_position = resampled_track(clip.root_position, frames, fps);
  return result;
}

Clip trimmed(const Clip& clip, double begin_s, double end_s) {
  assert(0.0 <= begin_s && begin_s < end_s);
  Clip result;
  result.name = clip.name;
  result.skeleton = clip.skeleton;
  result.frame_rate_hz = clip.frame_rate_hz;
  result.joints.reserve(clip.joints.size());
  for (const JointTracks& joint : clip.joints) {
    result.joints.push_back({trimmed_track(joint.rotation, begin_s, end_s)});
  }
  result.root_position = trimmed_track(clip.root_position, begin_s, end_s);
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
  }
  if (!a.empty()) {
    append(result.root_position, second.root_position, end, shift, a.front().p_PL);
  }
  return result;
}

}  // namespace limbwave::motion
