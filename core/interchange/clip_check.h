/// What every writer asks of a clip before it writes.
#pragma once

#include <span>
#include <string>

#include "base/result.h"
#include "motion/clip.h"

namespace limbwave::interchange {

/// Whether the clip has a skeleton, its rest pose is finite, parents come before children, tracks belong to segments,
/// key times are finite, increase and start at 0 or later, and keys are finite. Errors name the joint and the time.
Status check_clip(const motion::Clip& clip);

/// The same for all actors of one file, which must be at least one, and for their meshes. `place` names the file.
Status check_actors(std::span<const motion::Clip* const> clips, const std::string& place);

}  // namespace limbwave::interchange
