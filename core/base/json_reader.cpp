#include "base/json_reader.h"

#include <fmt/format.h>

#include <algorithm>

namespace limbwave {
namespace {

const nlohmann::json& null_json() {
  static const nlohmann::json null;
  return null;
}

constexpr int kDepthLimit = 64;

bool too_deep(std::string_view text) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') {
        ++i;
      } else if (c == '"') {
        in_string = false;
      }
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      if (++depth > kDepthLimit) {
        return true;
      }
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return false;
}

}  // namespace

Result<nlohmann::json> parse_json(std::string_view text, const std::string& place) {
  if (too_deep(text)) {
    return Error{fmt::format("is nested deeper than {} levels", kDepthLimit), place, "check that it is the right file"};
  }
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    const std::size_t end = std::min(error.byte > 0 ? error.byte - 1 : 0, text.size());
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
    const std::size_t last_newline = end == 0 ? std::string_view::npos : text.rfind('\n', end - 1);
    const std::size_t column = last_newline == std::string_view::npos ? end + 1 : end - last_newline;
    return Error{"is not valid JSON", fmt::format("{}:{}:{}", place, line, column), "correct it there"};
  } catch (const nlohmann::json::exception&) {  // a number beyond the range of double
    return Error{"is not valid JSON: it holds a number that is too large", place, "correct it there"};
  }
}

void JsonReader::fail(const std::string& message, const std::string& remedy) const {
  if (!state_->error) {
    state_->error = Error{message, fmt::format("{}: {}", state_->place, path_.empty() ? "top level" : path_), remedy};
  }
}

void JsonReader::allow(std::initializer_list<const char*> keys) const {
  if (!value_->is_object()) {
    fail("is not an object");
    return;
  }
  for (auto entry = value_->begin(); entry != value_->end(); ++entry) {
    const std::string& key = entry.key();
    if (std::none_of(keys.begin(), keys.end(), [&](const char* allowed) { return key == allowed; })) {
      std::string list;
      for (const char* allowed : keys) {
        list += list.empty() ? allowed : std::string(", ") + allowed;
      }
      JsonReader(*entry, path_ + "/" + key, *state_).fail("is not a known key", "known here: " + list);
    }
  }
}

JsonReader JsonReader::at(const char* key) const {
  const std::string child = path_ + "/" + key;
  if (!has(key)) {
    JsonReader missing(null_json(), child, *state_);
    missing.fail("is missing");
    return missing;
  }
  return {(*value_)[key], child, *state_};
}

std::vector<JsonReader> JsonReader::items() const {
  std::vector<JsonReader> readers;
  if (!value_->is_array()) {
    fail("is not a list");
    return readers;
  }
  for (std::size_t i = 0; i < value_->size(); ++i) {
    readers.emplace_back((*value_)[i], fmt::format("{}/{}", path_, i), *state_);
  }
  return readers;
}

double JsonReader::number(double minimum, double maximum) const {
  if (!value_->is_number()) {
    fail("is not a number");
    return std::clamp(0.0, minimum, std::max(minimum, maximum));
  }
  const auto number = value_->get<double>();
  if (!std::isfinite(number) || number < minimum || number > maximum) {
    fail(fmt::format("is {}, outside {} to {}", number, minimum, maximum));
    return minimum > -std::numeric_limits<double>::infinity() ? minimum : 0.0;
  }
  return number;
}

std::int64_t JsonReader::integer(std::int64_t minimum, std::int64_t maximum) const {
  if (!value_->is_number_integer()) {
    fail("is not a whole number");
    return minimum;
  }
  // Whole numbers beyond int64 are kept as unsigned ones.
  const bool fits =
      !value_->is_number_unsigned() ||
      value_->get<std::uint64_t>() <= static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  if (!fits) {
    fail(fmt::format("is {}, outside {} to {}", value_->get<std::uint64_t>(), minimum, maximum));
    return minimum;
  }
  const auto number = value_->get<std::int64_t>();
  if (number < minimum || number > maximum) {
    fail(fmt::format("is {}, outside {} to {}", number, minimum, maximum));
    return minimum;
  }
  return number;
}

bool JsonReader::boolean() const {
  if (!value_->is_boolean()) {
    fail("is not true or false");
    return false;
  }
  return value_->get<bool>();
}

std::string JsonReader::string() const {
  if (!value_->is_string()) {
    fail("is not a text");
    return {};
  }
  return value_->get<std::string>();
}

std::vector<double> JsonReader::numbers(std::size_t count) const {
  std::vector<double> values(count, 0.0);
  const std::vector<JsonReader> readers = items();
  if (readers.size() != count) {
    fail(fmt::format("has {} values instead of {}", readers.size(), count));
    return values;
  }
  for (std::size_t i = 0; i < count; ++i) {
    values[i] = readers[i].number();
  }
  return values;
}

}  // namespace limbwave
