/// Results of operations that can fail for reasons outside the program: files, devices, data.
/// Broken invariants of the program itself are asserted, never reported this way.
#pragma once

#include <cassert>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace limbwave {

/// Why something failed: what is wrong, where, and what the user can do about it.
struct Error {
  std::string message;  ///< What is wrong, one sentence without a full stop: "the recording has one channel"
  std::string place;    ///< File, device or key path, with a line or byte offset where known; may be empty
  std::string remedy;   ///< What to do, one sentence without a full stop: "record in stereo"; may be empty

  /// One line: `PLACE: message: remedy`.
  [[nodiscard]] std::string text() const {
    std::string line = place.empty() ? message : place + ": " + message;
    return remedy.empty() ? line : line + "; " + remedy;
  }
};

/// A value or the reason why there is none. Check before use: `if (!result) return result.error();`
template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}      // NOLINT(google-explicit-constructor)
  Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}  // NOLINT(google-explicit-constructor)

  [[nodiscard]] bool ok() const { return content_.index() == 0; }
  explicit operator bool() const { return ok(); }

  /// The value; asserts that there is one.
  T& value() & { return assert(ok()), *std::get_if<0>(&content_); }
  const T& value() const& { return assert(ok()), *std::get_if<0>(&content_); }
  T&& value() && { return assert(ok()), std::move(*std::get_if<0>(&content_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  /// The reason; asserts that there is one.
  [[nodiscard]] const Error& error() const { return assert(!ok()), std::get<1>(content_); }

 private:
  std::variant<T, Error> content_;
};

/// Success, or the reason why not.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}  // NOLINT(google-explicit-constructor)
  [[nodiscard]] bool ok() const { return !error_.has_value(); }
  explicit operator bool() const { return ok(); }
  [[nodiscard]] const Error& error() const { return assert(!ok()), *error_; }

 private:
  std::optional<Error> error_;
};

using Status = Result<void>;

}  // namespace limbwave
