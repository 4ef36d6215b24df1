#include "base/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>

namespace limbwave {

std::string_view name(Severity severity) {
  switch (severity) {
    case Severity::kInfo:
      return "info";
    case Severity::kWarning:
      return "warning";
    case Severity::kError:
      return "error";
  }
  return "unknown";
}

std::string Diagnostic::text() const {
  std::string line = fmt::format("{}: ", name(severity));
  if (time_s >= 0.0) {
    line += fmt::format("at {:.2f} s: ", time_s);
  }
  if (!place.empty()) {
    line += place + ": ";
  }
  line += message;
  if (!remedy.empty()) {
    line += "; " + remedy;
  }
  return line;
}

Severity worst(const Diagnostics& diagnostics) {
  Severity severity = Severity::kInfo;
  for (const Diagnostic& diagnostic : diagnostics) {
    severity = std::max(severity, diagnostic.severity);
  }
  return severity;
}

}  // namespace limbwave
