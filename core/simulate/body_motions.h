/// The built-in motions of a whole body.
#pragma once

#include <memory>
#include <string>

#include "simulate/motions.h"

namespace limbwave::simulate {

/// Whether the skeleton has the segments of "body" that the motions move.
bool is_whole_body(const body::Skeleton& skeleton);
/// "walk", "run", "box", "wave", "reach", "arm-raise" or "squat" on a whole body; null for another name.
std::shared_ptr<const BodyMotion> make_body_motion(const std::string& name, const body::Skeleton& skeleton);

}  // namespace limbwave::simulate
