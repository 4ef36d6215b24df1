/// Collects findings so that a fault that keeps coming back does not flood anybody.
#pragma once

#include <map>
#include <string>

#include "base/diagnostics.h"

namespace limbwave::decode {

/// The first few of a kind are told as they come, then one a minute, for whoever looks at a line for hours. The rest is
/// counted and summed up.
class FindingLog {
 public:
  explicit FindingLog(int told_each) : told_each_(told_each) {}
  void add(Diagnostic finding);
  /// Adds one line per kind of which not all were told, and starts counting anew.
  void summarise();
  /// Forgets what was told and counted.
  void restart() { kinds_.clear(); }
  Diagnostics take();

 private:
  struct Kind {
    int count = 0, told = 0;
    double told_s = 0.0;  // when it was told last
    Diagnostic last;
  };
  int told_each_;
  std::map<std::string, Kind> kinds_;
  Diagnostics waiting_;
};

}  // namespace limbwave::decode
