#include "solve/take_sound_speed.h"

#include <algorithm>
#include <vector>

#include "solve/driver_box.h"
#include "take/take_reader.h"

namespace limbwave::solve {
namespace {

constexpr double kSeconds = 120.0;
constexpr std::size_t kBlockFrames = 28000;

}  // namespace

Result<calibrate::SoundSpeed> speed_of_sound_from(const take::Take& take, const Progress& progress) {
  const take::TakeInfo& info = take.info;
  if (!info.rig.driver_box || static_cast<std::size_t>(info.format.channels) != info.rig.microphones.size()) {
    return Error{"has no driver box", take.folder.string(), "use a take of a driver box"};
  }
  auto reader = take::TakeReader::open(take);
  if (!reader) {
    return reader.error();
  }
  const calibrate::RangingCalibration calibration = ranging_calibration(info);
  decode::DriverBoxFormat format = driver_box_format(info.rig, info.skeleton, calibration);
  format.rate = info.format.rate;
  decode::DriverBoxParameters parameters;
  parameters.inertial = false;
  decode::DriverBoxDecoder decoder(format, parameters);
  const std::vector<calibrate::RigidPair> pairs = calibrate::rigid_pairs(info.rig, info.skeleton);
  for (int wire = 0; wire < info.format.channels; ++wire) {
    decoder.set_prediction(wire, calibrate::rigid_prediction(pairs, wire));
  }
  calibrate::SoundSpeedEstimator estimator(pairs, info.rig.driver_box->pulse_hz);
  // Silence where samples were lost is heard as nothing.
  const auto wires = static_cast<std::size_t>(info.format.channels);
  const double total = std::min(static_cast<double>(reader->frames()), kSeconds * info.format.rate.hz);
  std::vector<float> block(kBlockFrames * wires);
  for (double done = 0.0; done < total;) {
    if (!progress.report(done / total, "listening")) {
      return cancelled();
    }
    const Result<std::size_t> count = reader->next(block);
    if (!count) {
      return count.error();
    }
    if (*count == 0) {
      break;
    }
    done += static_cast<double>(*count);
    decoder.push(std::span<const float>(block).first(*count * wires));
    for (const decode::RangeReading& reading : decoder.take_ranges()) {
      estimator.add(reading, calibration.speed_of_sound);
    }
  }
  decoder.finish();  // It looks ahead: the last pulses are still in it.
  for (const decode::RangeReading& reading : decoder.take_ranges()) {
    estimator.add(reading, calibration.speed_of_sound);
  }
  return estimator.estimate();
}

}  // namespace limbwave::solve
