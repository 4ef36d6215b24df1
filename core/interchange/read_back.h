/// Whether a written file holds the movement that was meant.
#pragma once

#include <filesystem>
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

/// Compares joints at every key of `meant`. Clips belong together in their order, bones in depth-first order, which all
/// our writers and readers keep. `single_times`: the file holds key times in single precision. Fails, naming joint and
/// frame, where one is further off than `tolerance_m`, and when clips or bones are missing, or when cancelled.
Result<ReadBack> compare_clips(const std::vector<motion::Clip>& meant, const std::vector<motion::Clip>& read,
                               bool single_times, double tolerance_m, const std::string& place,
                               const Progress& progress = {});

/// The same for poses as CSV, whose rows are compared with the clip at multiples of 1/fps.
Result<ReadBack> compare_csv(const motion::Clip& meant, double fps, const std::filesystem::path& path,
                             double tolerance_m, const Progress& progress = {});

}  // namespace limbwave::interchange
