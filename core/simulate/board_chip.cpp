#include "simulate/board_chip.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/units.h"
#include "simulate/part_tolerance.h"

namespace limbwave::simulate {

BoardChip::BoardChip(const body::DriverBoxSignal& box, const DriverBoxErrors& errors, std::uint64_t seed, int board)
    : errors_(errors),
      gyroscope_lsb_(box.gyroscope_range_rad_s / acquire::kReadingLimit),
      accelerometer_lsb_(box.accelerometer_range_g * kStandardGravity / acquire::kReadingLimit),
      frame_s_(1.0 / box.word_rate_hz),
      noise_(seed, "chip noise " + std::to_string(board)),
      walk_(seed, "bias walk " + std::to_string(board)) {
  Random parts(seed, "chip " + std::to_string(board));
  bias_ = drawn_vector(parts, errors.gyroscope_bias);
  gyroscope_scale_ = drawn_vector(parts, errors.gyroscope_scale);
  g_sensitivity_ = drawn_vector(parts, errors.gyroscope_g);
  offset_ = drawn_vector(parts, errors.accelerometer_offset);
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 3; ++column) {
      M_(row, column) = row == column ? 1.0 + drawn(parts, errors.accelerometer_scale)
                                      : drawn(parts, errors.accelerometer_cross_axis);
    }
  }
}

int BoardChip::quantised(double value, double lsb, double sigma) {
  const double limit = acquire::kReadingLimit;
  if (!errors_.accumulates) {
    const double read = value / lsb + (sigma > 0.0 ? sigma / lsb * noise_.normal() : 0.0);
    return static_cast<int>(std::lround(std::clamp(read, -limit, limit - 1.0)));
  }
  int sum = 0;
  for (int i = 0; i < 4; ++i) {
    const double read = 0.25 * value / lsb + 0.5 * sigma / lsb * noise_.normal();  // in steps of 10 bits
    sum += static_cast<int>(std::lround(std::clamp(read, -0.25 * limit, 0.25 * limit - 1.0)));
  }
  return sum;
}

WordReading BoardChip::read(const ChipTruth& truth) {
  for (Eigen::Index axis = 0; axis < 3 && errors_.gyroscope_bias_walk > 0.0; ++axis) {
    bias_[axis] += errors_.gyroscope_bias_walk * std::sqrt(frame_s_) * walk_.normal();
  }
  const Vector3d w = truth.w_S + gyroscope_scale_.cwiseProduct(truth.w_S) + bias_ +
                     g_sensitivity_.cwiseProduct(truth.f_S) / kStandardGravity;
  const Vector3d f = M_ * truth.f_S + offset_;
  WordReading reading{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    reading[axis] = quantised(w[i], gyroscope_lsb_, errors_.gyroscope_noise);
    reading[3 + axis] = quantised(f[i], accelerometer_lsb_, errors_.accelerometer_noise);
  }
  return reading;
}

}  // namespace limbwave::simulate
