/// A solve's quality in words and as JSON.
#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
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

/// All smoothings, in the order in which faces list them.
inline constexpr std::array kSmoothings{Smoothing::kChain, Smoothing::kAdaptive, Smoothing::kBridging,
                                        Smoothing::kNone};
std::string_view name(Smoothing smoothing);  ///< "none", "adaptive", "bridging", "chain"
/// The other way round; empty for anything else.
std::optional<Smoothing> smoothing_named(std::string_view wanted);

}  // namespace limbwave::solve
