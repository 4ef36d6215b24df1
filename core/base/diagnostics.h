/// Findings about data that do not stop the work: what was seen, where, and what to do about it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace limbwave {

enum class Severity { kInfo, kWarning, kError };

/// "info", "warning" or "error".
std::string_view name(Severity severity);

/// One finding. `code` is stable and machine-readable ("line-in.clipping"); faces translate the text by it.
struct Diagnostic {
  Severity severity = Severity::kWarning;
  std::string code;
  std::string message;   ///< What was seen, with its numbers.
  std::string remedy;    ///< What to do; may be empty.
  std::string place;     ///< File with line, key path, sensor or channel; may be empty.
  double time_s = -1.0;  ///< Seconds since the start of the take; negative where time has no meaning.

  [[nodiscard]] std::string text() const;
};

using Diagnostics = std::vector<Diagnostic>;

/// The most severe finding, kInfo when there are none.
Severity worst(const Diagnostics& diagnostics);

}  // namespace limbwave
