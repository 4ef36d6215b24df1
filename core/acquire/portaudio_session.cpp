#include "acquire/portaudio_session.h"

#include <portaudio.h>

#include <string>

#include "acquire/alsa_probe.h"

namespace limbwave::acquire {

std::recursive_mutex& portaudio_lock() {
  static std::recursive_mutex lock;
  return lock;
}

Result<std::unique_ptr<PortAudioSession>> PortAudioSession::start() {
  const std::lock_guard guard(portaudio_lock());
  silence_sound_libraries();
  const PaError error = Pa_Initialize();  // counts its users itself
  if (error != paNoError) {
    return Error{std::string("sound cannot be used (") + Pa_GetErrorText(error) + ")", "sound card",
                 "check that sound works in other programs"};
  }
  silence_sound_libraries();  // PortAudio sets a handler of its own while it looks for JACK
  return std::unique_ptr<PortAudioSession>(new PortAudioSession);
}

PortAudioSession::~PortAudioSession() {
  const std::lock_guard guard(portaudio_lock());
  Pa_Terminate();
}

}  // namespace limbwave::acquire
