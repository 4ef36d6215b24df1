/// A real PulseAudio server of a test's own: a null sink to play into, and its monitor to capture from.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "support/child_process.h"
#include "support/temporary_folder.h"

namespace limbwave::test {

/// As long as it lives, this process's sound is the server's: ALSA's `pulse` and `default` devices capture what is
/// played. It has its own sockets, configuration and home folder and touches nothing of the user's.
class PulseServer {
 public:
  /// False with a reason when PulseAudio or ALSA's plugin for it is not installed: skip the test then.
  static bool available(std::string& why_not);

  /// Starts the server and waits until it answers; throws with its own words when it does not. `format` is the sink's:
  /// samples of the same type and rate go through bit by bit ("s16le", "s24le", "s32le", "float32le").
  explicit PulseServer(int rate_hz = 48000, const std::string& format = "s16le");
  ~PulseServer();
  PulseServer(const PulseServer&) = delete;
  PulseServer& operator=(const PulseServer&) = delete;

  /// For `open_sound_card`.
  [[nodiscard]] static std::string capture_id() { return "portaudio:ALSA:pulse"; }

  /// Starts playing a recording in real time; the end of the process is the end of the playing. Silence is played for
  /// `silence_s` before it and after it: a null sink swallows the first 10 ms or so of a stream that begins.
  std::unique_ptr<ChildProcess> play(const std::filesystem::path& recording, double silence_s = 0.5);

  /// The end of the server, as by a crash.
  void stop();

 private:
  [[nodiscard]] std::map<std::string, std::string> environment() const;
  [[nodiscard]] bool answers() const;

  TemporaryFolder folder_;
  std::unique_ptr<ScopedEnvironment> environment_;
  std::unique_ptr<ChildProcess> server_;
  int played_ = 0;
};

}  // namespace limbwave::test
