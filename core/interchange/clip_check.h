/// What every writer asks of a clip before it writes.
#pragma once

#include "base/result.h"
#include "motion/clip.h"

namespace limbwave::interchange {

/// Whether the clip has a skeleton, its rest pose is finite, parents come before children, tracks belong to segments,
/// key times are finite, increase and start at 0 or later, and keys are finite. Errors name the joint and the time.
Status check_clip(const motion::Clip& clip);

}  // namespace limbwave::interchange
