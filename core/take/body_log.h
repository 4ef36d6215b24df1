/// Takes that hold readings of other people's sensors: TAKE/readings/inertial.csv, ranges.csv (overview.md).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "body/rig.h"
#include "estimate/body_model.h"
#include "take/take.h"

namespace limbwave::take {

/// Reads tables of readings; each is recognised by its columns. Sensors are boards of the model by name; where the rig
/// has one board and a table has no column "sensor", all rows are that board's. Fails for unknown sensors, for cells
/// that are not numbers and for rows out of order, naming the line.
Result<estimate::BodyReadings> read_logs(const std::vector<std::filesystem::path>& files,
                                         const estimate::BodyModel& model);
/// A path of the root: time_s,qw,qx,qy,qz,px_m,py_m,pz_m. Rows with empty cells are left out.
Result<std::vector<estimate::RootReading>> read_root(const std::filesystem::path& file);
/// The root's rows of a truth table (time_s,segment,qw..pz_m).
Result<std::vector<estimate::RootReading>> read_root_of_truth(const std::filesystem::path& file,
                                                              const std::string& segment);

/// Makes a take of kind "log". The files are checked and copied; nothing is left when it fails.
Result<Take> import_logs(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& files,
                         const body::Rig& rig, const body::Skeleton& skeleton, const std::string& subject);
/// The readings of such a take.
Result<estimate::BodyReadings> read_logs_of(const Take& take, const estimate::BodyModel& model);

}  // namespace limbwave::take
