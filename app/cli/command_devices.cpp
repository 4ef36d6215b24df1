#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "acquire/box_ports.h"
#include "acquire/sound_card.h"
#include "commands.h"
#include "simulate/simulate.h"

namespace limbwave::cli {
namespace {

constexpr int kWires = 18;  // of the shipped rig

// Serial ports and emulators, and sound cards that are large enough.
std::vector<acquire::DeviceInfo> list_boxes(const std::vector<acquire::DeviceInfo>& cards) {
  std::vector<acquire::DeviceInfo> boxes = acquire::list_box_ports();
  const std::vector<acquire::DeviceInfo> large = acquire::cards_as_boxes(cards, kWires);
  boxes.insert(boxes.end(), large.begin(), large.end());
  return boxes;
}

}  // namespace

void add_devices(CLI::App& app, Console& console) {
  struct Options {
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("devices", "List what can be captured from");
  command->add_flag("--json", options->json, "As JSON");
  command->footer("Example: limbwave devices");
  command->callback([options, &console] {
    const std::vector<acquire::DeviceInfo> devices = console.check(acquire::list_devices());
    if (options->json) {
      nlohmann::json list = nlohmann::json::array();
      for (const acquire::DeviceInfo& device : devices) {
        nlohmann::json types = nlohmann::json::array();
        for (const acquire::SampleType type : device.types) {
          types.push_back(acquire::name(type));
        }
        list.push_back({{"id", device.id},
                        {"title", device.title},
                        {"channels", device.channels},
                        {"default", device.is_default},
                        {"default_rate_hz", device.default_rate_hz},
                        {"rates_hz", device.rates_hz},
                        {"types", types}});
      }
      nlohmann::json boxes = nlohmann::json::array();
      for (const acquire::DeviceInfo& box : list_boxes(devices)) {
        boxes.push_back({{"id", box.id}, {"title", box.title}, {"port", acquire::box_port(box.id)}});
      }
      console.print_json(
          {{"devices", list}, {"driver_boxes", boxes}, {"simulator_motions", simulate::builtin_motions()}});
      return;
    }
    if (devices.empty()) {
      console.print("no sound card with a stereo input was found; connect one, or record from the simulator:");
    }
    for (const acquire::DeviceInfo& device : devices) {
      std::string rates;
      for (const double rate : device.rates_hz) {
        rates += fmt::format("{}{:g}", rates.empty() ? "" : ", ", rate / 1000.0);
      }
      console.print(fmt::format("{}{}\n    {}, {} channels, {} kHz", device.id, device.is_default ? "  (default)" : "",
                                device.title, device.channels, rates.empty() ? "no usable rate" : rates));
    }
    for (const acquire::DeviceInfo& box : list_boxes(devices)) {
      console.print(fmt::format("{}\n    {}", box.id, box.title));
    }
    for (const std::string& motion : simulate::builtin_motions()) {
      console.print("simulator:" + motion);
    }
  });
}

}  // namespace limbwave::cli
