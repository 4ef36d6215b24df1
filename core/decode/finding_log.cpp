#include "decode/finding_log.h"

#include <fmt/format.h>

#include <utility>

namespace limbwave::decode {

void FindingLog::add(Diagnostic finding) {
  Kind& kind = kinds_[finding.code];
  kind.last = finding;
  if (++kind.count <= told_each_) {
    waiting_.push_back(std::move(finding));
  }
}

void FindingLog::summarise() {
  for (auto& [code, kind] : kinds_) {
    if (kind.count > told_each_) {
      Diagnostic summary = kind.last;
      summary.message =
          fmt::format("{} times in all, {} of them told; the last: {}", kind.count, told_each_, kind.last.message);
      waiting_.push_back(std::move(summary));
      kind.count = 0;
    }
  }
}

Diagnostics FindingLog::take() {
  return std::exchange(waiting_, {});
}

}  // namespace limbwave::decode
