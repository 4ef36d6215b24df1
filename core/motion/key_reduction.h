/// Fewer keys for the same movement, within a stated tolerance.
#pragma once

#include "base/progress.h"
#include "base/result.h"
#include "motion/clip.h"

namespace limbwave::motion {

struct KeyReduction {
  double rotation_rad = 0.0;     ///< A joint's rotation relative to its parent may differ by this much, geodesic.
  double position_m = 1e-3;      ///< A position may differ by this much.
  std::size_t longest = 100000;  ///< Keys that are looked at together; bounds the time on very long clips.
};

struct ReducedClip {
  Clip clip;
  std::size_t keys_before = 0;
  std::size_t keys_after = 0;
  double worst_rotation_rad = 0.0;  ///< Largest difference found, over all keys that were there.
  double worst_position_m = 0.0;
};

/// Keeps of every track as few of its keys as the tolerance allows, as linear keys with their old values (Ramer 1972,
/// Douglas & Peucker 1973, with the geodesic angle as distance). First and last keys stay. The bound holds at every key
/// that was there; tracks that are not linear are kept as they are. Fails only when cancelled.
Result<ReducedClip> reduced(const Clip& clip, const KeyReduction& limits, const Progress& progress = {});

}  // namespace limbwave::motion
