/// A real JACK server of a test's own, with JACK's dummy driver.
#pragma once

#include <memory>
#include <string>

#include "support/child_process.h"
#include "support/temporary_folder.h"

namespace limbwave::test {

/// As long as it lives, this process's JACK clients find it. JACK remembers eight servers of a user at most, and one
/// that was killed keeps its place; so this one is asked to end, and what dead servers of earlier tests have left is
/// removed.
class JackServer {
 public:
  /// False with a reason when JACK is not installed: skip the test then.
  static bool available(std::string& why_not);

  /// Starts a server with as many captured and played channels; it may need a while until it answers.
  /// `period`: frames that it works on at a time; more of them bear a busier machine.
  JackServer(int rate_hz, int channels, int played = 2, int period = 1024);
  ~JackServer();
  JackServer(const JackServer&) = delete;
  JackServer& operator=(const JackServer&) = delete;

  [[nodiscard]] bool running() { return server_->running(); }
  /// What it has said so far.
  [[nodiscard]] std::string log() const;

 private:
  TemporaryFolder folder_;
  std::unique_ptr<ScopedEnvironment> environment_;
  std::unique_ptr<ChildProcess> server_;
};

}  // namespace limbwave::test
