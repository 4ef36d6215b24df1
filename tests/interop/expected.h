/// What an independent reader must find in a file that was written from clips.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "motion/clip.h"

namespace limbwave::test {

/// Differences that readers may have, metres.
inline constexpr double kAtKeys = 1e-5;
inline constexpr double kAtBvhKeys = 1e-4;
inline constexpr double kHalfway = 1e-2;

struct Expect {
  bool bvh = false;              ///< Names are plain, bones end in End Sites, lengths have no unit.
  double metres_per_unit = 1.0;  ///< Of BVH.
  double fps = 60.0;
  double at_keys_m = kAtKeys;
  bool reduced = false;     ///< Only the first and the last frame have keys on all tracks.
  bool gltf = false;        ///< Names are made unique actor by actor, elsewhere bones first.
  bool keep_names = false;  ///< Names stay as they are, because another program wrote the file.
  bool halfway = false;     ///< Look at joints half-way between frames too.
  std::size_t most_times = 40;
};

/// Writes `file` with the ending ".expected.json" behind its name: frame rate, duration, names, rest pose, and joints
/// and vertices at keys and half-way between them. Positions are in Blender's world: metres, z up, figures face −y.
void expect(const std::filesystem::path& file, std::span<const motion::Clip> clips, const Expect& how);

/// `names` as writers make them unique: the second of a name gets "_2", the third "_3".
std::vector<std::string> made_unique(const std::vector<std::string>& names);

}  // namespace limbwave::test
