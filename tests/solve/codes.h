/// The codes of findings, for tests.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.h"

namespace limbwave::test {

inline std::vector<std::string> codes(const Diagnostics& diagnostics) {
  std::vector<std::string> list;
  for (const Diagnostic& diagnostic : diagnostics) {
    list.push_back(diagnostic.code);
  }
  return list;
}

}  // namespace limbwave::test
