/// Records a take from a driver box, through everything that its line may do.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "acquire/box_source.h"
#include "base/result.h"
#include "take/take.h"

namespace limbwave::take {

struct DriverBoxProgress {
  double seconds = 0.0;  ///< Recorded, gaps included.
  double disk_left_s = 0.0;
  bool connected = true;
  acquire::BoxCounters counters;
  acquire::BoxStatus status;
};

/// The same box at another rate, as a sound card runs it: slots last as long as before.
body::Rig rig_at_rate(body::Rig rig, double rate_hz);

/// Starts the box, writes what comes until `go_on` answers false, and stops it. Lost samples are zeros, with one event
/// "dropped" for every gap that says how many; other events are those of acquire/box_source.h. The rig must have as
/// many wires and the same rate as the box. Sample 0 of the take is the box's sample 0, with which the rig's first
/// source fires. `ranging` is the take's calibration: at least the speed of sound.
Result<Take> record_driver_box(const std::filesystem::path& folder, acquire::BoxSource& box, const body::Rig& rig,
                               const body::Skeleton& skeleton, const std::string& subject,
                               const calibrate::RangingCalibration& ranging,
                               const std::function<bool(const DriverBoxProgress&)>& go_on);

}  // namespace limbwave::take
