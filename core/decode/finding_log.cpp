#include "decode/finding_log.h"

#include <fmt/format.h>

#include <utility>

namespace limbwave::decode {
namespace {

constexpr double kToldAgain_s = 60.0;

}  // namespace

void FindingLog::add(Diagnostic finding) {
  Kind& kind = kinds_[finding.code];
  kind.last = finding;
  ++kind.count;
  if (kind.told < told_each_ || finding.time_s - kind.told_s >= kToldAgain_s) {
    ++kind.told;
    kind.told_s = finding.time_s;
    waiting_.push_back(std::move(finding));
  }
}

void FindingLog::summarise() {
  for (auto& [code, kind] : kinds_) {
    if (kind.count > kind.told) {
      Diagnostic summary = kind.last;
      summary.message =
          fmt::format("{} times in all, {} of them told; the last: {}", kind.count, kind.told, kind.last.message);
      waiting_.push_back(std::move(summary));
    }
  }
  kinds_.clear();
}

Diagnostics FindingLog::take() {
  return std::exchange(waiting_, {});
}

}  // namespace limbwave::decode
