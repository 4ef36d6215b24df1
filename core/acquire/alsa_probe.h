/// What an ALSA device offers by itself. PortAudio cannot tell: it says yes to whatever it could convert.
#pragma once

#include <string>
#include <vector>

#include "acquire/sample_format.h"

namespace limbwave::acquire {

struct AlsaOffer {
  bool answered = false;  ///< False when the device could not be asked (busy, gone).
  int channels = 0;       ///< At most.
  std::vector<double> rates_hz;
  std::vector<SampleType> types;
};

/// Asks a capture device ("pulse", "hw:0,0") for each of the rates and all sample types in `channels` channels.
AlsaOffer probe_alsa(const std::string& pcm_name, int channels, const std::vector<double>& rates_hz);

/// From now on ALSA and JACK report through return values alone, and write nothing to the terminal.
void silence_sound_libraries();

}  // namespace limbwave::acquire
