/// Calibrations out of a take's own segments: the same procedures, without anybody turning or holding anything again.
#pragma once

#include <vector>

#include "base/progress.h"
#include "calibration/limb_wizard_model.h"
#include "calibration/range_wizard_model.h"

namespace limbwave::ui {

/// Whether a take has a stretch in which sensors are turned.
bool has_range_segment(const take::Take& take);
/// Indices of the calibration groups whose two poses are both in the take.
std::vector<int> groups_in_take(const take::Take& take);

/// Range verdicts of all sensors. Takes as long as decoding the take; for a job.
Result<std::vector<RangeOutcome>> range_from_take(const take::Take& take, const Progress& progress);

/// Mounting verdicts of one group, or why its poses were refused.
struct LimbFromTake {
  int group = 0;
  std::vector<LimbOutcome> outcomes;
  Error refusal;
};
Result<LimbFromTake> limb_from_take(const take::Take& take, int group, const calibrate::RigCalibration& range,
                                    const Progress& progress);

}  // namespace limbwave::ui
