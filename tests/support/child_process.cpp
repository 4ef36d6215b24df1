#include "support/child_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace limbwave::test {

bool is_installed(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::filesystem::path file = std::filesystem::path(folder) / program;
    if (::access(file.c_str(), X_OK) == 0) {
      return true;
    }
  }
  return false;
}

ChildProcess::ChildProcess(const std::vector<std::string>& arguments,
                           const std::map<std::string, std::string>& environment, const std::filesystem::path& log) {
  std::vector<char*> argv;
  argv.reserve(arguments.size() + 1);
  for (const std::string& argument : arguments) {
    argv.push_back(const_cast<char*>(argument.c_str()));  // posix_spawn does not write to them
  }
  argv.push_back(nullptr);
  std::map<std::string, std::string> variables;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    const std::size_t equals = text.find('=');
    variables[text.substr(0, equals)] = equals == std::string::npos ? "" : text.substr(equals + 1);
  }
  for (const auto& [name, value] : environment) {
    variables[name] = value;
  }
  std::vector<std::string> lines;
  lines.reserve(variables.size());
  for (const auto& [name, value] : variables) {
    lines.push_back(name);
    lines.back().append("=").append(value);
  }
  std::vector<char*> envp;
  envp.reserve(lines.size() + 1);
  for (std::string& line : lines) {
    envp.push_back(line.data());
  }
  envp.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
  posix_spawn_file_actions_adddup2(&actions, 1, 2);
  const int error = ::posix_spawnp(&id_, argv[0], &actions, nullptr, argv.data(), envp.data());
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    throw std::runtime_error(arguments[0] + " cannot be started: " + std::strerror(error));
  }
}

ChildProcess::~ChildProcess() {
  kill();
}

void ChildProcess::note_end(int status) {
  ended_ = true;
  code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

bool ChildProcess::running() {
  int status = 0;
  if (!ended_ && ::waitpid(id_, &status, WNOHANG) == id_) {
    note_end(status);
  }
  return !ended_;
}

int ChildProcess::wait() {
  int status = 0;
  while (!ended_) {
    if (::waitpid(id_, &status, 0) == id_) {
      note_end(status);
    } else if (errno != EINTR) {
      break;
    }
  }
  return code_;
}

void ChildProcess::kill() {
  if (running()) {
    ::kill(id_, SIGKILL);
    wait();
  }
}

void ChildProcess::terminate() {
  constexpr int kTries = 1000;
  if (running()) {
    ::kill(id_, SIGTERM);
  }
  for (int i = 0; i < kTries && running(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  kill();
}

ScopedEnvironment::ScopedEnvironment(const std::map<std::string, std::string>& variables) {
  for (const auto& [name, value] : variables) {
    if (const char* old = std::getenv(name.c_str())) {
      before_[name] = old;
    } else {
      unset_.push_back(name);
    }
    ::setenv(name.c_str(), value.c_str(), 1);
  }
}

ScopedEnvironment::~ScopedEnvironment() {
  for (const auto& [name, value] : before_) {
    ::setenv(name.c_str(), value.c_str(), 1);
  }
  for (const std::string& name : unset_) {
    ::unsetenv(name.c_str());
  }
}

}  // namespace limbwave::test
