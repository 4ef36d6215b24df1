/// A simulated take of a driver box beside what is true of its ranges: what tests and tables measure ranging on.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <utility>

#include "base/units.h"
#include "evaluate/driver_box_evaluation.h"
#include "evaluate/range_breakdown.h"
#include "solve/driver_box.h"
#include "take/take.h"

namespace limbwave::testing_support {

struct RangingTake {
  take::Take take;
  evaluate::DriverBoxTruth truth;
  evaluate::Truth poses;

  /// Comparisons and breakdowns refer to this take.
  [[nodiscard]] evaluate::DriverBoxComparison comparison() const {
    const body::DriverBoxSignal& box = take.info.rig.driver_box.value();
    return {truth,
            take.info.format.rate.hz,
            box.pulse_hz,
            solve::ranging_calibration(take.info).speed_of_sound,
            box.gyroscope_range_rad_s,
            box.accelerometer_range_g * kStandardGravity};
  }
  [[nodiscard]] evaluate::RangeBreakdown breakdown() const { return {truth, poses, take.info}; }

  /// Every reading of the take, by pulse and wire.
  [[nodiscard]] Result<solve::DriverBoxReport> decode(
      const decode::DriverBoxParameters& parameters,
      const std::function<void(const decode::RangeReading&)>& use) const {
    return solve::decode_driver_box(
        take, parameters,
        [&](std::span<const decode::RangeReading> ranges, std::span<const decode::InertialReading>) -> Status {
          for (const decode::RangeReading& reading : ranges) {
            use(reading);
          }
          return {};
        },
        {});
  }
};

inline Result<std::unique_ptr<RangingTake>> open_ranging_take(const std::filesystem::path& folder) {
  auto opened = std::make_unique<RangingTake>();
  Result<take::Take> take = take::open_take(folder);
  if (!take) {
    return take.error();
  }
  opened->take = *std::move(take);
  Result<evaluate::DriverBoxTruth> truth = evaluate::load_driver_box_truth(opened->take.folder / "truth.json");
  if (!truth) {
    return truth.error();
  }
  opened->truth = *std::move(truth);
  Result<evaluate::Truth> poses = evaluate::load_truth(opened->take.folder / "truth.json");
  if (!poses) {
    return poses.error();
  }
  opened->poses = *std::move(poses);
  return opened;
}

}  // namespace limbwave::testing_support
