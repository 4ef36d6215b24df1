#include "acquire/box_ports.h"

#include <libserialport.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <memory>
#include <system_error>

#include "base/files.h"

namespace limbwave::acquire {
namespace {

constexpr std::string_view kCard = "portaudio:";
// The kernel cuts names of programs to fifteen letters.
constexpr std::string_view kEmulator = "limbwave-driver";

// A terminal that was an emulator's may be anybody's by now.
bool is_emulator(const std::string& process) {
  std::string name;
  return !process.empty() && std::ranges::all_of(process, [](unsigned char c) { return std::isdigit(c) != 0; }) &&
         std::getline(std::ifstream("/proc/" + process + "/comm"), name) && name == kEmulator;
}

DeviceInfo box_at(const std::string& port, const std::string& title) {
  DeviceInfo box;
  box.id = std::string(kBoxPrefix) + port;
  box.title = title;
  return box;
}

}  // namespace

std::string box_port(std::string_view id) {
  return std::string(id.starts_with(kBoxPrefix) ? id.substr(kBoxPrefix.size()) : id);
}

bool is_card_port(std::string_view port) {
  return port.starts_with(kCard);
}

std::filesystem::path emulator_folder() {
  return user_data_folder() / "emulators";
}

std::vector<DeviceInfo> list_box_ports() {
  std::vector<DeviceInfo> boxes;
  sp_port** ports = nullptr;
  if (sp_list_ports(&ports) == SP_OK) {
    for (sp_port** port = ports; *port != nullptr; ++port) {
      if (sp_get_port_transport(*port) == SP_TRANSPORT_USB) {
        const char* name = sp_get_port_name(*port);
        const char* what = sp_get_port_description(*port);
        boxes.push_back(
            box_at(name, std::string("Driver box on ") + name + (what != nullptr ? std::string(", ") + what : "")));
      }
    }
    sp_free_port_list(ports);
  }
  std::error_code code;
  std::vector<DeviceInfo> emulators;
  for (std::filesystem::directory_iterator entry(emulator_folder(), code), end; !code && entry != end;
       entry.increment(code)) {
    const std::string process = entry->path().filename().string();
    if (is_emulator(process)) {
      emulators.push_back(box_at(entry->path().string(), "Driver box emulator " + process));
    }
  }
  std::ranges::sort(emulators, {}, &DeviceInfo::id);
  boxes.insert(boxes.end(), emulators.begin(), emulators.end());
  return boxes;
}

std::vector<DeviceInfo> cards_as_boxes(const std::vector<DeviceInfo>& cards, int wires) {
  std::vector<DeviceInfo> boxes;
  for (const DeviceInfo& card : cards) {
    if (card.channels >= wires) {
      DeviceInfo box = box_at(card.id, card.title + " as a driver box");
      box.channels = card.channels;
      box.default_rate_hz = card.default_rate_hz;
      box.rates_hz = card.rates_hz;
      box.types = card.types;
      boxes.push_back(std::move(box));
    }
  }
  return boxes;
}

}  // namespace limbwave::acquire
