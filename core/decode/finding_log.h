/// Collects findings so that a fault that keeps coming back does not flood anybody.
#pragma once

#include <map>
#include <string>

#include "base/diagnostics.h"

namespace limbwave::decode {

/// The first few of a kind are told as they come, the rest is counted and summed up at the end.
class FindingLog {
 public:
  explicit FindingLog(int told_each) : told_each_(told_each) {}
  void add(Diagnostic finding);
  /// Adds one line per kind of which not all were told.
  void summarise();
  Diagnostics take();

 private:
  struct Kind {
    int count = 0;
    Diagnostic last;
  };
  int told_each_;
  std::map<std::string, Kind> kinds_;
  Diagnostics waiting_;
};

}  // namespace limbwave::decode
