/// Whether a written file holds the movement that was meant.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "motion/clip.h"

namespace limbwave::interchange {

struct ReadBack {
  double worst_m = 0.0;  ///< Largest distance between a joint as meant and as read.
  std::string worst_joint;
  double worst_time_s = 0.0;
};

/// Where the joints of a clip are at all its keys: a third of the memory that the clip takes.
struct JointPaths {
  std::vector<std::string> names;  ///< One per joint.
  std::vector<int> parents;        ///< By index; -1 for the root, which is the first.
  double frame_rate_hz = 60.0;
  std::vector<double> times_s;         ///< At least one.
  std::vector<Eigen::Vector3d> roots;  ///< p_W of the root joint at every time, metres.
  std::vector<Eigen::Vector3f> rest;   ///< From the root joint to all others in the world's axes, time after time.
};
JointPaths joint_paths(const motion::Clip& clip);

/// An actor of a written file, played from its start to its end.
struct WrittenActor {
  std::vector<int> parents;  ///< As JointPaths::parents.
  /// Puts p_W of every joint at a time; times never decrease.
  std::function<Status(double time_s, std::vector<Eigen::Vector3d>& p_W)> places;
};

/// Compares joints at every key of what was meant. Actors belong together in their order, bones in depth-first order,
/// which all our writers and readers keep. Fails, naming joint and frame, where one is further off than `tolerance_m`,
/// and when actors or bones are missing, or when cancelled.
Result<ReadBack> compare_paths(const std::vector<JointPaths>& meant, const std::vector<WrittenActor>& written,
                               double tolerance_m, const std::string& place, const Progress& progress = {});

/// The same for poses as CSV, whose rows are compared with the clip at multiples of 1/fps.
Result<ReadBack> compare_csv(const motion::Clip& meant, double fps, const std::filesystem::path& path,
                             double tolerance_m, const Progress& progress = {});

}  // namespace limbwave::interchange
