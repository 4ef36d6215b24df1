/// A sound card of many channels as a driver box: microphones on its inputs, ultrasonic sources on its outputs.
#pragma once

#include <memory>
#include <string>

#include "acquire/box_source.h"

namespace limbwave::acquire {

/// Inputs 1, 2, ... are the wires, outputs 1, 2, ... the sources, in their order. A cable from the output after the
/// last source to the input after the last wire carries the mark of every round of slots; without it, what the card
/// says about its own delays has to do.
struct CardBoxSettings {
  double rate_hz = 192000.0;
  int wires = 18;
  int sources = 8;
  int slot_samples = 1536;  ///< 8 ms.
  double pulse_hz = 40000.0;
  int pulse_cycles = 10;
  float level = 0.8F;       ///< Of pulses and marks, fraction of full scale.
  double patience_s = 3.0;  ///< How long the mark is waited for.
  double backlog_s = 8.0;   ///< What is kept for a consumer that is late.
  std::string client;       ///< Name among JACK's clients; empty: PortAudio's own.
};

/// Opens a device of `list_devices` (acquire/sound_card.h) for capture and playback at once. Its samples are float32 as
/// the card gives them. Sample 0 is the one at which the first source began to radiate, as the card's own loop shows
/// it; played and captured samples stay together from then on: frames that the card lost are gaps of known length, and
/// where the mark shows that outputs and inputs came apart, they are put together again and an event says so. Fails
/// when the device is gone or busy or has too few channels.
Result<std::unique_ptr<BoxSource>> open_card_box(const std::string& id, const CardBoxSettings& settings);

}  // namespace limbwave::acquire
