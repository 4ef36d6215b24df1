/// PortAudio is started when a list or a stream needs it and ended with the last of them, so that devices that came or
/// went are seen the next time. Inside core/acquire only.
#pragma once

#include <memory>
#include <mutex>

#include "base/result.h"

namespace limbwave::acquire {

/// PortAudio is not thread-safe: whoever calls it holds this.
std::recursive_mutex& portaudio_lock();

class PortAudioSession {
 public:
  static Result<std::unique_ptr<PortAudioSession>> start();
  ~PortAudioSession();
  PortAudioSession(const PortAudioSession&) = delete;
  PortAudioSession& operator=(const PortAudioSession&) = delete;

 private:
  PortAudioSession() = default;
};

}  // namespace limbwave::acquire
