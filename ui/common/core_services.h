/// The services of the studio over the real core.
#pragma once

#include "common/studio_services.h"

namespace limbwave::ui {

StudioServices core_services();

/// The simulator's motions as devices: "simulator:wave".
inline constexpr const char* kSimulatorPrefix = "simulator:";

}  // namespace limbwave::ui
