/// Reading numbers and words from text files: independent of locale, never past the end, errors with their line.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/result.h"

namespace limbwave::interchange {

/// Reads a decimal number at `p` and moves behind it; correctly rounded. False (and `p` unmoved) when there is none or
/// it is not finite: "nan" and "inf" are not numbers here.
inline bool scan_number(const char*& p, const char* end, double& value) {
  const char* s = p;
  const bool negative = s < end && *s == '-';
  if (s < end && (*s == '-' || *s == '+')) {
    ++s;
  }
  const char* const digits = s;
  std::uint64_t mantissa = 0;
  while (s < end && *s >= '0' && *s <= '9') {
    mantissa = mantissa * 10 + static_cast<std::uint64_t>(*s++ - '0');
  }
  auto count = s - digits;
  std::ptrdiff_t decimals = 0;
  if (s < end && *s == '.') {
    const char* const fraction = ++s;
    while (s < end && *s >= '0' && *s <= '9') {
      mantissa = mantissa * 10 + static_cast<std::uint64_t>(*s++ - '0');
    }
    decimals = s - fraction;
    count += decimals;
  }
  if (count == 0) {
    return false;
  }
  const bool exponent = s < end && (*s == 'e' || *s == 'E');
  constexpr double kPowers[] = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  // Up to fifteen digits both the mantissa and the power of ten are exact, so their quotient is correctly rounded.
  if (!exponent && count <= 15) {
    const double magnitude = static_cast<double>(mantissa) / kPowers[decimals];
    value = negative ? -magnitude : magnitude;
    p = s;
    return true;
  }
  const char* const start = *p == '+' ? p + 1 : p;
  double slow = 0.0;
  const auto [last, code] = std::from_chars(start, end, slow);
  if (code != std::errc() || !std::isfinite(slow)) {
    return false;
  }
  value = slow;
  p = last;
  return true;
}

/// A cursor over text in which lines end in LF, CR LF or CR, and lines that start with '#' are comments.
class TextScanner {
 public:
  TextScanner(std::string_view text, std::string place)
      : begin_(text.data()), p_(text.data()), end_(text.data() + text.size()), place_(std::move(place)) {}

  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
  static bool is_line_end(char c) { return c == '\n' || c == '\r'; }
  static bool is_space(char c) { return is_blank(c) || is_line_end(c); }

  [[nodiscard]] bool at_end() const { return p_ == end_; }
  [[nodiscard]] bool at_line_end() const { return p_ == end_ || is_line_end(*p_); }
  [[nodiscard]] std::size_t left() const { return static_cast<std::size_t>(end_ - p_); }

  void skip_blanks() {
    while (p_ < end_ && is_blank(*p_)) {
      ++p_;
    }
  }
  /// Skips white space, line ends and comments.
  void skip_space() {
    while (p_ < end_ && (is_space(*p_) || (*p_ == '#' && first_on_line()))) {
      if (*p_ == '#') {
        skip_line();
      } else {
        ++p_;
      }
    }
  }
  void skip_line() {
    while (p_ < end_ && !is_line_end(*p_)) {
      ++p_;
    }
  }

  /// The characters up to the next white space, brace or colon; a brace or colon by itself is a word. Empty at the end.
  std::string_view word();
  /// Looks at the next word without taking it.
  std::string_view peek_word() {
    const char* const here = p_;
    const std::string_view next = word();
    p_ = here;
    return next;
  }
  /// The rest of the line up to `stop`, without white space at its ends.
  std::string_view rest_of_line(char stop);
  /// A number, which must end at white space, a brace or the end of the text.
  bool number(double& value) {
    const char* const here = p_;
    if (scan_number(p_, end_, value) && (p_ == end_ || is_space(*p_) || *p_ == '{' || *p_ == '}')) {
      return true;
    }
    p_ = here;
    return false;
  }

  /// The line of the cursor, counted from 1.
  [[nodiscard]] std::size_t line() const;
  /// An error at the cursor: `FILE:LINE: message; remedy`.
  [[nodiscard]] Error error(std::string message, std::string remedy) const;
  /// What stands at the cursor, shortened and made printable, for messages.
  [[nodiscard]] std::string here() const;

 private:
  [[nodiscard]] bool first_on_line() const {
    const char* s = p_;
    while (s > begin_ && is_blank(s[-1])) {
      --s;
    }
    return s == begin_ || is_line_end(s[-1]);
  }

  const char* begin_;
  const char* p_;
  const char* end_;
  std::string place_;
};

/// Whether two words are the same but for upper and lower case (ASCII).
bool same_word(std::string_view a, std::string_view b);

}  // namespace limbwave::interchange
