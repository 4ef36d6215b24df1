#include "motion/track.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "geometry/so3.h"

namespace limbwave::motion {
namespace {

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

// Velocity at a key without its own: the mean of the slopes on both sides, the nearer one counting more; one slope at
// the ends.
template <typename T>
Vector3d mean_velocity(const Track<T>& track, std::size_t i) {
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

// Velocities at both ends of the piece after key `i`.
template <typename T>
std::pair<Vector3d, Vector3d> end_velocities(const Track<T>& track, std::size_t i) {
  if (track.leaving.empty()) {
    return {mean_velocity(track, i), mean_velocity(track, i + 1)};
  }
  return {track.leaving[i], track.arriving[i + 1]};
}

Vector3d linear(const Vector3d& a, const Vector3d& b, double u) {
  return a + u * (b - a);
}
Quaterniond linear(const Quaterniond& a, const Quaterniond& b, double u) {
  return a.slerp(u, b).normalized();
}

// Velocities times the piece's duration: `va`, `vb`.
Vector3d cubic(const Vector3d& a, const Vector3d& b, const Vector3d& va, const Vector3d& vb, double u) {
  const double u2 = u * u;
  const double u3 = u2 * u;
  return (2.0 * u3 - 3.0 * u2 + 1.0) * a + (u3 - 2.0 * u2 + u) * va + (3.0 * u2 - 2.0 * u3) * b + (u3 - u2) * vb;
}
Quaterniond cubic(const Quaterniond& a, const Quaterniond& b, const Vector3d& va, const Vector3d& vb, double u) {
  // Cumulative Bézier curve with control rotations a, a exp(w1), a exp(w1) exp(w2), b.
  const Vector3d w1 = va / 3.0;
  const Vector3d w3 = vb / 3.0;
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
  const auto [i, u] = locate(track.times, time_s);
  const Interpolation way = u == 0.0 ? Interpolation::kStep : track.interpolation_after(i);
  if (way == Interpolation::kStep) {
    return track.values[i];
  }
  if (way == Interpolation::kLinear) {
    return linear(track.values[i], track.values[i + 1], u);
  }
  const double h = track.times[i + 1] - track.times[i];
  const auto [va, vb] = end_velocities(track, i);
  return cubic(track.values[i], track.values[i + 1], va * h, vb * h, u);
}

// Velocity of the curve at a time that is on no key: central differences over two thousandths of the piece.
template <typename T>
Vector3d velocity_at(const Track<T>& track, double time_s) {
  const auto [i, u] = locate(track.times, time_s);
  if (i + 1 >= track.times.size()) {
    return Vector3d::Zero();
  }
  const double h = track.times[i + 1] - track.times[i];
  const double step = 1e-3 * h;
  const double from = std::max(time_s - step, track.times[i]);
  const double to = std::min(time_s + step, track.times[i + 1]);
  return difference(sample_track(track, from), sample_track(track, to)) / (to - from);
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

// Makes per-key attributes explicit where they are implied, so that keys can be added and tracks joined. A cubic track
// whose velocities follow from its neighbours would otherwise change shape where its neighbours do.
template <typename T>
void make_explicit(Track<T>& track) {
  const std::size_t n = track.times.size();
  if (track.key_interpolation.empty()) {
    track.key_interpolation.assign(n, track.interpolation);
  }
  if (track.leaving.empty()) {
    const bool has_curves = std::ranges::count(track.key_interpolation, Interpolation::kCubic) > 0 && n > 1;
    track.leaving.assign(n, Vector3d::Zero());
    for (std::size_t i = 0; has_curves && i < n; ++i) {
      track.leaving[i] = mean_velocity(track, i);
    }
    track.arriving = track.leaving;
  }
}

// Takes back what make_explicit wrote where it says nothing.
template <typename T>
void simplify(Track<T>& track) {
  const auto is = [&](Interpolation way) {
    return std::ranges::all_of(track.key_interpolation, [&](Interpolation other) { return other == way; });
  };
  if (std::ranges::count(track.key_interpolation, Interpolation::kCubic) == 0) {
    track.leaving.clear();
    track.arriving.clear();
  }
  if (!track.key_interpolation.empty() && is(track.key_interpolation.front())) {
    track.interpolation = track.key_interpolation.front();
    track.key_interpolation.clear();
  }
}

template <typename T>
void push_key(Track<T>& track, double time_s, const T& value, Interpolation way, const Vector3d& arriving,
              const Vector3d& leaving) {
  track.times.push_back(time_s);
  track.values.push_back(value);
  track.key_interpolation.push_back(way);
  track.arriving.push_back(arriving);
  track.leaving.push_back(leaving);
}

template <typename T>
Track<T> trimmed_track(Track<T> track, double begin_s, double end_s) {
  Track<T> result;
  result.interpolation = track.interpolation;
  if (track.empty()) {
    return result;
  }
  make_explicit(track);
  const auto cut = [&](double time_s) {
    const std::size_t i = locate(track.times, time_s).index;
    const bool on_key = track.times[i] == time_s;
    const bool outside = time_s < track.times.front() || time_s > track.times.back();
    const Vector3d velocity = outside ? Vector3d(Vector3d::Zero()) : velocity_at(track, time_s);
    push_key(result, time_s - begin_s, sample_track(track, time_s),
             outside ? Interpolation::kLinear : track.key_interpolation[i], on_key ? track.arriving[i] : velocity,
             on_key ? track.leaving[i] : velocity);
  };
  cut(begin_s);
  for (std::size_t i = 0; i < track.times.size(); ++i) {
    if (track.times[i] > begin_s && track.times[i] < end_s) {
      push_key(result, track.times[i] - begin_s, track.values[i], track.key_interpolation[i], track.arriving[i],
               track.leaving[i]);
    }
  }
  if (end_s <= track.times.back()) {
    cut(end_s);
  }
  simplify(result);
  return result;
}

template <typename T>
void append_track(Track<T>& track, Track<T> tail, double end_s, double shift_s, const T& rest) {
  if (track.empty() && tail.empty()) {
    return;
  }
  if (track.empty()) {
    track.interpolation = Interpolation::kLinear;
    track.times = {0.0};
    track.values = {rest};
  }
  make_explicit(track);
  make_explicit(tail);
  const Vector3d still = Vector3d::Zero();
  track.key_interpolation.back() = Interpolation::kLinear;
  if (track.times.back() < end_s) {
    push_key(track, end_s, T(track.values.back()), Interpolation::kLinear, still, still);
  }
  if (tail.empty() || tail.times.front() > 0.0) {
    push_key(track, shift_s, tail.empty() ? rest : tail.values.front(), Interpolation::kLinear, still, still);
  }
  for (std::size_t i = 0; i < tail.times.size(); ++i) {
    push_key(track, shift_s + tail.times[i], T(tail.values[i]), tail.key_interpolation[i], tail.arriving[i],
             tail.leaving[i]);
  }
  simplify(track);
}

}  // namespace

Quaterniond sample(const RotationTrack& track, double time_s) {
  return sample_track(track, time_s);
}
Vector3d sample(const PositionTrack& track, double time_s) {
  return sample_track(track, time_s);
}

RotationTrack resampled(const RotationTrack& track, std::size_t frames, double fps) {
  return resampled_track(track, frames, fps);
}
PositionTrack resampled(const PositionTrack& track, std::size_t frames, double fps) {
  return resampled_track(track, frames, fps);
}

RotationTrack trimmed(const RotationTrack& track, double begin_s, double end_s) {
  return trimmed_track(track, begin_s, end_s);
}
PositionTrack trimmed(const PositionTrack& track, double begin_s, double end_s) {
  return trimmed_track(track, begin_s, end_s);
}

void append(RotationTrack& track, const RotationTrack& tail, double end_s, double shift_s, const Quaterniond& rest) {
  append_track(track, tail, end_s, shift_s, rest);
}
void append(PositionTrack& track, const PositionTrack& tail, double end_s, double shift_s, const Vector3d& rest) {
  append_track(track, tail, end_s, shift_s, rest);
}

}  // namespace limbwave::motion
