#include "console.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/files.h"

namespace limbwave::cli {
namespace {

volatile std::sig_atomic_t g_interrupted = 0;

void on_signal(int) {
  if (g_interrupted != 0) {
    ::_exit(130);  // asked twice: at once
  }
  g_interrupted = 1;
}

}  // namespace

bool Console::interrupted() {
  return g_interrupted != 0;
}

void Console::catch_interrupts() {
  struct sigaction action = {};
  action.sa_handler = on_signal;
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
}

Progress Console::progress() {
  const bool terminal = ::isatty(STDERR_FILENO) != 0;
  return Progress([this, terminal](double fraction, std::string_view what) {
    if (terminal) {
      constexpr int kWidth = 30;
      const int filled = std::clamp(static_cast<int>(fraction * kWidth), 0, kWidth);
      fmt::print(stderr, "\r\033[K[{:#<{}}{:.<{}}] {:3.0f} % {}", "", filled, "", kWidth - filled, 100.0 * fraction,
                 what);
      std::fflush(stderr);
      bar_shown_ = true;
    }
    return !interrupted();
  });
}

void Console::status(std::string_view what) {
  if (::isatty(STDERR_FILENO) != 0) {
    fmt::print(stderr, "\r\033[K{}", what);
    std::fflush(stderr);
    bar_shown_ = true;
  }
}

void Console::end_progress() {
  if (bar_shown_) {
    fmt::print(stderr, "\r\033[K");
    bar_shown_ = false;
  }
}

void Console::print(std::string_view line) {
  end_progress();
  fmt::print("{}\n", line);
}

void Console::print_json(const nlohmann::json& json, const std::string& file) {
  end_progress();
  const std::string text = json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  if (file.empty() || file == "-") {
    fmt::print("{}", text);
  } else {
    check(write_file(file, text));
  }
}

void Console::print(const Diagnostics& diagnostics) {
  end_progress();
  for (const Diagnostic& diagnostic : diagnostics) {
    fmt::print(diagnostic.severity == Severity::kInfo ? stdout : stderr, "  {}\n", diagnostic.text());
  }
}

nlohmann::json diagnostics_to_json(const Diagnostics& diagnostics) {
  nlohmann::json list = nlohmann::json::array();
  for (const Diagnostic& diagnostic : diagnostics) {
    nlohmann::json entry = {{"severity", name(diagnostic.severity)},
                            {"code", diagnostic.code},
                            {"message", diagnostic.message},
                            {"remedy", diagnostic.remedy},
                            {"place", diagnostic.place}};
    if (diagnostic.time_s >= 0.0) {
      entry["time_s"] = diagnostic.time_s;
    }
    list.push_back(std::move(entry));
  }
  return list;
}

}  // namespace limbwave::cli
