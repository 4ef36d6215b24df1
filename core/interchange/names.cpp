#include "interchange/names.h"

#include <cstdint>

namespace limbwave::interchange {
namespace {

// Decodes one code point at `i` and moves past it; -1 for bytes that are not UTF-8 (overlong and surrogates included).
std::int32_t next_code_point(std::string_view text, std::size_t& i) {
  const auto byte = [&](std::size_t n) { return static_cast<unsigned char>(text[n]); };
  const unsigned char first = byte(i);
  if (first < 0x80) {
    ++i;
    return first;
  }
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || i + length > text.size()) {
    return -1;
  }
  std::int32_t code = first & (0x7F >> length);
  for (std::size_t n = 1; n < length; ++n) {
    if ((byte(i + n) & 0xC0) != 0x80) {
      return -1;
    }
    code = (code << 6) | (byte(i + n) & 0x3F);
  }
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  if (overlong || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) {
    return -1;
  }
  i += length;
  return code;
}

bool splits_words(std::int32_t code) {
  return code <= 0x20 || (code >= 0x7F && code <= 0xA0) || code == 0x1680 || (code >= 0x2000 && code <= 0x200A) ||
         code == 0x2028 || code == 0x2029 || code == 0x202F || code == 0x205F || code == 0x3000 || code == 0xFEFF ||
         code == '{' || code == '}';
}

}  // namespace

std::string to_utf8(std::string_view text) {
  std::size_t i = 0;
  while (i < text.size()) {
    if (next_code_point(text, i) < 0) {
      break;
    }
  }
  if (i == text.size()) {
    return std::string(text);
  }
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      result += c;
    } else {
      result += static_cast<char>(0xC0 | (byte >> 6));
      result += static_cast<char>(0x80 | (byte & 0x3F));
    }
  }
  return result;
}

std::string plain_name(std::string_view name) {
  const std::string text = to_utf8(name);
  std::string result;
  std::size_t i = 0;
  while (i < text.size()) {
    const std::size_t start = i;
    const std::int32_t code = next_code_point(text, i);
    if (splits_words(code)) {
      result += '_';
    } else {
      result.append(text, start, i - start);
    }
  }
  return result.empty() ? "joint" : result;
}

std::string UniqueNames::operator()(std::string name) {
  if (taken_.insert(name).second) {
    return name;
  }
  int& next = next_.try_emplace(name, 2).first->second;
  std::string numbered;
  do {
    numbered = name + "_" + std::to_string(next++);
  } while (!taken_.insert(numbered).second);
  return numbered;
}

}  // namespace limbwave::interchange
