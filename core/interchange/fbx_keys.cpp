#include "interchange/fbx_keys.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "geometry/so3.h"
#include "interchange/euler.h"
#include "interchange/fbx_format.h"
#include "motion/clip.h"

namespace limbwave::interchange {
namespace {

using motion::Interpolation;

// Halvings of the time between two keys near gimbal lock. More would make curves so steep that readers with 32-bit
// times miss the keys themselves.
constexpr int kMostHalvings = 3;
// How far Euler angles may lead away from the shortest way between two keys: 2 mm at the end of a metre.
constexpr double kLargestStray = 2e-3;  // rad
// Angles that change by less than this do not stray: the error is of second order.
constexpr double kSmallChange = 0.05;  // rad
// A frame this close to a key, in frames, is the key.
constexpr double kSameFrame = 1e-3;

std::int64_t ticks(double time_s) {
  return std::llround(time_s * kFbxTicksPerSecond);
}

// Goes through the times at which a track needs keys. `own` is told the index of a key, `between` a time after it.
template <typename T, typename Own, typename Between>
void for_each_time(const motion::Track<T>& track, const FbxKeyTimes& times, const Own& own, const Between& between) {
  if (times.only_frames) {
    const std::size_t frames = motion::frame_count(times.duration_s, times.fps);
    for (std::size_t frame = 0; frame < frames; ++frame) {
      between(static_cast<double>(frame) / times.fps, Interpolation::kLinear);
    }
    return;
  }
  for (std::size_t i = 0; i < track.times.size(); ++i) {
    own(i);
    if (i + 1 == track.times.size() || times.mode == FbxKeyMode::kOwn) {
      continue;
    }
    const Interpolation way = track.interpolation_after(i);
    const bool turns = std::is_same_v<T, Eigen::Quaterniond>;
    const bool still = way != Interpolation::kCubic && track.values[i].isApprox(track.values[i + 1], 1e-12);
    if (still || (way == Interpolation::kLinear && !turns)) {
      continue;
    }
    double frame = std::floor(track.times[i] * times.fps + kSameFrame) + 1.0;
    const double end = track.times[i + 1] * times.fps - kSameFrame;
    if (way == Interpolation::kStep) {
      // A held value needs but the last frame, for programs that take every curve as straight lines.
      frame = std::max(frame, std::ceil(end) - 1.0);
    }
    for (; frame < end; frame += 1.0) {
      between(frame / times.fps, way == Interpolation::kStep ? way : Interpolation::kLinear);
    }
  }
}

class KeyList {
 public:
  explicit KeyList(FbxKeys& keys) : keys_(keys) { keys_.clear(); }

  // False when a key stands at this tick already.
  bool push(double time_s, const Eigen::Vector3d& value, Interpolation after) {
    const std::int64_t tick = ticks(time_s);
    if (!keys_.times.empty() && tick <= keys_.times.back()) {
      return false;
    }
    if (after != Interpolation::kLinear && keys_.after.empty()) {
      keys_.after.assign(keys_.times.size(), Interpolation::kLinear);
    }
    keys_.times.push_back(tick);
    for (int axis = 0; axis < 3; ++axis) {
      keys_.values[static_cast<std::size_t>(axis)].push_back(static_cast<float>(value[axis]));
    }
    if (!keys_.after.empty() || after != Interpolation::kLinear) {
      keys_.after.push_back(after);
    }
    return true;
  }
  void slopes(const Eigen::Vector3d& arriving, const Eigen::Vector3d& leaving) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      keys_.arriving[a].resize(keys_.times.size());
      keys_.leaving[a].resize(keys_.times.size());
      keys_.arriving[a].back() = static_cast<float>(arriving[axis]);
      keys_.leaving[a].back() = static_cast<float>(leaving[axis]);
    }
  }

 private:
  FbxKeys& keys_;
};

// Velocities of a cubic track at a key, also where they follow from its neighbours: slopes of the curve itself, taken
// just beside the key.
template <typename T>
Eigen::Vector3d velocity(const motion::Track<T>& track, std::size_t i, bool leaving) {
  if (!track.leaving.empty()) {
    return leaving ? track.leaving[i] : track.arriving[i];
  }
  const std::size_t other = leaving ? i + 1 : i - 1;
  if (other >= track.times.size() || track.interpolation_after(leaving ? i : other) != Interpolation::kCubic) {
    return Eigen::Vector3d::Zero();
  }
  const double step = 1e-5 * (track.times[other] - track.times[i]);
  // Two steps, so that the error is of third order.
  const auto difference = [&](double dt) -> Eigen::Vector3d {
    const T value = motion::sample(track, track.times[i] + dt);
    if constexpr (std::is_same_v<T, Eigen::Quaterniond>) {
      return geometry::log_so3(track.values[i].conjugate() * value);
    } else {
      return value - track.values[i];
    }
  };
  return (4.0 * difference(step) - difference(2.0 * step)) / (2.0 * step);
}

bool needs_slopes(Interpolation before, Interpolation after, FbxKeyMode mode) {
  return mode == FbxKeyMode::kOwn && (before == Interpolation::kCubic || after == Interpolation::kCubic);
}

class RotationKeys {
 public:
  RotationKeys(const motion::RotationTrack& track, const Eigen::Quaterniond& R_rest, bool root, const FbxFrames& frames,
               const FbxKeyTimes& times, FbxKeys& keys)
      : track_(track),
        pre_inverse_(frames.rotation(R_rest, root).conjugate()),
        root_(root),
        frames_(frames),
        mode_(times.mode),
        list_(keys) {
    keys_ = &keys;
    for_each_time(
        track, times, [this](std::size_t i) { own(i); },
        [this](double time_s, Interpolation after) { between(time_s, after); });
  }

