/// Keyframed tracks of positions and rotations.
#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace limbwave::motion {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// How a track goes from one key to the next. Step holds the earlier key. Linear goes straight, rotations spherically.
/// Cubic passes every key with a velocity: the track's own where it has them, else the mean of its two neighbours'
/// slopes (Catmull-Rom). Positions are cubic Hermite curves, rotations cumulative Bézier curves (Kim, Kim & Shin 1995).
enum class Interpolation { kStep, kLinear, kCubic };

/// Keys of one quantity, times strictly increasing, seconds since the start of the clip.
template <typename T>
struct Track {
  std::vector<double> times;
  std::vector<T> values;
  /// After every key, unless `key_interpolation` says otherwise.
  Interpolation interpolation = Interpolation::kLinear;
  /// From key i to key i + 1, one per key; empty: all as `interpolation`.
  std::vector<Interpolation> key_interpolation = {};
  /// Velocities of cubic curves when they come to a key and when they leave it, one per key, both or neither empty.
  /// Positions: metres per second. Rotations: rotation vector per second in the key's own frame.
  std::vector<Vector3d> arriving = {};
  std::vector<Vector3d> leaving = {};

  [[nodiscard]] bool empty() const { return times.empty(); }
  [[nodiscard]] Interpolation interpolation_after(std::size_t key) const {
    return key_interpolation.empty() ? interpolation : key_interpolation[key];
  }
};

using RotationTrack = Track<Quaterniond>;
using PositionTrack = Track<Vector3d>;

/// Value of a track at a time, held before the first and after the last key. Rotations: spherical linear along the
/// shorter way. Asserts that the track is not empty.
Quaterniond sample(const RotationTrack& track, double time_s);
Vector3d sample(const PositionTrack& track, double time_s);

/// Linear keys at multiples of 1/fps: `frames` of them from time 0 on. An empty track stays empty.
RotationTrack resampled(const RotationTrack& track, std::size_t frames, double fps);
PositionTrack resampled(const PositionTrack& track, std::size_t frames, double fps);

/// The part from `begin_s` to `end_s`, moved to start at 0. Keys inside stay as they are; the cut ends get a key with
/// the value and, where the track has velocities, the velocity that was there.
RotationTrack trimmed(const RotationTrack& track, double begin_s, double end_s);
PositionTrack trimmed(const PositionTrack& track, double begin_s, double end_s);

/// Appends `tail`, moved by `shift_s`, to the track of a clip that ends at `end_s`. Both hold their outer keys, so that
/// nothing moves outside the time between them. Where only one of them has keys, the other stays at `rest`.
void append(RotationTrack& track, const RotationTrack& tail, double end_s, double shift_s, const Quaterniond& rest);
void append(PositionTrack& track, const PositionTrack& tail, double end_s, double shift_s, const Vector3d& rest);

}  // namespace limbwave::motion
