#include "acquire/alsa_probe.h"

#include <alsa/asoundlib.h>
#include <jack/jack.h>

#include <cstdarg>

namespace limbwave::acquire {
namespace {

// C callbacks of the two libraries.
extern "C" {
static void say_nothing_alsa(const char*, int, const char*, int, const char*, ...) {}
static void say_nothing_jack(const char*) {}
}

snd_pcm_format_t alsa_format(SampleType type) {
  switch (type) {
    case SampleType::kInt16:
      return SND_PCM_FORMAT_S16_LE;
    case SampleType::kInt24:
      return SND_PCM_FORMAT_S24_3LE;
    case SampleType::kInt32:
      return SND_PCM_FORMAT_S32_LE;
    case SampleType::kFloat32:
      return SND_PCM_FORMAT_FLOAT_LE;
  }
  return SND_PCM_FORMAT_UNKNOWN;
}

}  // namespace

void silence_sound_libraries() {
  snd_lib_error_set_handler(&say_nothing_alsa);
  jack_set_error_function(&say_nothing_jack);
  jack_set_info_function(&say_nothing_jack);
}

AlsaOffer probe_alsa(const std::string& pcm_name, int channels, const std::vector<double>& rates_hz) {
  AlsaOffer offer;
  snd_pcm_t* pcm = nullptr;
  if (snd_pcm_open(&pcm, pcm_name.c_str(), SND_PCM_STREAM_CAPTURE, SND_PCM_NONBLOCK) != 0) {
    return offer;
  }
  snd_pcm_hw_params_t* parameters = nullptr;
  if (snd_pcm_hw_params_malloc(&parameters) == 0 && snd_pcm_hw_params_any(pcm, parameters) >= 0) {
    unsigned most = 0;
    snd_pcm_hw_params_get_channels_max(parameters, &most);
    offer.channels = static_cast<int>(most);
    // Large interfaces have all their channels or none; PortAudio then picks the first ones.
    offer.answered =
        offer.channels > 0 && (snd_pcm_hw_params_set_channels(pcm, parameters, static_cast<unsigned>(channels)) == 0 ||
                               snd_pcm_hw_params_set_channels(pcm, parameters, most) == 0);
    // A card's own rates, not those that ALSA's plugins would resample to; it makes no difference for sound servers.
    snd_pcm_hw_params_set_rate_resample(pcm, parameters, 0);
    for (const double rate : rates_hz) {
      if (snd_pcm_hw_params_test_rate(pcm, parameters, static_cast<unsigned>(rate), 0) == 0) {
        offer.rates_hz.push_back(rate);
      }
    }
    for (const SampleType type : {SampleType::kInt16, SampleType::kInt24, SampleType::kInt32, SampleType::kFloat32}) {
      if (snd_pcm_hw_params_test_format(pcm, parameters, alsa_format(type)) == 0) {
        offer.types.push_back(type);
      }
    }
  }
  snd_pcm_hw_params_free(parameters);
  snd_pcm_close(pcm);
  return offer;
}

}  // namespace limbwave::acquire
