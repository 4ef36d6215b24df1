/// truth.json: what was really done in a simulated take.
#pragma once

#include <filesystem>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "simulate/simulation.h"

namespace limbwave::simulate {

/// Rate of the truth's samples, Hz; sample i is at i / rate seconds of the take.
inline constexpr double kTruthRateHz = 240.0;

/// Writes the file. `frames` is the length of the take, `cycle_starts` real times of the cycles' starts. Fails when the
/// file cannot be written, or cancelled.
Status write_truth(const std::filesystem::path& path, const Simulation& simulation, const SimulateSettings& settings,
                   std::int64_t frames, const std::vector<double>& cycle_starts, const Progress& progress);

}  // namespace limbwave::simulate
