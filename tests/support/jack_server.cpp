#include "support/jack_server.h"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

namespace limbwave::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNamePrefix = "limbwave-test-";
const fs::path kSharedMemory = "/dev/shm";

bool is_number(const std::string& text) {
  return !text.empty() && std::ranges::all_of(text, [](unsigned char c) { return std::isdigit(c) != 0; });
}

// Whether any JACK server runs on this machine, whosoever it is.
bool some_server_runs() {
  std::error_code error;
  for (fs::directory_iterator entry("/proc", error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    std::string name;
    if (is_number(entry->path().filename()) && std::getline(std::ifstream(entry->path() / "comm"), name) &&
        (name == "jackd" || name == "jackdbus")) {
      return true;
    }
  }
  return false;
}

// Without a running server, JACK's registry only lists dead ones; JACK makes a new one. The other files are ours.
void remove_leftovers() {
  if (some_server_runs()) {
    return;
  }
  std::error_code error;
  std::vector<fs::path> leftovers{kSharedMemory / "jack-shm-registry"};
  for (fs::directory_iterator entry(kSharedMemory, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    const std::string name = entry->path().filename();
    if (name.starts_with("jack") && name.find(kNamePrefix) != std::string::npos) {
      leftovers.push_back(entry->path());
    }
  }
  for (const fs::path& leftover : leftovers) {
    fs::remove(leftover, error);
  }
}

}  // namespace

bool JackServer::available(std::string& why_not) {
  if (!is_installed("jackd")) {
    why_not = "jackd is not installed";
    return false;
  }
  return true;
}

JackServer::JackServer(int rate_hz, int channels, int played, int period) {
  remove_leftovers();
  const std::string name = kNamePrefix + std::to_string(::getpid());
  environment_ = std::make_unique<ScopedEnvironment>(
      std::map<std::string, std::string>{{"JACK_DEFAULT_SERVER", name}, {"JACK_NO_AUDIO_RESERVATION", "1"}});
  server_ = std::make_unique<ChildProcess>(
      std::vector<std::string>{"jackd", "-n", name, "-r", "-d", "dummy", "-r", std::to_string(rate_hz), "-p",
                               std::to_string(period), "-C", std::to_string(channels), "-P", std::to_string(played)},
      std::map<std::string, std::string>{}, folder_ / "jack.log");
}

JackServer::~JackServer() {
  server_->terminate();
}

std::string JackServer::log() const {
  std::ostringstream text;
  text << std::ifstream(folder_ / "jack.log").rdbuf();
  return text.str();
}

}  // namespace limbwave::test
