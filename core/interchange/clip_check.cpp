#include "interchange/clip_check.h"

#include <fmt/format.h>

#include <cmath>

namespace limbwave::interchange {
namespace {

// Later than three years is a mistake in the times.
constexpr double kLatestTime = 1e8;

bool is_pose(const Eigen::Quaterniond& R) {
  const double length2 = R.squaredNorm();  // neither NaN nor infinity lies in between
  return length2 > 0.25 && length2 < 4.0;
}
bool is_pose(const Eigen::Vector3d& p) {
  return p.allFinite();
}

template <typename T>
Status check(const motion::Track<T>& track, const std::string& name, const std::string& clip) {
  const std::size_t n = track.times.size();
  const bool own = track.key_interpolation.empty() || track.key_interpolation.size() == n;
  if (track.values.size() != n || !own || track.arriving.size() != track.leaving.size() ||
      !(track.leaving.empty() || track.leaving.size() == n)) {
    return Error{fmt::format("the keys of \"{}\" are not whole", name), clip, "solve the take again"};
  }
  double previous = -1.0;
  for (std::size_t i = 0; i < n; ++i) {
    const double time = track.times[i];
    if (!(time >= 0.0 && time > previous && time < kLatestTime)) {
      return Error{fmt::format("the key times of \"{}\" do not increase from 0", name), clip, "solve the take again"};
    }
    previous = time;
    const bool moves = track.leaving.empty() || (track.leaving[i].allFinite() && track.arriving[i].allFinite());
    if (!is_pose(track.values[i]) || !moves) {
      return Error{fmt::format("the pose of \"{}\" at {:.3f} s is not a number", name, time), clip,
                   "solve the take again"};
    }
  }
  return {};
}

}  // namespace

Status check_clip(const motion::Clip& clip) {
  const auto& segments = clip.skeleton.segments;
  if (segments.empty()) {
    return Error{"the clip has no skeleton", clip.name, "solve the take first"};
  }
  if (clip.joints.size() > segments.size()) {
    return Error{fmt::format("{} joints move, but the skeleton has {}", clip.joints.size(), segments.size()), clip.name,
                 "solve the take again"};
  }
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const body::Segment& segment = segments[i];
    const bool parent = i == 0 ? segment.parent < 0 : segment.parent >= 0 && segment.parent < static_cast<int>(i);
    if (!parent || !is_pose(segment.p_PL) || !is_pose(segment.R_PL_rest) || !std::isfinite(segment.length)) {
      return Error{fmt::format("the rest pose of \"{}\" is not a pose", segment.name), clip.name,
                   "correct the skeleton"};
    }
  }
  for (std::size_t i = 0; i < clip.joints.size(); ++i) {
    if (Status status = check(clip.joints[i].rotation, segments[i].name, clip.name); !status) {
      return status;
    }
    if (Status status = check(clip.joints[i].position, segments[i].name, clip.name); !status) {
      return status;
    }
  }
  return check(clip.root_position, segments.front().name, clip.name);
}

Status check_actors(std::span<const motion::Clip* const> clips, const std::string& place) {
  if (clips.empty()) {
    return Error{"there is no clip to write", place, "solve a take first, or choose a clip"};
  }
  for (const motion::Clip* clip : clips) {
    if (Status status = check_clip(*clip); !status) {
      return status;
    }
    for (const auto& mesh : clip->meshes) {
      if (Status status = motion::validate(*mesh, clip->skeleton); !status) {
        return status;
      }
    }
  }
  return {};
}

}  // namespace limbwave::interchange
