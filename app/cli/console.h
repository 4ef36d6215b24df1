/// What all commands share: output, progress on a terminal, errors as one line, stopping by Ctrl-C.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "base/progress.h"
#include "base/result.h"

namespace limbwave::cli {

/// Thrown by `check` inside a command; main prints it as `limbwave: FILE: what is wrong; what to do` and exits with 1.
struct CommandFailed : std::runtime_error {
  explicit CommandFailed(const Error& error) : std::runtime_error(error.text()) {}
};

class Console {
 public:
  /// A progress bar on standard error when that is a terminal; Ctrl-C cancels the work.
  [[nodiscard]] Progress progress();
  /// What is happening, in place of a bar, for work whose end is not known; on standard error when that is a terminal.
  void status(std::string_view what);
  /// Removes the progress bar before other output.
  void end_progress();
  /// One line on standard output.
  void print(std::string_view line);
  /// A JSON document on standard output, or into a file when `file` is neither empty nor "-".
  void print_json(const nlohmann::json& json, const std::string& file = "-");
  /// Warnings and errors on standard error, one line each; information on standard output.
  void print(const Diagnostics& diagnostics);

  template <typename T>
  T check(Result<T> result) {
    if (!result) {
      end_progress();
      throw CommandFailed(result.error());
    }
    return std::move(result).value();
  }
  void check(const Status& status) {
    if (!status) {
      end_progress();
      throw CommandFailed(status.error());
    }
  }
  [[noreturn]] void fail(const Error& error) {
    end_progress();
    throw CommandFailed(error);
  }

  /// True once the user has pressed Ctrl-C or the program was asked to end.
  [[nodiscard]] static bool interrupted();
  /// Turns SIGINT and SIGTERM into `interrupted()`.
  static void catch_interrupts();

 private:
  bool bar_shown_ = false;
};

nlohmann::json diagnostics_to_json(const Diagnostics& diagnostics);

}  // namespace limbwave::cli
