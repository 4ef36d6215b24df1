/// take.json and the lines of events.jsonl as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "base/result.h"
#include "take/take.h"

namespace limbwave::take {

/// Unknown keys and impossible values are refused with `place` and the path of the key.
Result<TakeInfo> info_from_json(const nlohmann::json& json, const std::string& place);
nlohmann::json info_to_json(const TakeInfo& info);

/// One line of events.jsonl, without its end.
Result<TakeEvent> event_from_line(std::string_view line, const std::string& place);
std::string event_to_line(const TakeEvent& event);

}  // namespace limbwave::take
