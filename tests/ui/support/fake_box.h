/// A driver box without hardware and without signal processing, for tests of its faces: what it says is the test's.
#pragma once

#include <QDir>
#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "common/live_model.h"
#include "solve/live_body_session.h"
#include "ui/support/fake_services.h"

namespace limbwave::ui::testing {

/// What the box says; changed under `mutex` at any time.
struct FakeBox {
  std::mutex mutex;
  solve::LiveBodySnapshot says;
  std::vector<DeviceSetup> setups;  ///< By which it was opened, in order.
  std::vector<std::string> ids;

  FakeBox() {
    const body::Rig rig = body::load_rig("driver-box-body").value();
    for (const body::Microphone& microphone : rig.microphones) {
      solve::BoxWire wire;
      wire.board = microphone.name;
      wire.level = 0.25;
      wire.locked = true;
      wire.frames = 1000;
      wire.words_hz = 140.0;
      wire.ranges_hz = 25.0;
      says.wires.push_back(wire);
    }
    says.title = "driver box 7";
    says.format = {SampleRate{140000.0}, 18, acquire::SampleType::kInt16};
    says.running = true;
  }
  template <typename Change>
  void change(Change with) {
    const std::scoped_lock lock(mutex);
    with(says);
  }
};

class FakeBoxBackend : public LiveBackend {
 public:
  explicit FakeBoxBackend(std::shared_ptr<FakeBox> box) : box_(std::move(box)) {}
  Status start() override { return {}; }
  void stop() override {}
  Status start_recording(const std::filesystem::path& folder, const std::string& /*subject*/) override {
    std::filesystem::create_directories(folder);
    folder_ = folder;
    since_s_ = steady_now_s();
    return {};
  }
  Result<take::Take> stop_recording() override {
    take::Take take;
    take.folder = folder_;
    take.info.kind = "driver-box";
    take.info.complete = true;
    take.info.rig = body::load_rig("driver-box-body").value();
    take.info.skeleton = body::load_skeleton(take.info.rig.skeleton).value();
    take.info.format = box_->says.format;
    take.info.frames = static_cast<std::int64_t>((steady_now_s() - since_s_) * 140000.0);
    since_s_ = 0.0;
    return take;
  }
  std::optional<take::TakeEvent> mark(const std::string& /*text*/) override { return std::nullopt; }
  bool write_event(const take::TakeEvent& /*event*/) override { return false; }
  void set_calibration(const calibrate::RigCalibration& /*calibration*/) override {}
  void set_headings(const std::vector<std::vector<solve::HeadingKey>>& /*headings*/) override {}
  [[nodiscard]] std::shared_ptr<const solve::LiveSnapshot> snapshot() const override {
    auto shot = std::make_shared<solve::LiveSnapshot>();
    const std::scoped_lock lock(box_->mutex);
    auto box = std::make_shared<solve::LiveBodySnapshot>(box_->says);
    box->version = shot->version = ++version_;
    shot->format = box->format;
    shot->recording = box->recording = since_s_ > 0.0;
    shot->recorded_s = box->recorded_s = shot->recording ? steady_now_s() - since_s_ : 0.0;
    shot->take_folder = folder_;
    shot->disk_left_s = 3600.0;
    shot->box = std::move(box);
    return shot;
  }

 private:
  std::shared_ptr<FakeBox> box_;
  mutable std::uint64_t version_ = 0;
  std::filesystem::path folder_;
  std::atomic<double> since_s_{0.0};
};

inline constexpr const char* kFakeBox = "driver-box:/dev/ttyFAKE0";

/// Those of `fake_services`, with a box beside the sound card.
inline StudioServices box_services(const std::shared_ptr<FakeBox>& box) {
  StudioServices services = fake_services(std::make_shared<FakeLine>());
  services.list_devices = [list = services.list_devices]() -> Result<std::vector<acquire::DeviceInfo>> {
    std::vector<acquire::DeviceInfo> devices = list().value();
    acquire::DeviceInfo info;
    info.id = kFakeBox;
    info.title = "Driver box at /dev/ttyFAKE0";
    devices.insert(devices.begin() + 1, info);
    return devices;
  };
  services.list_rigs = [] {
    return std::vector<RigChoice>{{"line-in-arm", "Arm with five accelerometers on a sound card"},
                                  {"driver-box-body", "Whole body on a driver box", true}};
  };
  services.load_rig = [](const std::string& name, const std::string&, const std::string&) {
    Result<solve::LiveSettings> settings = solve::LiveSettings();
    settings->rig = body::load_rig(name).value();
    settings->skeleton = body::load_skeleton(settings->rig.skeleton).value();
    return settings;
  };
  services.open_box = [box](const std::string& id, const DeviceSetup& setup,
                            solve::LiveSettings&) -> Result<std::unique_ptr<LiveBackend>> {
    const std::scoped_lock lock(box->mutex);
    box->ids.push_back(id);
    box->setups.push_back(setup);
    return std::unique_ptr<LiveBackend>(std::make_unique<FakeBoxBackend>(box));
  };
  return services;
}

}  // namespace limbwave::ui::testing
