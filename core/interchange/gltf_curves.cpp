#include "interchange/gltf_curves.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "geometry/so3.h"
#include "interchange/file_axes.h"
#include "interchange/gltf_keys.h"

namespace limbwave::interchange {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using Eigen::Vector4d;
using motion::Interpolation;

constexpr double kLargestDeviation = radians(0.01);
constexpr int kMostHalvings = 8;
// Times closer than this are one.
constexpr double kSameTime = 1e-6;

bool is_mixed(const std::vector<Interpolation>& ways) {
  return std::ranges::any_of(ways, [&](Interpolation way) { return way != ways.front(); });
}

// All keys, and the frames between them.
template <typename T>
motion::Track<T> baked(const motion::Track<T>& track, double fps) {
  std::vector<double> times = track.times;
  const auto first = static_cast<std::size_t>(std::ceil(track.times.front() * fps));
  for (std::size_t f = first; static_cast<double>(f) / fps < track.times.back(); ++f) {
    times.push_back(static_cast<double>(f) / fps);
  }
  for (std::size_t i = 0; i + 1 < track.times.size(); ++i) {
    // A step stays one: its old value is held until just before the next key.
    const double before = track.times[i + 1] - 2.0 * kSameTime;
    if (track.interpolation_after(i) == Interpolation::kStep && before > track.times[i] + kSameTime) {
      times.push_back(before);
    }
  }
  std::ranges::sort(times);
  motion::Track<T> result;
  for (const double time : times) {
    if (result.times.empty() || time - result.times.back() > kSameTime) {
      result.times.push_back(time);
      result.values.push_back(motion::sample(track, time));
    }
  }
  return result;
}

// x, y, z, w of a rotation in the file's axes.
Vector4d components(const Quaterniond& R) {
  return to_y_up(R).coeffs();
}

// Derivative of those components when the rotation turns with `w` (own frame).
Vector4d tangent(const Quaterniond& R, const Vector3d& w) {
  const Quaterniond product = R * Quaterniond(0.0, 0.5 * w.x(), 0.5 * w.y(), 0.5 * w.z());
  return components(product);
}

Vector4d hermite(const Vector4d& a, const Vector4d& va, const Vector4d& b, const Vector4d& vb, double u) {
  const double u2 = u * u;
  const double u3 = u2 * u;
  return (2 * u3 - 3 * u2 + 1) * a + (u3 - 2 * u2 + u) * va + (3 * u2 - 2 * u3) * b + (u3 - u2) * vb;
}

struct Key {
  double time = 0.0;
  Quaterniond R;
  Vector3d arriving;
  Vector3d leaving;
};

class RotationCurve {
 public:
  explicit RotationCurve(const motion::RotationTrack& track) : track_(motion::with_velocities(track)) {}

  std::vector<Key> keys() {
    const std::size_t n = track_.times.size();
    const auto velocity = [&](const std::vector<Vector3d>& of, std::size_t i) {
      return of.empty() ? Vector3d(0, 0, 0) : of[i];
    };
    for (std::size_t i = 0; i < n; ++i) {
      const Key key{track_.times[i], track_.values[i], velocity(track_.arriving, i), velocity(track_.leaving, i)};
      if (i > 0) {
        between(keys_.back(), key, 0);
      }
      keys_.push_back(key);
    }
    return std::move(keys_);
  }

 private:
  [[nodiscard]] double deviation(const Key& a, const Key& b) const {
    const double h = b.time - a.time;
    const Vector4d qa = components(a.R);
    Vector4d qb = components(b.R);
    Vector4d vb = tangent(b.R, b.arriving) * h;
    if (qa.dot(qb) < 0.0) {
      qb = -qb;
      vb = -vb;
    }
    double worst = 0.0;
    for (const double u : {0.2, 0.4, 0.6, 0.8}) {
      const Vector4d q = hermite(qa, tangent(a.R, a.leaving) * h, qb, vb, u).normalized();
      const Vector4d ours = components(motion::sample(track_, a.time + u * h));
      worst = std::max(worst, 2.0 * std::acos(std::min(1.0, std::abs(q.dot(ours)))));
    }
    return worst;
  }

  // Adds what is needed between two keys, without them.
  void between(const Key& a, const Key& b, int depth) {
    if (depth == kMostHalvings || deviation(a, b) < kLargestDeviation) {
      return;
    }
    const double time = 0.5 * (a.time + b.time);
    const Vector3d w = motion::velocity(track_, time);
    const Key middle{time, motion::sample(track_, time), w, w};
    between(a, middle, depth + 1);
    keys_.push_back(middle);
    between(middle, b, depth + 1);
  }

  motion::RotationTrack track_;
  std::vector<Key> keys_;
};

void put(std::vector<float>& values, const Vector4d& v) {
  for (int c = 0; c < 4; ++c) {
    values.push_back(static_cast<float>(v[c]));
  }
}
void put(std::vector<float>& values, const Vector3d& v) {
  for (int c = 0; c < 3; ++c) {
    values.push_back(static_cast<float>(v[c]));
  }
}

template <typename T>
const char* plain(const motion::Track<T>& track) {
  if (!track.key_interpolation.empty() && is_mixed(track.key_interpolation)) {
    return nullptr;
  }
  const Interpolation way = track.key_interpolation.empty() ? track.interpolation : track.key_interpolation.front();
  if (way == Interpolation::kCubic && track.times.size() > 1) {
    return nullptr;
  }
  return way == Interpolation::kStep ? "STEP" : "LINEAR";
}

}  // namespace

const char* gltf_plain(const motion::RotationTrack& track) {
  return plain(track);
}
const char* gltf_plain(const motion::PositionTrack& track) {
  return plain(track);
}

GltfCurve gltf_curve(const motion::RotationTrack& track, double fps) {
  if (!track.key_interpolation.empty() && is_mixed(track.key_interpolation)) {
    const motion::RotationTrack dense = baked(track, fps);
    return {dense.times, gltf_rotations(dense.values), "LINEAR"};
  }
  if (const char* way = plain(track); way != nullptr) {
    return {track.times, gltf_rotations(track.values), way};
  }
  GltfCurve curve;
  curve.interpolation = "CUBICSPLINE";
  double sign = 1.0;
  Vector4d previous = Vector4d::Zero();
  for (const Key& key : RotationCurve(track).keys()) {
    const Vector4d q = components(key.R.normalized());
    // Signs must be continuous, or components would pass through zero.
    sign = q.dot(previous) < 0.0 ? -sign : sign;
    previous = q;
    curve.times.push_back(key.time);
    put(curve.values, Vector4d(sign * tangent(key.R, key.arriving)));
    put(curve.values, Vector4d(sign * q));
    put(curve.values, Vector4d(sign * tangent(key.R, key.leaving)));
  }
  return curve;
}

GltfCurve gltf_curve(const motion::PositionTrack& track, double fps) {
  if (!track.key_interpolation.empty() && is_mixed(track.key_interpolation)) {
    const motion::PositionTrack dense = baked(track, fps);
    return {dense.times, gltf_positions(dense.values), "LINEAR"};
  }
  if (const char* way = plain(track); way != nullptr) {
    return {track.times, gltf_positions(track.values), way};
  }
  const motion::PositionTrack curves = motion::with_velocities(track);
  GltfCurve curve{curves.times, {}, "CUBICSPLINE"};
  for (std::size_t i = 0; i < curves.times.size(); ++i) {
    put(curve.values, to_y_up(curves.arriving[i]));
    put(curve.values, to_y_up(curves.values[i]));
    put(curve.values, to_y_up(curves.leaving[i]));
  }
  return curve;
}

}  // namespace limbwave::interchange
