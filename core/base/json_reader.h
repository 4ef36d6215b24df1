/// Reading of JSON files that people edit: every refusal names the path of the key, and unknown keys are refused.
#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace limbwave {

/// Parses text; the error names `place` with line and column. Depth and NaN are checked.
Result<nlohmann::json> parse_json(std::string_view text, const std::string& place);

/// A cursor into a JSON document that remembers its path and the first thing that was wrong. Reading goes on after an
/// error with default values, so that code reads a whole structure in a row and asks `status()` once at the end.
class JsonReader {
 public:
  struct State {
    std::string place;
    std::optional<Error> error;
  };

  JsonReader(const nlohmann::json& value, std::string path, State& state)
      : value_(&value), path_(std::move(path)), state_(&state) {}

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] const nlohmann::json& raw() const { return *value_; }
  [[nodiscard]] bool has(const char* key) const { return value_->is_object() && value_->contains(key); }

  /// Refuses keys that are not in the list; also refuses what is not an object.
  void allow(std::initializer_list<const char*> keys) const;

  /// The child under `key`; a missing one is an error.
  [[nodiscard]] JsonReader at(const char* key) const;
  /// The elements of an array.
  [[nodiscard]] std::vector<JsonReader> items() const;

  [[nodiscard]] double number(double minimum = -std::numeric_limits<double>::infinity(),
                              double maximum = std::numeric_limits<double>::infinity()) const;
  std::int64_t integer(std::int64_t minimum, std::int64_t maximum) const;
  [[nodiscard]] bool boolean() const;
  [[nodiscard]] std::string string() const;
  /// Exactly `count` numbers.
  [[nodiscard]] std::vector<double> numbers(std::size_t count) const;

  // The same for an optional key of this object, with the value to use when it is absent.
  [[nodiscard]] double number_or(const char* key, double otherwise,
                                 double minimum = -std::numeric_limits<double>::infinity(),
                                 double maximum = std::numeric_limits<double>::infinity()) const {
    return has(key) ? at(key).number(minimum, maximum) : otherwise;
  }
  [[nodiscard]] std::string string_or(const char* key, std::string otherwise) const {
    return has(key) ? at(key).string() : std::move(otherwise);
  }
  [[nodiscard]] bool boolean_or(const char* key, bool otherwise) const {
    return has(key) ? at(key).boolean() : otherwise;
  }

  /// Notes that this value is wrong: the error's place becomes `FILE: path`.
  void fail(const std::string& message, const std::string& remedy = "") const;

 private:
  const nlohmann::json* value_;
  std::string path_;
  State* state_;
};

}  // namespace limbwave
