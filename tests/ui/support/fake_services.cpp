#include "ui/support/fake_services.h"

#include <QCoreApplication>
#include <QThread>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <thread>

#include "base/progress.h"
#include "common/live_model.h"
#include "take/markers.h"

namespace limbwave::ui::testing {
namespace {

constexpr double kRate = 48000.0, kCycle = 61.7;
constexpr int kSlots = 16;

class FakeSource : public acquire::LiveSource {
 public:
  [[nodiscard]] acquire::StreamFormat format() const override {
    return {SampleRate{kRate}, 2, acquire::SampleType::kInt16};
  }
  [[nodiscard]] std::string title() const override { return "made-up line"; }
  Status start() override { return {}; }
  void stop() override {}
  std::size_t pull(std::span<std::byte>) override { return 0; }
  [[nodiscard]] acquire::SourceCounters counters() const override { return {}; }
  [[nodiscard]] bool alive() const override { return true; }
  [[nodiscard]] double device_latency_s() const override { return 0.02; }
  [[nodiscard]] double newest_frame_time_s() const override { return 0.0; }
};

/// What sensor s feels along axis a at time t, m/s²: gravity turning slowly, and a wave.
double acceleration(int s, int a, double t) {
  const double turn = 0.4 * t + 0.5 * s + 2.1 * a;
  return 9.81 * std::sin(turn) * (a == 1 ? 0.6 : 0.8) + 1.5 * std::sin(9.0 * t + s);
}

class FakeBackend : public LiveBackend {
 public:
  FakeBackend(std::shared_ptr<FakeLine> line, solve::LiveSettings settings)
      : line_(std::move(line)), settings_(std::move(settings)), begin_(steady_now_s()) {}
  ~FakeBackend() override {
    // What is left over at the very end may be ended there.
    if (QCoreApplication::instance() != nullptr && !QCoreApplication::closingDown() &&
        QThread::currentThread() == QCoreApplication::instance()->thread()) {
      line_->ended_in_gui_thread = true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(line_->slow_close_ms));
    --line_->open_now;
  }

  Status start() override { return {}; }
  void stop() override {}

  Status start_recording(const std::filesystem::path& folder, const std::string& subject) override {
    if (line_->fail_recording) {
      return Error{"no space left on the device", folder.string(), "choose another folder"};
    }
    std::filesystem::create_directories(folder);
    line_->events.clear();
    folder_ = folder;
    subject_ = subject;
    recording_since_ = steady_now_s();
    return {};
  }

  Result<take::Take> stop_recording() override {
    take::Take take;
    take.folder = folder_;
    take.info.subject = subject_;
    take.info.source = "made-up line";
    take.info.complete = true;
    take.info.format = FakeSource().format();
    take.info.frames = static_cast<std::int64_t>((steady_now_s() - recording_since_) * kRate);
    take.info.rig = settings_.rig;
    take.info.calibration = settings_.calibration;
    take.events = take::events_in_force(line_->events);
    for (const take::TakeEvent& event : line_->events) {
      (void)take::append_event(folder_, event);
    }
    recording_since_ = 0.0;
    return take;
  }

  std::optional<take::TakeEvent> mark(const std::string& text) override {
    const auto sample = static_cast<std::int64_t>((steady_now_s() - recording_since_) * kRate);
    line_->events.push_back({SampleIndex{sample}, take::kMarker, text, take::free_marker_number(line_->events)});
    return line_->events.back();
  }
  bool write_event(const take::TakeEvent& event) override {
    line_->events.push_back(event);
    return recording_since_ > 0.0;
  }
  void set_calibration(const calibrate::RigCalibration& calibration) override { settings_.calibration = calibration; }
  void set_headings(const std::vector<std::vector<solve::HeadingKey>>&) override {}

  [[nodiscard]] std::shared_ptr<const solve::LiveSnapshot> snapshot() const override {
    auto shot = std::make_shared<solve::LiveSnapshot>();
    shot->version = ++version_;
    const double now = steady_now_s() - begin_ + 12.0;  // As if it had been on for a while.
    shot->stream_time_s = now;
    shot->format = FakeSource().format();
    fill_line(*shot);
    fill_scope(*shot, now);
    fill_frames(*shot, now);
    fill_health(*shot);
    shot->diagnostics = line_->diagnostics;
    for (Diagnostic& finding : shot->diagnostics) {
      finding.time_s = now;
    }
    shot->counters.overflows = line_->overflows;
    dead_ = dead_ || !line_->alive;  // What was unplugged does not come back by itself.
    shot->source_alive = !dead_;
    shot->recording = recording_since_ > 0.0;
    shot->take_folder = folder_;
    shot->recorded_s = shot->recording ? steady_now_s() - recording_since_ : 0.0;
    shot->disk_left_s = line_->disk_left_s;
    shot->device_latency_s = 0.021;
    if (line_->locked) {
      shot->pose.resize(3);
      shot->latency.poses = 600;
      shot->latency.stages = {
          {{0.016, 0.016, 0.016}, {0.007, 0.011, 0.012}, {0.001, 0.001, 0.003}, {}, {}, {0.024, 0.028, 0.031}}};
      shot->latency_mean_s = 0.024;
      shot->latency_max_s = 0.031;
    }
    return shot;
  }

