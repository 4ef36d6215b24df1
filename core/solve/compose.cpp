#include "solve/compose.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace limbwave::solve {
namespace {

using Eigen::Quaterniond;

Quaterniond about_vertical(double angle) {
  return {std::cos(0.5 * angle), 0.0, 0.0, std::sin(0.5 * angle)};
}

// Joint tracks from world orientations, quaternion signs continuous so that any reader interpolates the short way.
void set_tracks(motion::Clip& clip, const std::vector<double>& times,
                const std::vector<std::vector<Quaterniond>>& R_WL) {
  for (std::size_t s = 0; s < clip.skeleton.segments.size(); ++s) {
    motion::RotationTrack& track = clip.joints[s].rotation;
    const int parent = clip.skeleton.segments[s].parent;
    track.times = times;
    track.values.resize(times.size());
    for (std::size_t i = 0; i < times.size(); ++i) {
      Quaterniond R = R_WL[i][s];
      if (parent >= 0) {
        R = R_WL[i][static_cast<std::size_t>(parent)].conjugate() * R;
      }
      R.normalize();
      if (i > 0 && R.dot(track.values[i - 1]) < 0.0) {
        R.coeffs() = -R.coeffs();
      }
      track.values[i] = R;
    }
  }
}

}  // namespace

double heading_at(const std::vector<HeadingKey>& keys, double time_s) {
  if (keys.empty()) {
    return 0.0;
  }
  const auto after = std::upper_bound(keys.begin(), keys.end(), time_s,
                                      [](double time, const HeadingKey& key) { return time < key.time_s; });
  if (after == keys.begin()) {
    return keys.front().heading;
  }
  if (after == keys.end()) {
    return keys.back().heading;
  }
  const HeadingKey& a = *(after - 1);
  const double fraction = (time_s - a.time_s) / (after->time_s - a.time_s);
  return a.heading + fraction * (after->heading - a.heading);
}

void set_orientations(const body::Skeleton& skeleton, const std::vector<bool>& sensed,
                      std::span<const Quaterniond> inclined, const std::vector<std::vector<HeadingKey>>& headings,
                      double time_s, std::vector<Quaterniond>& R_WL) {
  R_WL.resize(skeleton.segments.size());
  for (std::size_t s = 0; s < R_WL.size(); ++s) {
    const body::Segment& segment = skeleton.segments[s];
    if (sensed[s]) {
      const double heading = s < headings.size() ? heading_at(headings[s], time_s) : 0.0;
      R_WL[s] = about_vertical(heading) * inclined[s];
    } else if (segment.parent >= 0) {
      R_WL[s] = R_WL[static_cast<std::size_t>(segment.parent)] * segment.R_PL_rest;
    } else {
      R_WL[s] = segment.R_PL_rest;
    }
  }
}

motion::Clip compose_clip(const body::Skeleton& skeleton, const std::vector<double>& times,
                          const std::vector<std::vector<Quaterniond>>& inclinations,
                          const std::vector<std::vector<HeadingKey>>& headings, double frame_rate_hz) {
  const std::size_t count = skeleton.segments.size();
  assert(inclinations.size() == count);
  motion::Clip clip;
  clip.skeleton = skeleton;
  clip.frame_rate_hz = frame_rate_hz;
  clip.joints.resize(count);
  std::vector<bool> sensed(count);
  std::transform(inclinations.begin(), inclinations.end(), sensed.begin(),
                 [](const auto& rotations) { return !rotations.empty(); });
  std::vector<std::vector<Quaterniond>> R_WL(times.size());
  std::vector<Quaterniond> inclined(count);
  for (std::size_t i = 0; i < times.size(); ++i) {
    for (std::size_t s = 0; s < count; ++s) {
      if (sensed[s]) {
        inclined[s] = inclinations[s][i];
      }
    }
    set_orientations(skeleton, sensed, inclined, headings, times[i], R_WL[i]);
  }
  set_tracks(clip, times, R_WL);
  return clip;
}

