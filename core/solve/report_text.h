/// A solve's quality in words and as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "solve/solve.h"

namespace limbwave::solve {

/// For people: one line a fact, numbers with units.
std::vector<std::string> report_lines(const Solve& solve);
nlohmann::json report_to_json(const Solve& solve);
/// Only what `report_to_json` wrote; unknown keys are ignored, missing ones keep their defaults.
QualityReport report_from_json(const nlohmann::json& json);

nlohmann::json settings_to_json(const SolveSettings& settings);
Result<SolveSettings> settings_from_json(const nlohmann::json& json, const std::string& place);

std::string_view name(Smoothing smoothing);  ///< "none", "adaptive", "bridging"

}  // namespace limbwave::solve
