/// Runs the program that users run, in a folder and with a calibration library of its own.
#pragma once

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX wants it declared by its users

namespace limbwave::testing_support {

class CommandLine {
 public:
  struct Outcome {
    int status = -1;  ///< Exit status; 128 + signal when it was killed.
    std::string output, errors;
  };

  explicit CommandLine(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Environment variables beyond those of the test, "NAME=value".
  std::vector<std::string> environment;

  /// Standard output goes to `output` when that is given, and is then not in the outcome.
  [[nodiscard]] pid_t start(const std::vector<std::string>& arguments, const std::string& output = {}) const {
    std::vector<std::string> words{LIMBWAVE_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) {
      argv.push_back(word.data());
    }
    argv.push_back(nullptr);
    std::vector<std::string> variables{"LIMBWAVE_HOME=" + (folder_ / "home").string()};
    variables.insert(variables.end(), environment.begin(), environment.end());
    for (char** variable = environ; *variable != nullptr; ++variable) {
      if (std::string(*variable).rfind("LIMBWAVE_HOME=", 0) != 0) {
        variables.emplace_back(*variable);
      }
    }
    std::vector<char*> envp;
    for (std::string& variable : variables) {
      envp.push_back(variable.data());
    }
    envp.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, folder_.c_str());
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    const std::string output_path = output.empty() ? (folder_ / ".stdout").string() : output;
    posix_spawn_file_actions_addopen(&actions, 1, output_path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    posix_spawn_file_actions_addopen(&actions, 2, (folder_ / ".stderr").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    pid_t child = -1;
    if (posix_spawn(&child, LIMBWAVE_PROGRAM, &actions, nullptr, argv.data(), envp.data()) != 0) {
      child = -1;
    }
    posix_spawn_file_actions_destroy(&actions);
    return child;
  }

  [[nodiscard]] Outcome wait(pid_t child) const {
    Outcome outcome;
    int status = 0;
    if (child > 0 && ::waitpid(child, &status, 0) == child) {
      outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }
    outcome.output = text(folder_ / ".stdout");
    outcome.errors = text(folder_ / ".stderr");
    return outcome;
  }

  [[nodiscard]] Outcome run(const std::vector<std::string>& arguments, const std::string& output = {}) const {
    return wait(start(arguments, output));
  }

 private:
  static std::string text(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::ostringstream content;
    content << file.rdbuf();
    return content.str();
  }
  std::filesystem::path folder_;
};

}  // namespace limbwave::testing_support
