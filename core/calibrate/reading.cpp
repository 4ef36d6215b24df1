#include "calibrate/reading.h"

namespace limbwave::calibrate {

SensorSeries sensor_series(std::span<const decode::AccelerationFrame> frames, int sensor) {
  SensorSeries series;
  series.times.reserve(frames.size());
  series.volts.reserve(frames.size());
  series.usable.reserve(frames.size());
  const auto index = static_cast<std::size_t>(sensor);
  for (const decode::AccelerationFrame& frame : frames) {
    series.push(frame.time_s, frame.volts.at(index), (frame.usable >> index & 1U) != 0);
  }
  return series;
}

std::string_view name(Verdict verdict) {
  switch (verdict) {
    case Verdict::kGood:
      return "good";
    case Verdict::kUsable:
      return "usable";
    case Verdict::kRepeat:
      return "repeat";
  }
  return "unknown";
}

}  // namespace limbwave::calibrate
