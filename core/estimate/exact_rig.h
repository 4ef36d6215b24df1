/// Whether a rig is exactly as its file says: boards and sources at their places, bones as long as written, sensors
/// without systematic errors. Then there is nothing to estimate but the motion, and estimating it alone is far sharper.
#pragma once

#include "base/result.h"
#include "estimate/body_filter.h"

namespace limbwave::estimate {

/// The parameters of a filter that takes the rig for exact: no constants among its states, no noise that stands for
/// scale errors and skin, limbs free to move as they like.
BodyFilterParameters exact_parameters(const BodyFilterParameters& parameters);

/// True where such a filter, run over the first seconds, is contradicted by nothing: over the second half of that time
/// the normalised innovations squared of every board and source are on average those of the sensors' white noise or
/// less. A mounting that is off by a few tenths of a degree is told from an exact one. Needs the root to be given or
/// fixed, and all three kinds of sensors: ranges tell lengths and places, which limbs that move freely cannot explain
/// away. False where they are not there.
bool rig_is_exact(const BodyModel& model, const BodyFilterParameters& parameters, const BodyReadings& readings);

}  // namespace limbwave::estimate
