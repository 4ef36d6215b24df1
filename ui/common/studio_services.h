/// What the studio asks of the core, as a table of functions: faces stay free of how it is done, and tests put their
/// own in. `core_services()` (common/core_services.h) is the real one. All may take long and run in jobs, unless said.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "acquire/live_source.h"
#include "base/progress.h"
#include "base/result.h"
#include "body/rig.h"
#include "solve/live_session.h"
#include "take/take.h"

namespace limbwave::ui {

/// A running capture as faces see it: solve::LiveSession, or a test's own.
class LiveBackend {
 public:
  virtual ~LiveBackend() = default;
  virtual Status start() = 0;
  virtual void stop() = 0;
  virtual Status start_recording(const std::filesystem::path& folder, const std::string& subject) = 0;
  virtual Result<take::Take> stop_recording() = 0;
  virtual void mark(const std::string& text) = 0;
  virtual void set_calibration(const calibrate::RigCalibration& calibration) = 0;
  virtual void set_headings(const std::vector<std::vector<solve::HeadingKey>>& headings) = 0;
  [[nodiscard]] virtual std::shared_ptr<const solve::LiveSnapshot> snapshot() const = 0;
};

struct StudioServices {
  /// Everything that can be captured from, the simulator last.
  std::function<Result<std::vector<acquire::DeviceInfo>>()> list_devices;
  /// Rate 0 in `format` means the device's own.
  std::function<Result<std::unique_ptr<acquire::LiveSource>>(const std::string& id, const acquire::StreamFormat& format,
                                                             const std::string& rig)>
      open_device;
  /// Quick: only makes the object.
  std::function<std::unique_ptr<LiveBackend>(std::unique_ptr<acquire::LiveSource>, solve::LiveSettings)> make_live;
  std::function<std::vector<std::string>()> demo_motions;  ///< Quick. Of the simulator, the most telling first.
  std::function<std::vector<std::string>()> list_rigs;     ///< Quick. Names.
  /// Rig with the serials of the sensors on this device (empty: no device yet), its skeleton, and for each sensor what
  /// the calibration library has, else the data sheet's.
  std::function<Result<solve::LiveSettings>(const std::string& rig, const std::string& subject,
                                            const std::string& device)>
      load_rig;
  std::function<Result<take::Take>(const std::filesystem::path& folder)> open_take;
  std::function<Status(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& files,
                       const std::string& rig, const std::string& subject, const Progress&)>
      import_recording;
  std::function<Status(const std::filesystem::path& folder, const std::string& motion, const Progress&)> simulate_take;
};

}  // namespace limbwave::ui
