/// What a sound card that serves as a driver box plays. Inside core/acquire only.
#pragma once

#include <cstdint>
#include <vector>

#include "acquire/driver_box_card.h"
#include "acquire/duplex_stream.h"

namespace limbwave::acquire {

/// One round of the schedule: every source's pulse at the start of its slots, and, when `marked`, the mark on the
/// output after the last source at the start of the round.
DuplexPlan card_plan(const CardBoxSettings& settings, const std::vector<std::uint8_t>& schedule, bool marked);

}  // namespace limbwave::acquire
