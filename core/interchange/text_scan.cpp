#include "interchange/text_scan.h"

#include <fmt/format.h>

#include <algorithm>

#include "interchange/names.h"

namespace limbwave::interchange {
namespace {

bool ends_word(char c) {
  return TextScanner::is_space(c) || c == '{' || c == '}' || c == ':';
}

}  // namespace

std::string_view TextScanner::word() {
  skip_space();
  const char* const start = p_;
  while (p_ < end_ && !ends_word(*p_)) {
    ++p_;
  }
  if (p_ == start && p_ < end_) {
    ++p_;
  }
  return {start, static_cast<std::size_t>(p_ - start)};
}

std::string_view TextScanner::rest_of_line(char stop) {
  skip_blanks();
  const char* const start = p_;
  while (p_ < end_ && !is_line_end(*p_) && *p_ != stop) {
    ++p_;
  }
  const char* last = p_;
  while (last > start && is_blank(last[-1])) {
    --last;
  }
  return {start, static_cast<std::size_t>(last - start)};
}

std::size_t TextScanner::line() const {
  const auto feeds = std::count(begin_, p_, '\n');
  // Only files without any line feed count their carriage returns.
  const bool old_mac = feeds == 0 && std::find(begin_, end_, '\n') == end_;
  return 1 + static_cast<std::size_t>(old_mac ? std::count(begin_, p_, '\r') : feeds);
}

Error TextScanner::error(std::string message, std::string remedy) const {
  return {std::move(message), fmt::format("{}:{}", place_, line()), std::move(remedy)};
}

std::string TextScanner::here() const {
  constexpr std::size_t kShown = 24;
  const char* last = p_;
  while (last < end_ && !is_space(*last) && static_cast<std::size_t>(last - p_) < kShown) {
    ++last;
  }
  if (last == p_) {
    return p_ == end_ ? "the end of the file" : "the end of the line";
  }
  std::string shown = to_utf8({p_, static_cast<std::size_t>(last - p_)});
  for (char& c : shown) {
    c = static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? '?' : c;
  }
  return "\"" + shown + "\"";
}

bool same_word(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(), [&](char x, char y) { return lower(x) == lower(y); });
}

}  // namespace limbwave::interchange
