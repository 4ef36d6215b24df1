/// A driver box as the studio captures from it: the core's LiveBodySession behind the face of every capture.
#pragma once

#include <memory>
#include <string>

#include "common/studio_services.h"

namespace limbwave::ui {

/// Opens the serial port or sound card that the id names. `settings` has the rig and skeleton from `load_rig`; they are
/// scaled to the wearer, and set to the card's rate.
Result<std::unique_ptr<LiveBackend>> open_box_backend(const std::string& id, const DeviceSetup& setup,
                                                      solve::LiveSettings& settings);

}  // namespace limbwave::ui
