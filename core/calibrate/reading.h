/// The series of one sensor that calibrations work on, and the words every calibration ends in.
#pragma once

#include <Eigen/Core>
#include <span>
#include <string_view>
#include <vector>

#include "decode/slot_alignment.h"

namespace limbwave::calibrate {

/// What one sensor read over time; all vectors have the same length, times increase.
struct SensorSeries {
  std::vector<double> times;           ///< Seconds since the start of the take.
  std::vector<Eigen::Vector3d> volts;  ///< Relative to the reference slot.
  std::vector<unsigned char> usable;   ///< 0 where clipped or out of sync.

  void push(double time_s, const Eigen::Vector3d& reading, bool is_usable) {
    times.push_back(time_s);
    volts.push_back(reading);
    usable.push_back(is_usable ? 1 : 0);
  }
  [[nodiscard]] std::size_t size() const { return times.size(); }
};

/// One sensor's part of decoded frames. `sensor` is an index below decode::kMaxSensors.
SensorSeries sensor_series(std::span<const decode::AccelerationFrame> frames, int sensor);

/// What a technician is told to do with a calibration.
enum class Verdict { kGood, kUsable, kRepeat };

/// "good", "usable" or "repeat".
std::string_view name(Verdict verdict);

}  // namespace limbwave::calibrate
