/// Where driver boxes may be found, and their ids among devices.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "acquire/live_source.h"

namespace limbwave::acquire {

/// Ids of driver boxes are this and a serial port, or the id of a sound card that serves as one.
inline constexpr std::string_view kBoxPrefix = "driver-box:";

/// What the id of a driver box says behind its prefix; other texts as they are.
std::string box_port(std::string_view id);
/// A port of that text is a sound card.
bool is_card_port(std::string_view port);

/// Folder where emulators keep a link to their terminal, named by their process id: user_data_folder()/emulators.
std::filesystem::path emulator_folder();

/// Serial ports over USB that are there now, and emulators that run; nobody is asked whether it is a driver box.
/// `channels` is 0: the box itself tells.
std::vector<DeviceInfo> list_box_ports();

/// Of `cards` (acquire/sound_card.h) those with enough inputs for this many wires, as driver boxes. Outputs are looked
/// at when one is opened.
std::vector<DeviceInfo> cards_as_boxes(const std::vector<DeviceInfo>& cards, int wires);

}  // namespace limbwave::acquire
