/// The first half of a BVH file: its joints and channels, as the file has them. Used by the reader alone.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/result.h"
#include "interchange/text_scan.h"

namespace limbwave::interchange {

/// What a channel sets: position along or rotation about x, y or z.
enum class BvhChannel : unsigned char { kXPosition, kYPosition, kZPosition, kXRotation, kYRotation, kZRotation };

struct BvhJoint {
  std::string name;                      ///< Plain and unique.
  int parent = -1;                       ///< Index, smaller than the own one; -1 for the root.
  Eigen::Vector3d offset{0, 0, 0};       ///< File units and axes.
  std::array<BvhChannel, 6> channels{};  ///< In the order listed.
  std::size_t channel_count = 0;         ///< 0 to 6.
  std::optional<Eigen::Vector3d> end;    ///< Offset of its End Site.
};

/// Largest length that is read, in file units: everything computed from it stays finite.
inline constexpr double kBvhLargestLength = 1e9;

/// Reads from the start to the word MOTION, which is taken. Joints come parents first, in the order of their channels.
Result<std::vector<BvhJoint>> read_bvh_hierarchy(TextScanner& scanner, Diagnostics& diagnostics);

}  // namespace limbwave::interchange