 private:
  void fill_line(solve::LiveSnapshot& shot) const {
    shot.line.decided = true;
    shot.line.locked = line_->locked;
    shot.line.swapped = line_->swapped;
    shot.line.cycle_rate_hz = line_->locked ? kCycle : 0.0;
    shot.line.left_peak = line_->swapped ? 0.7 : line_->level;
    shot.line.right_peak = line_->swapped ? line_->level : line_->level > 0.0 ? 0.7 : 0.0;
    shot.line.cycles = line_->locked ? 1000 : 0;
  }

  void fill_scope(solve::LiveSnapshot& shot, double now) const {
    const auto frames = static_cast<std::size_t>(0.1 * kRate);
    const double end = std::floor(now * kRate), period = kRate / kCycle;
    shot.scope_first_sample = end - static_cast<double>(frames);
    unsigned noise = 12345;
    for (std::size_t i = 0; i < frames; ++i) {
      const double sample = shot.scope_first_sample + static_cast<double>(i);
      const double phase = sample / period - std::floor(sample / period);
      const int slot = std::min(kSlots - 1, static_cast<int>(phase * kSlots));
      const double within = phase * kSlots - slot;
      const double volts = slot == kSlots - 1 ? -0.9 : acceleration(slot / 3, slot % 3, now) / 15.0;
      const double ringing = 0.12 * std::exp(-within * 14.0) * std::cos(within * 60.0);
      noise = noise * 1664525U + 1013904223U;
      const double grain = (static_cast<double>(noise >> 16U) / 65536.0 - 0.5) * 0.02;
      const double data = line_->level * (line_->locked ? volts + ringing + grain : grain * 30.0);
      const double clock = line_->level > 0.0 && line_->locked ? (phase < 0.5 ? -0.62 : 0.62) : grain * line_->level;
      shot.scope.push_back(static_cast<float>(line_->swapped ? clock : data));
      shot.scope.push_back(static_cast<float>(line_->swapped ? data : clock));
    }
    if (!line_->locked) {
      return;
    }
    for (double number = std::ceil(shot.scope_first_sample / period); (number + 1.0) * period <= end; number += 1.0) {
      decode::LineInCycle cycle;
      cycle.number = static_cast<std::int64_t>(number);
      cycle.start_sample = number * period;
      cycle.period_samples = period;
      cycle.valid = true;
      cycle.clipped = line_->clipping_sensor >= 0 ? 1U << static_cast<unsigned>(3 * line_->clipping_sensor) : 0U;
      shot.scope_cycles.push_back(cycle);
    }
  }

  void fill_frames(solve::LiveSnapshot& shot, double now) const {
    const int sensors = static_cast<int>(settings_.rig.accelerometers.size());
    shot.specific_force.resize(static_cast<std::size_t>(sensors));
    for (int n = 0; n < 600 && line_->locked; ++n) {
      decode::AccelerationFrame frame;
      frame.time_s = now - 10.0 + n / 60.0;
      for (int s = 0; s < sensors; ++s) {
        const bool dead = s == line_->dead_sensor;
        frame.usable |= dead ? 0U : 1U << static_cast<unsigned>(s);
        Eigen::Vector3d f(acceleration(s, 0, frame.time_s), acceleration(s, 1, frame.time_s),
                          acceleration(s, 2, frame.time_s));
        shot.specific_force[static_cast<std::size_t>(s)].push_back(f);
      }
      shot.frames.push_back(frame);
    }
  }

