/// A program that a test runs, ended with the test by its process id.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace limbwave::test {

/// Whether a program can be found on the PATH.
bool is_installed(const std::string& program);

class ChildProcess {
 public:
  /// Starts `arguments[0]` (found on the PATH) with the present environment changed by `environment`; what it says goes
  /// to the file `log`. Throws when it cannot be started.
  ChildProcess(const std::vector<std::string>& arguments, const std::map<std::string, std::string>& environment,
               const std::filesystem::path& log);
  ~ChildProcess();  ///< Kills it if it is still running.
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  [[nodiscard]] pid_t id() const { return id_; }
  /// True as long as it has not ended.
  bool running();
  /// Waits for its end and returns its exit code, 128 + signal when a signal ended it.
  int wait();
  /// Kills it and waits for its end.
  void kill();
  /// Asks it to end and waits for that, some seconds at most: then it is killed. For programs that clean up.
  void terminate();

 private:
  void note_end(int status);
  pid_t id_ = -1;
  bool ended_ = false;
  int code_ = 0;
};

/// Sets environment variables of this process and puts the old ones back.
class ScopedEnvironment {
 public:
  explicit ScopedEnvironment(const std::map<std::string, std::string>& variables);
  ~ScopedEnvironment();
  ScopedEnvironment(const ScopedEnvironment&) = delete;
  ScopedEnvironment& operator=(const ScopedEnvironment&) = delete;

 private:
  std::map<std::string, std::string> before_;
  std::vector<std::string> unset_;
};

}  // namespace limbwave::test
