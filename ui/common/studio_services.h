/// What the studio asks of the core, as a table of functions: faces stay free of how it is done, and tests put their
/// own in. `core_services()` (common/core_services.h) is the real one. All may take long and run in jobs, unless said.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
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
  /// The marker that was set, with its number; empty when nothing is recorded.
  virtual std::optional<take::TakeEvent> mark(const std::string& text) = 0;
  /// Another state of a marker; false when nothing is recorded.
  virtual bool write_event(const take::TakeEvent& event) = 0;
  /// Tells a simulated wearer what a wizard asks for (acquire::LiveSource::ask).
  virtual void ask(const std::string& /*what*/) {}
  virtual void set_calibration(const calibrate::RigCalibration& calibration) = 0;
  virtual void set_headings(const std::vector<std::vector<solve::HeadingKey>>& headings) = 0;
  [[nodiscard]] virtual std::shared_ptr<const solve::LiveSnapshot> snapshot() const = 0;
  /// The newest pose; null before the first, and where a backend has no figures.
  [[nodiscard]] virtual std::shared_ptr<const solve::LiveFigure> figure() const { return nullptr; }
  /// `told` runs on any thread whenever there is a new `figure()`. Set before `start`.
  virtual void on_figure(std::function<void()> /*told*/) {}  // NOLINT(performance-unnecessary-value-param): is kept
};

/// How a device is to be opened; what is not said is the studio's choice for that device.
struct DeviceSetup {
  double rate_hz = 0.0;                     ///< 0: the rate nearest to 48 kHz that it offers.
  std::optional<acquire::SampleType> type;  ///< Empty: its best one up to 24 bit.
  int left = 0, right = 1;                  ///< Its inputs that become the left and the right channel, from 0.
  // Of a driver box.
  double temperature_c = 22.0, humidity = 50.0;  ///< Of the air, per cent: they make the speed of sound.
  double height_m = 0.0;                         ///< Of the wearer; 0: as the skeleton's file says.
  std::string ranging_take;   ///< Folder of a take with measured delays of the sources; empty: nominal.
  double figure_lag_s = 0.0;  ///< The live figure is smoothed by what comes so much later; 0: the newest pose.
  bool operator==(const DeviceSetup&) const = default;
};

/// A rig that can be chosen.
struct RigChoice {
  std::string name;         ///< What `load_rig` takes: "line-in-arm".
  std::string title;        ///< For people.
  bool driver_box = false;  ///< For a driver box; else for a sound card.
};

struct StudioServices {
  /// Everything that can be captured from, the simulator last.
  std::function<Result<std::vector<acquire::DeviceInfo>>()> list_devices;
  std::function<Result<std::unique_ptr<acquire::LiveSource>>(const std::string& id, const DeviceSetup& setup,
                                                             const std::string& rig)>
      open_device;
  /// Quick: only makes the object.
  std::function<std::unique_ptr<LiveBackend>(std::unique_ptr<acquire::LiveSource>, solve::LiveSettings)> make_live;
  /// A driver box (ids begin with acquire::kBoxPrefix) with everything behind it, ready to start.
  std::function<Result<std::unique_ptr<LiveBackend>>(const std::string& id, const DeviceSetup& setup,
                                                     solve::LiveSettings& settings)>
      open_box;
  std::function<std::vector<std::string>()> demo_motions;  ///< Quick. Of the simulator, the most telling first.
  std::function<std::vector<RigChoice>()> list_rigs;       ///< Quick.
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
