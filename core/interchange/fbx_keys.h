/// Tracks as the animation curves of FBX: Euler angles and lengths, interpolated number by number.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "motion/track.h"

namespace limbwave::interchange {

/// Which keys a file gets.
enum class FbxKeyMode {
  /// The clip's own and, where Euler angles or programs that read every curve as straight lines would go another way
  /// between them, every frame. Near gimbal lock also between frames. Right in every program.
  kDense,
  /// The clip's own, with their interpolation: few keys, to be edited. Between the keys of rotations the motion is
  /// only about the same.
  kOwn,
};

/// When to set keys.
struct FbxKeyTimes {
  double fps = 60.0;
  bool only_frames = false;  ///< At the multiples of 1/fps up to `duration_s` instead of the clip's own keys.
  double duration_s = 0.0;
  FbxKeyMode mode = FbxKeyMode::kDense;
};

/// Three curves with the same key times.
struct FbxKeys {
  std::vector<std::int64_t> times;             ///< Ticks, strictly increasing.
  std::array<std::vector<float>, 3> values;    ///< Degrees about x, y, z, or file units along them.
  std::vector<motion::Interpolation> after;    ///< One per key; empty: linear.
  std::array<std::vector<float>, 3> leaving;   ///< Slopes per second of cubic keys; empty without any.
  std::array<std::vector<float>, 3> arriving;  ///< The same, coming to the key.

  void clear();
};

/// From the frames of core/ to those of a file.
struct FbxFrames {
  Eigen::Quaterniond R_FW;  ///< World of the file from ours.
  Eigen::Quaterniond R_LN;  ///< Our bone frames from those of the file's nodes: one for all.
  double units_per_metre = 100.0;

  [[nodiscard]] Eigen::Vector3d position(const Eigen::Vector3d& p, bool root) const {
    return units_per_metre * (root ? R_FW * p : R_LN.conjugate() * p);
  }
  [[nodiscard]] Eigen::Quaterniond rotation(const Eigen::Quaterniond& R, bool root) const {
    return (root ? R_FW * R * R_LN : R_LN.conjugate() * R * R_LN).normalized();
  }
};

/// The curves of a joint's rotation away from `R_rest` (in our frames). Angles are unrolled: each is the nearest to its
/// predecessor of all that give the rotation.
void fbx_keys(const motion::RotationTrack& track, const Eigen::Quaterniond& R_rest, bool root, const FbxFrames& frames,
              const FbxKeyTimes& times, FbxKeys& keys);
/// The curves of a joint's position.
void fbx_keys(const motion::PositionTrack& track, bool root, const FbxFrames& frames, const FbxKeyTimes& times,
              FbxKeys& keys);

}  // namespace limbwave::interchange
