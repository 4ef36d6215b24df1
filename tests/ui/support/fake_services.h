/// Services for tests without hardware and without signal processing: a made-up line whose every trouble is switchable,
/// takes that are real folders on disk.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "common/studio_services.h"

namespace limbwave::ui::testing {

/// What the made-up line does; may be changed at any time by the test.
struct FakeLine {
  double level = 0.4;  ///< Peak of the left channel, fraction of full scale.
  bool locked = true;
  bool swapped = false;
  bool alive = true;
  int dead_sensor = -1;  ///< This one sends nothing.
  int clipping_sensor = -1;
  double disk_left_s = 23 * 3600.0;
  std::uint64_t overflows = 0;
  Diagnostics diagnostics;      ///< Findings of the decoder; their time is set to now.
  bool fail_open = false;       ///< The device refuses to open.
  bool fail_recording = false;  ///< The folder cannot be made.
  bool no_devices = false;
  bool exclusive = false;  ///< The device can be opened once at a time.
  int slow_close_ms = 0;
  std::atomic<bool> ended_in_gui_thread = false;
  std::atomic<int> open_now = 0;
  std::vector<take::TakeEvent> events;  ///< Lines written into the running recording: markers and their changes.
  int opened = 0;                       ///< How often a device was opened.
  DeviceSetup setup;                    ///< How it was opened last.
  /// By wearer: the date of the mountings that the library has. Others have none.
  std::map<std::string, std::string> mounted;
};

/// A rig of five sensors without files.
solve::LiveSettings fake_rig();

/// The services over `line`.
StudioServices fake_services(const std::shared_ptr<FakeLine>& line);

}  // namespace limbwave::ui::testing
