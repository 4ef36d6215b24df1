#include "interchange/gltf_embedded.h"

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>

namespace limbwave::interchange {
namespace {

constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::string_view kInside = R"(,"uri":"data:application/octet-stream;base64,)";
constexpr std::uint8_t kNone = 0xFF;

constexpr std::array<std::uint8_t, 256> digits() {
  std::array<std::uint8_t, 256> values{};
  values.fill(kNone);
  for (std::size_t i = 0; i < kAlphabet.size(); ++i) {
    values[static_cast<unsigned char>(kAlphabet[i])] = static_cast<std::uint8_t>(i);
  }
  return values;
}

// Appends the bytes of whole groups of four; false when a character is none of base64.
bool decode(std::string_view text, std::string& out) {
  static constexpr std::array<std::uint8_t, 256> kDigits = digits();
  for (std::size_t at = 0; at < text.size(); at += 4) {
    const bool last = at + 4 == text.size();
    const std::size_t padding = !last || text[at + 3] != '=' ? 0 : text[at + 2] == '=' ? 2 : 1;
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint8_t digit = k >= 4 - padding ? 0 : kDigits[static_cast<unsigned char>(text[at + k])];
      if (digit == kNone) {
        return false;
      }
      group = group << 6 | digit;
    }
    for (std::size_t k = 0; k < 3 - padding; ++k) {
      out.push_back(static_cast<char>(group >> (16 - 8 * k) & 0xFFU));
    }
  }
  return true;
}

void put(std::string& out, std::size_t at, std::uint32_t value) {
  for (std::size_t k = 0; k < 4; ++k) {
    out[at + k] = static_cast<char>(value >> (8 * k) & 0xFFU);
  }
}

}  // namespace

std::string gltf_as_binary(std::string file) {
  const std::size_t from = file.find(kInside);
  if (file.starts_with("glTF") || from == std::string::npos) {
    return file;
  }
  const std::size_t data = from + kInside.size();
  const std::size_t end = file.find('"', data);
  if (end == std::string::npos || (end - data) % 4 != 0 || file.find("\"data:", end) != std::string::npos) {
    return file;
  }
  const std::string_view text(file);
  constexpr std::size_t kHead = 20;
  std::string binary(kHead, '\0');
  binary.reserve(kHead + from + (file.size() - end) + (end - data) / 4 * 3 + 16);
  binary += text.substr(0, from);
  binary += text.substr(end + 1);
  binary.append((4 - binary.size() % 4) % 4, ' ');
  const std::size_t json = binary.size() - kHead;
  binary.append(8, '\0');
  if (!decode(text.substr(data, end - data), binary)) {
    return file;
  }
  binary.append((4 - binary.size() % 4) % 4, '\0');
  if (binary.size() > std::numeric_limits<std::uint32_t>::max()) {
    return file;
  }
  binary.replace(0, 4, "glTF");
  put(binary, 4, 2);
  put(binary, 8, static_cast<std::uint32_t>(binary.size()));
  put(binary, 12, static_cast<std::uint32_t>(json));
  binary.replace(16, 4, "JSON");
  put(binary, kHead + json, static_cast<std::uint32_t>(binary.size() - kHead - json - 8));
  binary.replace(kHead + json + 4, 3, "BIN");
  return binary;
}

}  // namespace limbwave::interchange
