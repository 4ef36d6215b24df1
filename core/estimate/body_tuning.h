/// Noises of the body filter found from a recording itself: those under which its readings are the most likely.
///
/// The likelihood of readings is that of the innovations (Schweppe 1965), which the filter has anyway. What is
/// tuned are factors on groups of standard deviations that a recording can tell apart: how lively the wearer moves, how
/// noisy words and ranges are.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "estimate/body_step_hook.h"

namespace limbwave::estimate {

struct BodyTuningSettings {
  double seconds = 12.0;   ///< From the beginning of the recording: the start, and some of the motion.
  double settles_s = 3.0;  ///< So much of it does not count, if there is twice as much: what the start did wrong.
  double most = 4.0;       ///< Factors are looked for from 1 / most to most.
  double accuracy = 0.15;  ///< Of a factor's logarithm to base 2.
};

struct TunedNoise {
  std::string what;     ///< "movement", "inertial" or "ranges".
  double factor = 1.0;  ///< On its standard deviations.
};

struct BodyTuning {
  BodyFilterParameters parameters;
  std::vector<TunedNoise> noises;
  double seconds = 0.0;              ///< What was looked at.
  double before = 0.0, after = 0.0;  ///< Log likelihood of it all, what was gated counted as at the gate.
};

/// `hook`: makes what is done around the steps, anew for every run; may be empty. Only noises of sensors that are used
/// are tuned. Fails as filter_body does.
Result<BodyTuning> tune_body(const BodyModel& model, const BodyFilterParameters& parameters,
                             const BodyReadings& readings, const BodyTuningSettings& settings, const Progress& progress,
                             const std::function<std::unique_ptr<BodyStepHook>()>& hook = {});

}  // namespace limbwave::estimate
