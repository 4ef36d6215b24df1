#include "take/box_opening.h"

#include <algorithm>
#include <utility>

#include "acquire/box_ports.h"
#include "acquire/driver_box.h"
#include "acquire/driver_box_card.h"
#include "take/driver_box_recording.h"
#include "take/take.h"

namespace limbwave::take {
namespace {

constexpr double kCardRate = 192000.0;
constexpr const char* kClient = "limbwave";  // among JACK's

}  // namespace

Result<std::unique_ptr<acquire::BoxSource>> open_box(const std::string& port, double card_rate_hz, body::Rig& rig) {
  if (!rig.driver_box) {
    return Error{"has no driver box", "rig \"" + rig.name + "\"", "use driver-box-body or another with a driver box"};
  }
  if (!acquire::is_card_port(port)) {
    auto box = acquire::DriverBox::open(port);
    if (!box) {
      return box.error();
    }
    return std::unique_ptr<acquire::BoxSource>(std::move(box).value());
  }
  rig = rig_at_rate(std::move(rig), card_rate_hz > 0.0 ? card_rate_hz : kCardRate);
  acquire::CardBoxSettings card;
  card.rate_hz = rig.driver_box->rate_hz;
  card.wires = static_cast<int>(rig.microphones.size());
  card.sources = static_cast<int>(rig.sources.size());
  card.slot_samples = rig.driver_box->slot_samples;
  card.pulse_hz = rig.driver_box->pulse_hz;
  card.pulse_cycles = rig.driver_box->pulse_cycles;
  card.client = kClient;
  return acquire::open_card_box(port, card);
}

Result<calibrate::RangingCalibration> ranging_of(const std::filesystem::path& take_folder, const body::Rig& rig) {
  Result<Take> take = open_take(take_folder);
  if (!take) {
    return take.error();
  }
  if (!take->info.ranging || take->info.ranging->sources.empty()) {
    return Error{"has no measured calibration of sources", take_folder.string(),
                 "name another take of this driver box"};
  }
  const auto& sources = take->info.ranging->sources;
  const bool same =
      std::ranges::equal(sources, rig.sources, [](const auto& a, const auto& b) { return a.name == b.name; });
  if (!same) {
    return Error{"has other sources than the rig \"" + rig.name + "\"", take_folder.string(),
                 "name a take of the same driver box and rig"};
  }
  return *take->info.ranging;
}

}  // namespace limbwave::take
