/// A running capture of a made-up arm for tests of the live view: poses at the pace of a real one, recordings without
/// samples.
#pragma once

#include <atomic>
#include <cmath>
#include <filesystem>
#include <mutex>
#include <thread>
#include <utility>

#include "solve/compose.h"
#include "ui/support/solve_fixture.h"

namespace limbwave::ui::testing {

/// A capture with a pose every 17 ms, each one frame old.
class FakeCapture : public LiveBackend {
 public:
  explicit FakeCapture(body::Skeleton skeleton) : skeleton_(std::move(skeleton)) {}
  ~FakeCapture() override { end(); }
  Status start() override {
    running_ = true;
    thread_ = std::thread([this] {
      while (running_) {
        std::this_thread::sleep_for(std::chrono::milliseconds(17));
        ++number_;
        told_();
      }
    });
    return {};
  }
  void stop() override { end(); }
  Status start_recording(const std::filesystem::path& folder, const std::string&) override {
    std::filesystem::create_directories(folder);
    folder_ = folder;
    recording_since_ = steady_now_s();
    return {};
  }
  Result<take::Take> stop_recording() override {
    take::Take take = made_up_take(QString::fromStdString(folder_.string()), 8.0);
    take.info.segments.clear();
    take.events = std::exchange(marks_, {});
    recording_since_ = 0.0;
    return take;
  }
  std::optional<take::TakeEvent> mark(const std::string& text) override {
    const auto number = static_cast<std::int64_t>(marks_.size()) + 1;
    marks_.push_back(
        {SampleIndex{std::llround(48000.0 * (steady_now_s() - recording_since_))}, "marker", text, number});
    return marks_.back();
  }
  bool write_event(const take::TakeEvent&) override { return true; }
  void set_calibration(const calibrate::RigCalibration&) override {}
  void set_headings(const std::vector<std::vector<solve::HeadingKey>>& headings) override {
    const std::lock_guard lock(mutex_);
    headings_ = headings;
  }
  void on_figure(std::function<void()> told) override { told_ = std::move(told); }
  [[nodiscard]] std::shared_ptr<const solve::LiveSnapshot> snapshot() const override {
    auto shot = std::make_shared<solve::LiveSnapshot>();
    shot->version = ++version_;
    shot->recording = recording_since_ > 0.0;
    shot->recorded_s = shot->recording ? steady_now_s() - recording_since_ : 0.0;
    return shot;
  }
  [[nodiscard]] std::shared_ptr<const solve::LiveFigure> figure() const override {
    if (number_ == 0) {
      return nullptr;
    }
    auto made = std::make_shared<solve::LiveFigure>();
    made->number = number_;
    const std::vector<double> now{steady_now_s()};
    std::vector<body::Quaterniond> R;
    const std::lock_guard lock(mutex_);
    for (const auto& list : made_up_motion(skeleton_, now)) {
      const double heading = R.size() < headings_.size() ? solve::heading_at(headings_[R.size()], 0.0) : 0.0;
      R.push_back(Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()) * list.front());
    }
    made->pose = body::poses_from_orientations(skeleton_, R, skeleton_.segments.front().p_PL);
    made->times.oldest_slot = now.front() - 0.017;
    made->times.instant = made->times.oldest_slot + 0.008;
    made->times.cycle_end = made->times.arrived = made->times.solved = now.front();
    return made;
  }

 private:
  void end() {
    running_ = false;
    if (thread_.joinable()) {
      thread_.join();
    }
  }
  body::Skeleton skeleton_;
  std::function<void()> told_;
  std::thread thread_;
  std::atomic<bool> running_{false};
  std::atomic<std::uint64_t> number_{0};
  mutable std::mutex mutex_;
  std::vector<std::vector<solve::HeadingKey>> headings_;
  mutable std::atomic<std::uint64_t> version_{0};
  std::atomic<double> recording_since_{0.0};
  std::filesystem::path folder_;
  std::vector<take::TakeEvent> marks_;
};

class SilentSource : public acquire::LiveSource {
 public:
  [[nodiscard]] acquire::StreamFormat format() const override { return {}; }
  [[nodiscard]] std::string title() const override { return "fake"; }
  Status start() override { return {}; }
  void stop() override {}
  std::size_t pull(std::span<std::byte>) override { return 0; }
  [[nodiscard]] acquire::SourceCounters counters() const override { return {}; }
  [[nodiscard]] bool alive() const override { return true; }
  [[nodiscard]] double device_latency_s() const override { return 0.0; }
  [[nodiscard]] double newest_frame_time_s() const override { return 0.0; }
};

inline StudioServices capture_services() {
  StudioServices services;
  services.load_rig = [](const std::string& name, const std::string&,
                         const std::string&) -> Result<solve::LiveSettings> {
    solve::LiveSettings settings;
    settings.rig = body::load_rig(name).value();
    settings.skeleton = body::load_skeleton(settings.rig.skeleton).value();
    return settings;
  };
  services.open_device = [](const std::string&, const DeviceSetup&,
                            const std::string&) -> Result<std::unique_ptr<acquire::LiveSource>> {
    return std::unique_ptr<acquire::LiveSource>(std::make_unique<SilentSource>());
  };
  services.make_live = [](std::unique_ptr<acquire::LiveSource>, solve::LiveSettings settings) {
    return std::unique_ptr<LiveBackend>(std::make_unique<FakeCapture>(settings.skeleton));
  };
  return services;
}

}  // namespace limbwave::ui::testing
