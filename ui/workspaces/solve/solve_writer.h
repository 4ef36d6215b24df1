/// Puts solves on disk one after the other, whatever threads they come from: an older state never follows a newer one.
#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <string>

#include "base/result.h"

namespace limbwave::ui {

class SolveWriter {
 public:
  /// A number for a state that is to be written. To be drawn in the order of the edits, in the GUI thread.
  int issue() { return ++issued_; }

  /// Waits for what is being written, then writes; a state that a newer one of the same take has overtaken is left out.
  Status write(int number, const std::string& take, const std::function<Status()>& work) {
    const std::lock_guard lock(mutex_);
    int& newest = newest_[take];
    if (number < newest) {
      return {};
    }
    newest = number;
    return work();
  }

 private:
  int issued_ = 0;
  std::mutex mutex_;
  std::map<std::string, int> newest_;
};

}  // namespace limbwave::ui
