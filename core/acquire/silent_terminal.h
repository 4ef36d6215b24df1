/// Keeps a library from writing to the terminal.
#pragma once

#include <mutex>

namespace limbwave::acquire {

/// libmpg123, which libsndfile uses, writes what it thinks of a file to standard error, whatever it is told. As long as
/// one of these lives, nothing appears there, of other threads neither; only one lives at a time.
class SilentTerminal {
 public:
  /// Does nothing when not `wanted`.
  explicit SilentTerminal(bool wanted);
  ~SilentTerminal();
  SilentTerminal(const SilentTerminal&) = delete;
  SilentTerminal& operator=(const SilentTerminal&) = delete;

 private:
  std::unique_lock<std::mutex> lock_;
  int kept_ = -1;
};

}  // namespace limbwave::acquire
