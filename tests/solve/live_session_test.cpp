/// The running session: figures come as soon as they can and account for their age.
#include "solve/live_session.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "support/simulated_take.h"

namespace limbwave::solve {
namespace {

using testing_support::require;

LiveSettings arm_settings() {
  LiveSettings settings;
  settings.rig = require(body::load_rig("line-in-arm"));
  settings.skeleton = require(body::load_skeleton(settings.rig.skeleton));
  settings.calibration = calibrate::nominal_calibration(settings.rig);
  return settings;
}

TEST(LiveSession, TellsOfEveryFigureAndItsAge) {
  simulate::SimulateSettings simulated;
  simulated.motion = "wave";
  simulated.prologue = false;
  simulated.errors = require(simulate::load_errors("paper"));
  LiveSession session(require(simulate::open_simulator(simulated)), arm_settings());
  EXPECT_EQ(session.figure(), nullptr);
  std::atomic<std::uint64_t> told{0};
  std::atomic<bool> in_order{true};
  session.on_figure([&] {
    const auto figure = session.figure();  // callable from here
    in_order = in_order && figure->number == ++told;
  });
  require(session.start());
  const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (told < 120 && std::chrono::steady_clock::now() < limit) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  session.stop();
  EXPECT_GE(told, 120U);
  EXPECT_TRUE(in_order);
  const auto figure = session.figure();
  ASSERT_NE(figure, nullptr);
  EXPECT_EQ(figure->number, told);
  EXPECT_EQ(figure->pose.size(), arm_settings().skeleton.segments.size());
  const PoseTimes& times = figure->times;
  EXPECT_GT(times.oldest_slot, 0.0);
  EXPECT_LT(times.oldest_slot, times.instant);
  EXPECT_LT(times.instant, times.cycle_end);
  EXPECT_LE(times.cycle_end, times.arrived);
  EXPECT_LE(times.arrived, times.solved);
  EXPECT_EQ(times.drawn, 0.0) << "the screen is not the session's";

  const auto snapshot = session.snapshot();
  EXPECT_EQ(snapshot->pose_time_s, figure->time_s);
  const LatencyReport& report = snapshot->latency;
  EXPECT_GE(report.poses, 100U);
  // The board's cycle is 1/60 s, its first slot's middle a 32nd of that later.
  EXPECT_NEAR(report.of(LatencyStage::kCycle).mean_s, (1.0 - 1.0 / 32.0) / 60.0, 0.002);
  double sum = 0.0;
  for (std::size_t s = 0; s + 1 < kLatencyStages; ++s) {
    sum += report.stages[s].mean_s;
    EXPECT_LE(report.stages[s].mean_s, report.stages[s].max_s);
    EXPECT_LE(report.stages[s].p95_s, report.stages[s].max_s);
  }
  EXPECT_NEAR(report.of(LatencyStage::kTotal).mean_s, sum, 1e-9);
  EXPECT_EQ(snapshot->latency_mean_s, report.of(LatencyStage::kTotal).mean_s);
  std::printf("%zu poses, oldest slot to pose: %.1f ms mean, %.1f ms 95 %%, %.1f ms max\n", report.poses,
              1e3 * report.of(LatencyStage::kTotal).mean_s, 1e3 * report.of(LatencyStage::kTotal).p95_s,
              1e3 * report.of(LatencyStage::kTotal).max_s);
}

TEST(LiveSession, StopsWithASourceThatGivesNothing) {
  class Silent : public acquire::LiveSource {
   public:
    [[nodiscard]] acquire::StreamFormat format() const override {
      return {SampleRate{48000.0}, 2, acquire::SampleType::kInt16};
    }
    [[nodiscard]] std::string title() const override { return "silent"; }
    Status start() override { return {}; }
    void stop() override {}
    std::size_t pull(std::span<std::byte>) override { return 0; }
    [[nodiscard]] acquire::SourceCounters counters() const override { return {}; }
    [[nodiscard]] bool alive() const override { return true; }
    [[nodiscard]] double device_latency_s() const override { return 0.0; }
    [[nodiscard]] double newest_frame_time_s() const override { return 0.0; }
  };
  LiveSession session(std::make_unique<Silent>(), arm_settings());
  require(session.start());
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  session.stop();
  EXPECT_EQ(session.figure(), nullptr);
  EXPECT_EQ(session.snapshot()->latency.poses, 0U);
}

}  // namespace
}  // namespace limbwave::solve
