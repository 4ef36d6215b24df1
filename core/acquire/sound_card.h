/// Sound cards through PortAudio: ALSA (and PulseAudio or PipeWire through its `pulse` device) and JACK.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "acquire/live_source.h"
#include "acquire/sample_format.h"
#include "base/result.h"

namespace limbwave::acquire {

/// Devices with at least two capture channels, the default one first. An empty list is not an error. Takes up to a
/// second where many devices have to be asked; devices that came or went since the last call are noticed as long as no
/// source is open.
Result<std::vector<DeviceInfo>> list_devices();

/// PortAudio's number of a device of `list_devices`, or of "default". PortAudio runs, and the caller holds its lock
/// (portaudio_session.h). Fails when there is no such device.
Result<int> find_sound_device(const std::string& id);

/// Opens a device of `list_devices` for capture; "default" is the default one. The stream has exactly the wanted
/// format, with samples as the device gives them: nothing is dithered, clipped or resampled here. Fails when the device
/// is gone or busy or does not offer the format, naming what it offers.
Result<std::unique_ptr<LiveSource>> open_sound_card(const std::string& id, const StreamFormat& wanted);

}  // namespace limbwave::acquire
