/// Poses as CSV for spreadsheets and scripts: time_s,segment,qw,qx,qy,qz,px_m,py_m,pz_m, segment → world, z up.
#pragma once

#include <filesystem>
#include <string>

#include "base/progress.h"
#include "base/result.h"
#include "motion/clip.h"

namespace limbwave::interchange {

struct CsvPosesOptions {
  double fps = 0.0;  ///< Frames per second; 0 = the clip's own frame rate.
};

/// World poses of all segments at multiples of 1/fps, one row per segment and time, rows in time order. Numbers have a
/// decimal point whatever the locale; quaternions w first, signs continuous. Names with commas or quotes are quoted.
Result<std::string> csv_poses_text(const motion::Clip& clip, const CsvPosesOptions& options = {},
                                   const Progress& progress = {});

/// Writes `csv_poses_text` all-or-nothing.
Status write_csv_poses(const motion::Clip& clip, const std::filesystem::path& path, const CsvPosesOptions& options = {},
                       const Progress& progress = {});

}  // namespace limbwave::interchange
