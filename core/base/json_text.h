/// JSON as text, whatever names it holds.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace limbwave {

/// The document as text; `indent` as in nlohmann::json::dump. Bytes that are not UTF-8 (a file's or a device's name)
/// are replaced by U+FFFD: nothing must fail because of its spelling.
std::string json_text(const nlohmann::json& json, int indent = -1);

}  // namespace limbwave
