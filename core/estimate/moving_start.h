/// The start of a recording that begins in mid-motion, or in a pose that is not the rest pose.
///
/// There is nothing known to start from: where the limbs are has to be found from ranges and gravity, and a filter that
/// begins at the rest pose linearises them where they are not. So the first seconds are solved as a whole, again and
/// again, each time linearised about what was found before (body_batch.h), once from the rest pose and once from limbs
/// inclined as their boards feel gravity on average; the recording is started from what costs less.
#pragma once

#include <optional>

#include "base/progress.h"
#include "base/result.h"
#include "estimate/body_watch.h"

namespace limbwave::estimate {

struct MovingStartParameters {
  double seconds = 3.0;  ///< Of the recording that are looked at.
  int rounds = 6;        ///< Of Gauss and Newton's method at most, from each of two beginnings.
  /// A start that is used costs less than this part of what the filter's own costs. Rest poses that were near enough
  /// cost up to a third more than the optimum, others twice and more.
  double worthwhile = 0.6;
};

/// The state at the first reading; nothing where the recording begins with rest in the rest pose (as
/// RestParameters::mode has it), has no ranges, or where what was found fits hardly better than the rest pose, or not
/// at all. Fails when it is cancelled, or as the filter's start does.
Result<std::optional<BodyState>> find_moving_start(const BodyModel& model, const BodyFilterParameters& parameters,
                                                   const BodyWatchParameters& watch, const BodyReadings& readings,
                                                   const Progress& progress, const MovingStartParameters& start = {});

}  // namespace limbwave::estimate
