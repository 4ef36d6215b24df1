/// Names of joints that every reader accepts.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

namespace limbwave::interchange {

/// `text` as valid UTF-8: unchanged if it is, else every byte taken as Latin-1.
std::string to_utf8(std::string_view text);

/// A name without what splits or ends words in text formats: white space of any kind (also Unicode's, which Python
/// splits at), control characters and braces become '_'. Valid UTF-8; empty becomes "joint".
std::string plain_name(std::string_view name);

/// Gives every name once: a repeated one gets "_2", "_3" ... appended.
class UniqueNames {
 public:
  std::string operator()(std::string name);

 private:
  std::unordered_set<std::string> taken_;
  std::unordered_map<std::string, int> next_;
};

}  // namespace limbwave::interchange
