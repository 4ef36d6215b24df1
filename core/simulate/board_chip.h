/// The inertial chips of one board of a driver box: from what is so to what its processor reads.
#pragma once

#include "body/rig.h"
#include "simulate/driver_box_actor.h"
#include "simulate/driver_box_errors.h"
#include "simulate/random.h"
#include "simulate/word_line.h"

namespace limbwave::simulate {

/// Bias and its walk, scale, cross axes, g-sensitivity, noise, saturation, 10 bits summed to 12 (signals.md §4).
class BoardChip {
 public:
  BoardChip(const body::DriverBoxSignal& box, const DriverBoxErrors& errors, std::uint64_t seed, int board);

  /// The next reading; one per frame of words.
  WordReading read(const ChipTruth& truth);

 private:
  int quantised(double value, double lsb, double sigma);

  DriverBoxErrors errors_;
  double gyroscope_lsb_, accelerometer_lsb_, frame_s_;
  Random noise_, walk_;
  Vector3d bias_, gyroscope_scale_, g_sensitivity_, offset_;
  Eigen::Matrix3d M_;
};

}  // namespace limbwave::simulate