  void fill_health(solve::LiveSnapshot& shot) const {
    using solve::HealthState;
    for (int s = 0; s < static_cast<int>(settings_.rig.accelerometers.size()); ++s) {
      solve::SensorHealth health{HealthState::kGood, "good", "good"};
      if (!line_->locked) {
        health = {HealthState::kUnknown, "unknown", "not heard yet"};
      } else if (s == line_->dead_sensor) {
        health = {HealthState::kBad, "no-signal", "reads nothing; check that the sensor is plugged in"};
      } else if (s == line_->clipping_sensor) {
        health = {HealthState::kWarning, "clipping", "clips; turn the recording volume down"};
      }
      shot.health.push_back(health);
    }
  }

  std::shared_ptr<FakeLine> line_;
  solve::LiveSettings settings_;
  double begin_;
  mutable std::uint64_t version_ = 0;
  mutable bool dead_ = false;
  std::filesystem::path folder_;
  std::string subject_;
  std::atomic<double> recording_since_ = 0.0;
};

}  // namespace

solve::LiveSettings fake_rig() {
  solve::LiveSettings settings;
  settings.rig.name = "line-in-arm";
  settings.rig.title = "Arm with five accelerometers on a sound card";
  for (const char* name : {"chest", "upper arm", "forearm", "hand", "a sensor with quite a long name"}) {
    body::Accelerometer sensor;
    sensor.name = name;
    sensor.segment = name;
    settings.rig.accelerometers.push_back(sensor);
  }
  return settings;
}

StudioServices fake_services(const std::shared_ptr<FakeLine>& line) {
  StudioServices services;
  services.list_devices = [line]() -> Result<std::vector<acquire::DeviceInfo>> {
    std::vector<acquire::DeviceInfo> devices;
    if (!line->no_devices) {
      acquire::DeviceInfo card;
      card.id = "portaudio:ALSA:card";
      card.title = "USB Audio CODEC: Line in (hw:1,0)";
      card.channels = 4;
      card.rates_hz = {44100.0, 48000.0, 96000.0};
      card.types = {acquire::SampleType::kInt16, acquire::SampleType::kInt24};
      devices.push_back(card);
    }
    acquire::DeviceInfo simulator;
    simulator.id = "simulator:wave";
    simulator.title = "Simulator: waving";
    simulator.channels = 2;
    // The real list has one for every motion.
    devices.push_back(simulator);
    simulator.id = "simulator:walk";
    simulator.title = "Simulator: walking";
    devices.push_back(simulator);
    return devices;
  };
  services.open_device = [line](const std::string& id, const DeviceSetup& setup,
                                const std::string&) -> Result<std::unique_ptr<acquire::LiveSource>> {
    if (line->fail_open) {
      return Error{"the device is busy", id, "close the program that uses it, then choose it again"};
    }
    if (line->open_now > 0 && line->exclusive) {
      return Error{"the device is busy", id, "close the program that uses it, then choose it again"};
    }
    ++line->open_now;
    ++line->opened;
    line->setup = setup;
    return std::unique_ptr<acquire::LiveSource>(std::make_unique<FakeSource>());
  };
  services.make_live = [line](std::unique_ptr<acquire::LiveSource>, solve::LiveSettings settings) {
    return std::unique_ptr<LiveBackend>(std::make_unique<FakeBackend>(line, std::move(settings)));
  };
  services.demo_motions = [] { return std::vector<std::string>{"wave", "arm-raise", "reach", "walk", "box"}; };
  services.list_rigs = [] {
    return std::vector<RigChoice>{{"line-in-arm", "Arm with five accelerometers on a sound card"},
                                  {"other", "Another board"}};
  };
  services.load_rig = [line](const std::string&, const std::string& subject,
                             const std::string&) -> Result<solve::LiveSettings> {
    solve::LiveSettings settings = fake_rig();
    settings.calibration = calibrate::nominal_calibration(settings.rig);
    if (const auto found = line->mounted.find(subject); found != line->mounted.end()) {
      for (calibrate::MountCalibration& mount : settings.calibration.mounts) {
        mount.method = "two poses";
        mount.date = found->second;
      }
    }
    return settings;
  };
  services.open_take = [](const std::filesystem::path& folder) -> Result<take::Take> {
    if (!std::filesystem::exists(folder / "take.json")) {
      return Error{"this is not a take", folder.string(), "choose a folder that ends in .take"};
    }
    take::Take take;
    take.folder = folder;
    return take;
  };
  services.simulate_take = [](const std::filesystem::path& folder, const std::string&,
                              const Progress& progress) -> Status {
    // Slow on purpose, so that it can be watched and cancelled.
    for (int i = 0; i < 200; ++i) {
      if (!progress.report(i / 200.0, "simulating")) {
        return cancelled();
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "take.json") << "{}";
    return {};
  };
  return services;
}

}  // namespace limbwave::ui::testing