 private:
  [[nodiscard]] Eigen::Quaterniond local(const Eigen::Quaterniond& R_PL) const {
    return pre_inverse_ * frames_.rotation(R_PL, root_);
  }
  [[nodiscard]] Eigen::Quaterniond at(double time_s) const { return local(motion::sample(track_, time_s)); }

  void own(std::size_t i) {
    const Interpolation after = track_.interpolation_after(i);
    const bool sparse = mode_ == FbxKeyMode::kOwn;
    // Dense cubic pieces are straight from frame to frame.
    const Interpolation written = !sparse && after == Interpolation::kCubic ? Interpolation::kLinear : after;
    to(track_.times[i], local(track_.values[i]), written);
    const Interpolation before = i == 0 ? Interpolation::kStep : track_.interpolation_after(i - 1);
    if (needs_slopes(before, after, mode_) && keys_->times.back() == ticks(track_.times[i])) {
      list_.slopes(rates(velocity(track_, i, false)), rates(velocity(track_, i, true)));
    }
  }
  void between(double time_s, Interpolation after) { to(time_s, at(time_s), after); }

  void to(double time_s, const Eigen::Quaterniond& R, Interpolation after) {
    const bool straight = !keys_->times.empty() && last_after_ == Interpolation::kLinear;
    piece(time_s, R, after, straight && mode_ == FbxKeyMode::kDense ? kMostHalvings : 0);
  }

  void piece(double time_s, const Eigen::Quaterniond& R, Interpolation after, int halvings) {
    const EulerAngles angles = to_euler(R, kZYX, last_);
    if (halvings > 0 && strays(angles, time_s)) {
      const double middle = 0.5 * (last_time_ + time_s);
      piece(middle, at(middle), Interpolation::kLinear, halvings - 1);
      piece(time_s, R, after, halvings - 1);
      return;
    }
    const Eigen::Vector3d in_degrees(degrees(angles[2]), degrees(angles[1]), degrees(angles[0]));
    if (list_.push(time_s, in_degrees, after)) {
      last_ = angles;
      last_time_ = time_s;
      last_after_ = after;
    }
  }

  // Whether the middle of the angles is far from the middle of the motion.
  [[nodiscard]] bool strays(const EulerAngles& angles, double time_s) const {
    EulerAngles middle{};
    double change = 0.0;
    for (std::size_t n = 0; n < 3; ++n) {
      middle[n] = 0.5 * (angles[n] + last_[n]);
      change += std::abs(angles[n] - last_[n]);
    }
    return change > kSmallChange &&
           geometry::geodesic_angle(from_euler(middle, kZYX), at(0.5 * (last_time_ + time_s))) > kLargestStray;
  }

  // Rates of the angles about x, y, z in degrees per second from a rotation vector per second in the bone's frame.
  [[nodiscard]] Eigen::Vector3d rates(const Eigen::Vector3d& w_L) const {
    const Eigen::Vector3d w = frames_.R_LN.conjugate() * w_L;
    // R = Rz(a0) Ry(a1) Rx(a2): w = e_x a2' + Rx⁻¹ e_y a1' + Rx⁻¹ Ry⁻¹ e_z a0'.
    const double y = last_[1];
    const double x = last_[2];
    Eigen::Matrix3d J;
    J << 1.0, 0.0, -std::sin(y),                      //
        0.0, std::cos(x), std::sin(x) * std::cos(y),  //
        0.0, -std::sin(x), std::cos(x) * std::cos(y);
    // In gimbal lock there is no such rate; least squares then gives the smallest.
    const Eigen::Vector3d rate = J.completeOrthogonalDecomposition().solve(w);
    return rate * degrees(1.0);
  }

  const motion::RotationTrack& track_;
  Eigen::Quaterniond pre_inverse_;
  bool root_;
  const FbxFrames& frames_;
  FbxKeyMode mode_;
  KeyList list_;
  FbxKeys* keys_ = nullptr;
  EulerAngles last_{0.0, 0.0, 0.0};
  double last_time_ = 0.0;
  Interpolation last_after_ = Interpolation::kLinear;
};

}  // namespace

void FbxKeys::clear() {
  times.clear();
  after.clear();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    values[axis].clear();
    leaving[axis].clear();
    arriving[axis].clear();
  }
}

void fbx_keys(const motion::RotationTrack& track, const Eigen::Quaterniond& R_rest, bool root, const FbxFrames& frames,
              const FbxKeyTimes& times, FbxKeys& keys) {
  const RotationKeys all(track, R_rest, root, frames, times, keys);
}

void fbx_keys(const motion::PositionTrack& track, bool root, const FbxFrames& frames, const FbxKeyTimes& times,
              FbxKeys& keys) {
  KeyList list(keys);
  const auto own = [&](std::size_t i) {
    const Interpolation after = track.interpolation_after(i);
    const bool straight = times.mode == FbxKeyMode::kDense && after == Interpolation::kCubic;
    const bool pushed =
        list.push(track.times[i], frames.position(track.values[i], root), straight ? Interpolation::kLinear : after);
    const Interpolation before = i == 0 ? Interpolation::kStep : track.interpolation_after(i - 1);
    if (pushed && needs_slopes(before, after, times.mode)) {
      list.slopes(frames.position(velocity(track, i, false), root), frames.position(velocity(track, i, true), root));
    }
  };
  const auto between = [&](double time_s, Interpolation after) {
    list.push(time_s, frames.position(motion::sample(track, time_s), root), after);
  };
  for_each_time(track, times, own, between);
}

}  // namespace limbwave::interchange
