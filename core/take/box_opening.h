/// A driver box by its port, and what is known of its sources: the same for every face.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "acquire/box_source.h"
#include "base/result.h"
#include "body/rig.h"
#include "calibrate/ranging_calibration.h"

namespace limbwave::take {

/// Opens a serial port, or a sound card that serves as a box (acquire/box_ports.h): that runs at `card_rate_hz`, 0 for
/// 192 kHz, and plays the sources of `rig`, which is set to that rate. Fails when the rig has no driver box, or as
/// acquire::DriverBox and acquire::open_card_box do.
Result<std::unique_ptr<acquire::BoxSource>> open_box(const std::string& port, double card_rate_hz, body::Rig& rig);

/// What a take of the same box knows of its sources: their delays, phases and levels, and the speed of sound of that
/// day. Fails when it cannot be opened, has only nominal values, or has other sources than the rig.
Result<calibrate::RangingCalibration> ranging_of(const std::filesystem::path& take_folder, const body::Rig& rig);

}  // namespace limbwave::take