Result<std::vector<Quaterniond>> limb_orientations(std::span<const estimate::Inclination> inclinations,
                                                   const std::string& sensor) {
  const auto broken =
      std::find_if(inclinations.begin(), inclinations.end(), [](const estimate::Inclination& inclination) {
        return !inclination.up_L.allFinite() || !std::isfinite(inclination.trust);
      });
  if (broken != inclinations.end()) {
    return Error{fmt::format("the inclination at {:.2f} s is not a number", broken->time_s), sensor,
                 "solve with another smoothing, and report this with the take"};
  }
  return estimate::orientations(inclinations);
}

std::vector<int> sensor_segments(const body::Rig& rig, const body::Skeleton& skeleton) {
  std::vector<int> segments;
  segments.reserve(rig.accelerometers.size());
  for (const body::Accelerometer& sensor : rig.accelerometers) {
    segments.push_back(skeleton.find(sensor.segment));
  }
  return segments;
}

std::vector<std::vector<Quaterniond>> world_orientations(const motion::Clip& clip) {
  if (clip.joints.empty()) {
    return {};
  }
  const std::size_t frames = clip.joints.front().rotation.times.size();
  std::vector<std::vector<Quaterniond>> R_WL(frames, std::vector<Quaterniond>(clip.joints.size()));
  for (std::size_t i = 0; i < frames; ++i) {
    for (std::size_t s = 0; s < clip.joints.size(); ++s) {
      const int parent = clip.skeleton.segments[s].parent;
      const Quaterniond& R = clip.joints[s].rotation.values[i];
      R_WL[i][s] = parent < 0 ? R : (R_WL[i][static_cast<std::size_t>(parent)] * R).normalized();
    }
  }
  return R_WL;
}

void turn_segments(const body::Skeleton& skeleton, const std::vector<bool>& sensed, std::span<const double> turns,
                   std::vector<Quaterniond>& R_WL) {
  const std::vector<Quaterniond> before = R_WL;
  for (std::size_t s = 0; s < R_WL.size(); ++s) {
    const int parent = skeleton.segments[s].parent;
    if (sensed[s]) {
      R_WL[s] = about_vertical(turns[s]) * before[s];
    } else if (parent >= 0) {
      const auto p = static_cast<std::size_t>(parent);
      R_WL[s] = (R_WL[p] * before[p].conjugate() * before[s]).normalized();
    }
  }
}

void apply_headings(Solve& solve, const std::vector<int>& sensor_segments,
                    const std::vector<std::vector<HeadingKey>>& headings) {
  motion::Clip& clip = solve.clip;
  if (clip.joints.empty()) {
    solve.settings.headings = headings;
    return;
  }
  const std::vector<double> times = clip.joints.front().rotation.times;
  std::vector<std::vector<Quaterniond>> R_WL = world_orientations(clip);
  static const std::vector<HeadingKey> kNone;
  const auto keys = [](const std::vector<std::vector<HeadingKey>>& lists, std::size_t s) -> const auto& {
    return s < lists.size() ? lists[s] : kNone;
  };
  std::vector<bool> sensed(clip.joints.size(), false);
  for (const int segment : sensor_segments) {
    if (segment >= 0 && static_cast<std::size_t>(segment) < sensed.size()) {
      sensed[static_cast<std::size_t>(segment)] = true;
    }
  }
  std::vector<double> turns(clip.joints.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    for (std::size_t s = 0; s < clip.joints.size(); ++s) {
      turns[s] = heading_at(keys(headings, s), times[i]) - heading_at(keys(solve.settings.headings, s), times[i]);
    }
    turn_segments(clip.skeleton, sensed, turns, R_WL[i]);
  }
  set_tracks(clip, times, R_WL);
  solve.settings.headings = headings;
}

}  // namespace limbwave::solve
