/// Calibrations out of stretches of a take: the same procedures as live,
/// without anybody turning or holding anything again.
#pragma once

#include <QString>
#include <span>
#include <vector>

#include "base/progress.h"
#include "calibration/limb_wizard_model.h"
#include "calibration/range_wizard_model.h"

namespace limbwave::ui {

/// A stretch of a take, seconds.
struct Stretch {
  double begin_s = 0.0, end_s = 0.0;
  [[nodiscard]] double seconds() const { return end_s - begin_s; }
  bool operator==(const Stretch&) const = default;
};

struct NamedStretch {
  QString title;     ///< For people: "Sensors are turned", "Right arm: horizontal".
  std::string name;  ///< As the take has it.
  Stretch stretch;
};

/// The named segments of a take, those in `first` (by name, in that order)
/// before the others, which come by time.
std::vector<NamedStretch> named_stretches(const take::TakeInfo& info, const std::vector<std::string>& first);

/// Whether a take has a stretch in which sensors are turned.
bool has_range_segment(const take::Take& take);
/// Indices of the calibration groups whose two poses are both in the take.
std::vector<int> groups_in_take(const take::Take& take);

/// Range verdicts of all sensors from these readings; for a job. Fails only
/// when it is cancelled.
Result<std::vector<RangeOutcome>> range_outcomes(const take::TakeInfo& info,
                                                 std::span<const decode::AccelerationFrame> frames,
                                                 const Progress& progress);
/// Range verdicts of all sensors from the take's own segment. Takes as long as
/// decoding the take; for a job.
Result<std::vector<RangeOutcome>> range_from_take(const take::Take& take, const Progress& progress);

/// Mounting verdicts of one group, or why its poses were refused.
struct LimbFromTake {
  int group = 0;
  std::vector<LimbOutcome> outcomes;
  Error refusal;
};
LimbFromTake limb_outcomes(const take::Take& take, int group, std::span<const decode::AccelerationFrame> first,
                           std::span<const decode::AccelerationFrame> second, const calibrate::RigCalibration& range);
/// From the take's own segments.
Result<LimbFromTake> limb_from_take(const take::Take& take, int group, const calibrate::RigCalibration& range,
                                    const Progress& progress);

}  // namespace limbwave::ui
