/// One inertial word of one board, in SI units, before any calibration.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "base/time.h"

namespace limbwave::decode {

/// In the chips' own axes S. Values are full-scale fractions of the rig's ranges, in steps of range / 2048.
struct InertialReading {
  int board = 0;            ///< Wire; index into the rig's gyroscopes and accelerometers.
  std::int64_t number = 0;  ///< Counts the board's frames since lock, lost ones too.
  /// When the board took the reading: the start of the frame that carries it, seconds since the start of the take.
  Seconds time;
  Eigen::Vector3d w_WS_S = Eigen::Vector3d::Zero();  ///< Angular velocity, rad/s.
  Eigen::Vector3d f_S = Eigen::Vector3d::Zero();     ///< Specific force, m/s².
  /// False while a channel's absolute value is not known (before the first refresh, and up to six frames after a lost
  /// one) or for the lost frame itself: the last value is then repeated.
  bool valid = false;
  std::uint8_t valid_channels = 0;  ///< Bit per channel: gyroscope x y z, accelerometer x y z.
  bool saturated = false;           ///< A channel is at the end of its range.
  int bit_errors = 0;               ///< Corrected within this frame.
};

/// Counts since the start of the stream.
struct InertialCounters {
  std::int64_t frames = 0;      ///< Frames that passed since lock, lost ones too.
  std::int64_t lost = 0;        ///< Of these, not correctable, or within a gap.
  std::int64_t bit_errors = 0;  ///< Corrected.
  std::int64_t relocks = 0;     ///< Times that lock was lost.
  /// When the lock was first found, seconds of the stream that were heard until then; negative: never.
  double lock_s = -1.0;
};

}  // namespace limbwave::decode
