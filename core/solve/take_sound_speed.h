/// The speed of sound of a take of a driver box, from its own samples.
#pragma once

#include "base/progress.h"
#include "base/result.h"
#include "calibrate/sound_speed.h"
#include "take/take.h"

namespace limbwave::solve {

/// From the first two minutes. Fails when it is no take of a driver box, or too little is heard between sources and
/// microphones on one segment.
Result<calibrate::SoundSpeed> speed_of_sound_from(const take::Take& take, const Progress& progress);

}  // namespace limbwave::solve
