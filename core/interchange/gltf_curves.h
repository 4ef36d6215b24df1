/// Tracks as glTF's samplers hold them. Used by the writer alone.
#pragma once

#include <string>
#include <vector>

#include "motion/track.h"

namespace limbwave::interchange {

/// One sampler: times, and one value a key, or for CUBICSPLINE tangent, value, tangent. Y up, x, y, z, w.
struct GltfCurve {
  std::vector<double> times;
  std::vector<float> values;
  std::string interpolation;  ///< "STEP", "LINEAR" or "CUBICSPLINE".
};

/// glTF has one interpolation a sampler and cubic curves of quaternion components: cubic pieces are halved until such a
/// curve stays within 0.01° (positions: exact) of ours; tracks that mix interpolations become linear keys at `fps` and
/// at their own keys.
/// Asserts that the track is not empty.
GltfCurve gltf_curve(const motion::RotationTrack& track, double fps);
GltfCurve gltf_curve(const motion::PositionTrack& track, double fps);

/// "LINEAR" or "STEP" when the track's own keys are what is written, null when they must become a `gltf_curve`.
const char* gltf_plain(const motion::RotationTrack& track);
const char* gltf_plain(const motion::PositionTrack& track);

}  // namespace limbwave::interchange
