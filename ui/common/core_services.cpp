#include "common/core_services.h"

#include <QCoreApplication>
#include <algorithm>
#include <filesystem>

#include "acquire/box_ports.h"
#include "acquire/channel_pair.h"
#include "acquire/sound_card.h"
#include "body/rig.h"
#include "body/skeleton.h"
#include "common/box_backend.h"
#include "common/motion_names.h"
#include "simulate/simulate.h"
#include "solve/live_session.h"
#include "solve/take_calibration.h"
#include "take/board_book.h"
#include "take/import.h"

namespace limbwave::ui {
namespace {

/// lupdate knows this as the context "CoreServices".
struct CoreServices {
  Q_DECLARE_TR_FUNCTIONS(CoreServices)
};

constexpr double kSimulatorRate = 48000.0;
constexpr int kBoxWires = 18;  // of the shipped rig

class SessionBackend : public LiveBackend {
 public:
  SessionBackend(std::unique_ptr<acquire::LiveSource> source, solve::LiveSettings settings)
      : session_(std::move(source), std::move(settings)) {}
  Status start() override { return session_.start(); }
  void stop() override { session_.stop(); }
  Status start_recording(const std::filesystem::path& folder, const std::string& subject) override {
    return session_.start_recording(folder, subject);
  }
  Result<take::Take> stop_recording() override { return session_.stop_recording(); }
  std::optional<take::TakeEvent> mark(const std::string& text) override { return session_.mark(text); }
  bool write_event(const take::TakeEvent& event) override { return session_.write_event(event); }
  void ask(const std::string& what) override { session_.ask(what); }
  void set_calibration(const calibrate::RigCalibration& calibration) override { session_.set_calibration(calibration); }
  void set_headings(const std::vector<std::vector<solve::HeadingKey>>& headings) override {
    session_.set_headings(headings);
  }
  [[nodiscard]] std::shared_ptr<const solve::LiveSnapshot> snapshot() const override { return session_.snapshot(); }
  [[nodiscard]] std::shared_ptr<const solve::LiveFigure> figure() const override { return session_.figure(); }
  void on_figure(std::function<void()> told) override { session_.on_figure(std::move(told)); }

