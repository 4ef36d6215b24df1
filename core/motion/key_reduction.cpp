#include "motion/key_reduction.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/so3.h"

namespace limbwave::motion {
namespace {

double distance(const Quaterniond& a, const Quaterniond& b) {
  return geometry::geodesic_angle(a, b);
}
double distance(const Vector3d& a, const Vector3d& b) {
  return (a - b).norm();
}
Quaterniond between(const Quaterniond& a, const Quaterniond& b, double u) {
  return a.slerp(u, b);
}
Vector3d between(const Vector3d& a, const Vector3d& b, double u) {
  return a + u * (b - a);
}

struct Count {
  std::size_t before = 0;
  std::size_t after = 0;
  double worst = 0.0;
};

// Marks the keys between `first` and `last` that must stay, so that none of the others is further than `tolerance` from
// the straight way between its kept neighbours.
template <typename T>
void mark(const Track<T>& track, std::size_t first, std::size_t last, double tolerance, std::vector<bool>& keep,
          double& worst) {
  std::vector<std::pair<std::size_t, std::size_t>> spans{{first, last}};
  while (!spans.empty()) {
    const auto [a, b] = spans.back();
    spans.pop_back();
    double largest = 0.0;
    std::size_t at = a;
    for (std::size_t i = a + 1; i < b; ++i) {
      const double u = (track.times[i] - track.times[a]) / (track.times[b] - track.times[a]);
      const double off = distance(between(track.values[a], track.values[b], u), track.values[i]);
      if (off > largest) {
        largest = off;
        at = i;
      }
    }
    if (largest > tolerance) {
      keep[at] = true;
      spans.emplace_back(a, at);
      spans.emplace_back(at, b);
    } else {
      worst = std::max(worst, largest);
    }
  }
}

template <typename T>
Track<T> reduced_track(const Track<T>& track, double tolerance, std::size_t longest, Count& count) {
  const std::size_t n = track.times.size();
  count.before += n;
  const bool is_linear = track.key_interpolation.empty() && track.interpolation == Interpolation::kLinear;
  if (!is_linear || n < 2) {
    count.after += n;
    return track;
  }
  std::vector<bool> keep(n, false);
  for (std::size_t first = 0; first + 1 < n; first += longest) {
    const std::size_t last = std::min(first + longest, n - 1);
    keep[first] = keep[last] = true;
    mark(track, first, last, tolerance, keep, count.worst);
  }
  Track<T> result;
  for (std::size_t i = 0; i < n; ++i) {
    if (keep[i]) {
      result.times.push_back(track.times[i]);
      result.values.push_back(track.values[i]);
    }
  }
  count.after += result.times.size();
  return result;
}

}  // namespace

Result<ReducedClip> reduced(const Clip& clip, const KeyReduction& limits, const Progress& progress) {
  ReducedClip result;
  result.clip = clip;
  const std::size_t longest = std::max<std::size_t>(limits.longest, 2);
  Count rotations;
  Count positions;
  for (std::size_t i = 0; i < clip.joints.size(); ++i) {
    if (!progress.report(static_cast<double>(i) / static_cast<double>(clip.joints.size()), "reducing keys")) {
      return cancelled();
    }
    result.clip.joints[i].rotation = reduced_track(clip.joints[i].rotation, limits.rotation_rad, longest, rotations);
    result.clip.joints[i].position = reduced_track(clip.joints[i].position, limits.position_m, longest, positions);
  }
  result.clip.root_position = reduced_track(clip.root_position, limits.position_m, longest, positions);
  result.keys_before = rotations.before + positions.before;
  result.keys_after = rotations.after + positions.after;
  result.worst_rotation_rad = rotations.worst;
  result.worst_position_m = positions.worst;
  return result;
}

}  // namespace limbwave::motion
