#include "support/pulse_server.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <stdexcept>
#include <thread>
#include <vector>

#include "acquire/recording_file.h"
#include "acquire/wav_writer.h"
#include "support/audio_files.h"

namespace limbwave::test {
namespace fs = std::filesystem;
namespace {

// Debian's and Ubuntu's own configuration, and then PulseAudio for everything that asks for the default.
constexpr const char* kAlsaConfiguration =
    "</usr/share/alsa/alsa.conf>\n"
    "pcm.!default { type pulse }\n"
    "ctl.!default { type pulse }\n";

constexpr auto kStartLimit = std::chrono::seconds(30);

template <typename T>
T checked(Result<T> result) {
  if (!result) {
    throw std::runtime_error(result.error().text());
  }
  return *std::move(result);
}

void checked(const Status& status) {
  if (!status) {
    throw std::runtime_error(status.error().text());
  }
}

// A copy of a recording between two stretches of silence.
void write_with_silence(const fs::path& from, const fs::path& to, double silence_s) {
  acquire::RecordingFile in = checked(acquire::RecordingFile::open(from));
  const std::unique_ptr<acquire::WavWriter> out = checked(acquire::WavWriter::create(to, in.format()));
  const auto frames = static_cast<std::size_t>(silence_s * in.format().rate.hz);
  const std::vector<std::byte> silence(frames * in.format().bytes_per_frame());
  std::vector<std::byte> block(std::size_t{65536} * in.format().bytes_per_frame());
  checked(out->write(silence));
  while (const std::size_t got = checked(in.read(block))) {
    checked(out->write(std::span(block).first(got)));
  }
  checked(out->write(silence));
  checked(out->close());
}

}  // namespace

bool PulseServer::available(std::string& why_not) {
  for (const char* program : {"pulseaudio", "paplay"}) {
    if (!is_installed(program)) {
      why_not = std::string(program) + " is not installed";
      return false;
    }
  }
  if (!fs::exists("/usr/share/alsa/alsa.conf")) {
    why_not = "ALSA's configuration (libasound2-data) is not installed";
    return false;
  }
  return true;
}

PulseServer::PulseServer(int rate_hz, const std::string& format) {
  fs::create_directory(folder_ / "run");
  fs::permissions(folder_ / "run", fs::perms::owner_all);  // the server refuses a folder that others may enter
  fs::create_directory(folder_ / "home");
  write_bytes(folder_ / "asound.conf", kAlsaConfiguration);
  environment_ = std::make_unique<ScopedEnvironment>(environment());
  const std::string sink =
      "module-null-sink sink_name=loop channels=2 rate=" + std::to_string(rate_hz) + " format=" + format;
  server_ = std::make_unique<ChildProcess>(
      std::vector<std::string>{"pulseaudio", "-n", "--daemonize=no", "--disable-shm=yes", "--exit-idle-time=-1", "-L",
                               "module-native-protocol-unix", "-L", sink},
      environment(), folder_ / "server.log");
  const auto limit = std::chrono::steady_clock::now() + kStartLimit;
  while (!answers()) {
    if (!server_->running() || std::chrono::steady_clock::now() > limit) {
      throw std::runtime_error("PulseAudio does not start:\n" + read_bytes(folder_ / "server.log"));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

PulseServer::~PulseServer() = default;

std::map<std::string, std::string> PulseServer::environment() const {
  return {{"XDG_RUNTIME_DIR", folder_ / "run"},
          {"HOME", folder_ / "home"},
          {"XDG_CONFIG_HOME", folder_ / "home/.config"},
          {"ALSA_CONFIG_PATH", folder_ / "asound.conf"},
          {"PULSE_SERVER", "unix:" + (folder_ / "run/pulse/native").string()},
          {"PULSE_SOURCE", "loop.monitor"}};
}

bool PulseServer::answers() const {
  const std::string path = folder_ / "run/pulse/native";
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) {
    throw std::runtime_error(path + " is too long for the name of a socket");
  }
  std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  const int connection = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const bool connected = ::connect(connection, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  ::close(connection);
  return connected;
}

std::unique_ptr<ChildProcess> PulseServer::play(const fs::path& recording, double silence_s) {
  const fs::path padded = folder_ / ("play" + std::to_string(++played_) + ".wav");
  write_with_silence(recording, padded, silence_s);
  // Two seconds wait in the server, so that a player that is held up by a busy machine does not leave a hole.
  return std::make_unique<ChildProcess>(
      std::vector<std::string>{"paplay", "--device=loop", "--latency-msec=2000", padded}, environment(),
      folder_ / "play.log");
}

void PulseServer::stop() {
  server_->kill();
}

}  // namespace limbwave::test