 private:
  solve::LiveSession session_;
};

std::string simulator_title(const std::string& motion) {
  return CoreServices::tr("Simulator: %1").arg(motion_title(QString::fromStdString(motion))).toStdString();
}

/// In the user's language; the core's own titles are English.
std::string box_title(const acquire::DeviceInfo& box, const std::vector<acquire::DeviceInfo>& cards) {
  const std::string port = acquire::box_port(box.id);
  for (const acquire::DeviceInfo& card : cards) {
    if (card.id == port) {
      return CoreServices::tr("%1 as a driver box").arg(QString::fromStdString(card.title)).toStdString();
    }
  }
  const std::filesystem::path path(port);
  if (path.parent_path() == acquire::emulator_folder()) {
    return CoreServices::tr("Driver box emulator %1")
        .arg(QString::fromStdString(path.filename().string()))
        .toStdString();
  }
  return CoreServices::tr("Driver box at %1").arg(QString::fromStdString(port)).toStdString();
}

/// The simulator's motions, the most telling first; still poses are for measuring and show nothing.
std::vector<std::string> demo_motions() {
  std::vector<std::string> motions = simulate::builtin_motions();
  std::erase(motions, "still");
  static const std::vector<std::string> first{"reach", "wave", "walk", "box", "arm-raise"};
  const auto rank = [](const std::string& motion) {
    return std::find(first.begin(), first.end(), motion) - first.begin();
  };
  std::stable_sort(motions.begin(), motions.end(),
                   [&rank](const std::string& a, const std::string& b) { return rank(a) < rank(b); });
  return motions;
}

Result<std::vector<acquire::DeviceInfo>> list_all_devices() {
  auto devices = acquire::list_devices();
  if (!devices) {
    return devices;
  }
  std::vector<acquire::DeviceInfo> all = std::move(devices).value();
  std::vector<acquire::DeviceInfo> boxes = acquire::list_box_ports();
  const std::vector<acquire::DeviceInfo> cards = acquire::cards_as_boxes(all, kBoxWires);
  boxes.insert(boxes.end(), cards.begin(), cards.end());
  for (acquire::DeviceInfo& box : boxes) {
    box.title = box_title(box, all);
  }
  all.insert(all.end(), boxes.begin(), boxes.end());
  for (const std::string& motion : demo_motions()) {
    acquire::DeviceInfo simulator;
    simulator.id = kSimulatorPrefix + motion;
    simulator.title = simulator_title(motion);
    simulator.channels = 2;
    simulator.default_rate_hz = kSimulatorRate;
    simulator.rates_hz = {44100.0, kSimulatorRate, 88200.0, 96000.0, 176400.0, 192000.0};
    simulator.types = {acquire::SampleType::kInt16, acquire::SampleType::kInt24, acquire::SampleType::kInt32,
                       acquire::SampleType::kFloat32};
    all.push_back(std::move(simulator));
  }
  return all;
}

Result<simulate::SimulateSettings> simulator_settings(const std::string& motion) {
  simulate::SimulateSettings settings;
  settings.motion = motion;
  settings.errors_name = "paper";
  auto errors = simulate::load_errors(settings.errors_name);
  if (!errors) {
    return errors.error();
  }
  settings.errors = errors.value();
  settings.format.rate = SampleRate{kSimulatorRate};
  return settings;
}

/// What the setup leaves open: the rate closest to 48 kHz that the device takes, and its best sample type up to 24 bit;
/// more is noise.
acquire::StreamFormat choose_format(const std::string& id, const DeviceSetup& setup) {
  acquire::StreamFormat format{SampleRate{setup.rate_hz > 0.0 ? setup.rate_hz : 48000.0},
                               std::max({2, setup.left + 1, setup.right + 1}),
                               setup.type.value_or(acquire::SampleType::kInt16)};
  if (setup.rate_hz > 0.0 && setup.type) {
    return format;
  }
  const auto devices = acquire::list_devices();
  if (!devices) {
    return format;
  }
  for (const acquire::DeviceInfo& device : devices.value()) {
    if (device.id != id) {
      continue;
    }
    const auto nearest = std::min_element(device.rates_hz.begin(), device.rates_hz.end(), [](double a, double b) {
      return std::abs(a - 48000.0) < std::abs(b - 48000.0);
    });
    if (setup.rate_hz <= 0.0 && nearest != device.rates_hz.end()) {
      format.rate.hz = *nearest;
    }
    for (const auto type : {acquire::SampleType::kInt24, acquire::SampleType::kInt16, acquire::SampleType::kInt32,
                            acquire::SampleType::kFloat32}) {
      if (!setup.type && std::find(device.types.begin(), device.types.end(), type) != device.types.end()) {
        format.type = type;
        break;
      }
    }
  }
  return format;
}

Result<std::unique_ptr<acquire::LiveSource>> open_any_device(const std::string& id, const DeviceSetup& setup,
                                                             const std::string& rig) {
  const std::string prefix = kSimulatorPrefix;
  if (id.rfind(prefix, 0) != 0) {
    auto card = acquire::open_sound_card(id, choose_format(id, setup));
    return card ? acquire::pick_channels(std::move(card).value(), setup.left, setup.right) : std::move(card);
  }
  auto settings = simulator_settings(id.substr(prefix.size()));
  if (!settings) {
    return settings.error();
  }
  settings->rig = rig;
  // The take's own calibration poses are for demo takes; a live device moves at once.
  settings->prologue = false;
  settings->obliging = true;  // nobody else could do what wizards ask for
  if (setup.rate_hz > 0.0) {
    settings->format.rate.hz = setup.rate_hz;
  }
  settings->format.type = setup.type.value_or(settings->format.type);
  return simulate::open_simulator(settings.value());
}

/// Shipped rigs for sound cards and driver boxes by title. One that cannot be read is named by its file, so that
/// choosing it tells why.
std::vector<RigChoice> list_rigs() {
  std::vector<RigChoice> rigs;
  for (const std::string& name : body::shipped_rigs()) {
    const auto rig = body::load_rig(name);
    if (rig && !rig->has_line_in && !rig->driver_box) {
      continue;  // nothing that could be captured
    }
    rigs.push_back({name, rig && !rig->title.empty() ? rig->title : name, rig && !rig->has_line_in});
  }
  return rigs;
}

Result<solve::LiveSettings> load_rig_for(const std::string& rig, const std::string& subject,
                                         const std::string& device) {
  auto loaded = body::load_rig(rig);
  if (!loaded) {
    return loaded.error();
  }
  solve::LiveSettings settings;
  settings.rig = device.starts_with(kSimulatorPrefix)
                     ? simulate::simulated_rig(std::move(loaded).value(), simulate::SimulateSettings().seed)
                     : take::rig_on_device(std::move(loaded).value(), device);
  auto skeleton = body::load_skeleton(settings.rig.skeleton);
  if (!skeleton) {
    return skeleton.error();
  }
  settings.skeleton = std::move(skeleton).value();
  settings.calibration = solve::calibration_for_recording(settings.rig, subject).calibration;
  return settings;
}

}  // namespace

StudioServices core_services() {
  StudioServices services;
  services.list_devices = list_all_devices;
  services.open_device = open_any_device;
  services.make_live = [](std::unique_ptr<acquire::LiveSource> source, solve::LiveSettings settings) {
    return std::unique_ptr<LiveBackend>(std::make_unique<SessionBackend>(std::move(source), std::move(settings)));
  };
  services.open_box = open_box_backend;
  services.demo_motions = demo_motions;
  services.list_rigs = list_rigs;
  services.load_rig = load_rig_for;
  services.open_take = [](const std::filesystem::path& folder) { return take::open_take(folder); };
  services.import_recording = [](const std::filesystem::path& folder, const std::vector<std::filesystem::path>& files,
                                 const std::string& rig, const std::string& subject,
                                 const Progress& progress) -> Status {
    auto loaded = body::load_rig(rig);
    if (!loaded) {
      return loaded.error();
    }
    auto take = take::import_recordings(folder, files, loaded.value(), progress, subject);
    return take ? Status() : Status(take.error());
  };
  services.simulate_take = [](const std::filesystem::path& folder, const std::string& motion,
                              const Progress& progress) -> Status {
    auto settings = simulator_settings(motion);
    if (!settings) {
      return settings.error();
    }
    return simulate::simulate_take(folder, settings.value(), progress);
  };
  return services;
}

}  // namespace limbwave::ui
