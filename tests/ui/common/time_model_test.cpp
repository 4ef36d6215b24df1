#include "common/time_model.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <array>
#include <limits>
#include <memory>
#include <string>

#include "common/job_runner.h"
#include "motion/clip.h"

namespace limbwave::ui {
namespace {

// Timers need an application's event dispatcher.
class WithApplication : public testing::Environment {
 public:
  void SetUp() override { application_ = std::make_unique<QCoreApplication>(count_, arguments_.data()); }
  void TearDown() override { application_.reset(); }

 private:
  int count_ = 1;
  std::string name_ = "test";
  std::array<char*, 2> arguments_{name_.data(), nullptr};
  std::unique_ptr<QCoreApplication> application_;
};
[[maybe_unused]] const auto* const kApplication = testing::AddGlobalTestEnvironment(new WithApplication);

TEST(TimeModel, PlayheadStaysWithinTheClip) {
  TimeModel time;
  time.set_extent(10.0, 0.01);
  time.set_playhead(12.0);
  EXPECT_EQ(time.playhead_s(), 10.0);
  time.set_playhead(-1.0);
  EXPECT_EQ(time.playhead_s(), 0.0);
  time.set_playhead(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(time.playhead_s(), 0.0);
}

TEST(TimeModel, ZoomKeepsThePlaceUnderTheCursor) {
  TimeModel time;
  time.set_extent(100.0, 0.01);
  time.set_visible(20.0, 40.0);
  time.zoom(2.0, 25.0);
  EXPECT_DOUBLE_EQ(time.visible_end_s() - time.visible_begin_s(), 10.0);
  // 25 s was a quarter of the way from the left, and still is.
  EXPECT_DOUBLE_EQ(25.0 - time.visible_begin_s(), 2.5);
  time.zoom(1e9, 25.0);
  EXPECT_NEAR(time.visible_end_s() - time.visible_begin_s(), 0.04, 1e-12);
  time.zoom(1e-9, 25.0);
  EXPECT_EQ(time.visible_begin_s(), 0.0);
  EXPECT_EQ(time.visible_end_s(), 100.0);
}

TEST(TimeModel, FramesAreCountedAsAnExportCountsThem) {
  TimeModel time;
  EXPECT_EQ(time.frames(), 0);
  for (const double duration : {40.95, 40.945, 12.0, 0.001}) {
    time.set_extent(duration, 1.0 / 62.071);
    EXPECT_EQ(time.frames(), static_cast<qint64>(motion::frame_count(duration, 62.071)));
    time.set_playhead(duration);
    EXPECT_EQ(time.frame(), time.frames() - 1) << "the last one, never one more";
  }
  time.set_extent(12.0, 1.0 / 60.0);
  for (const int frame : {0, 1, 59, 60, 719}) {
    time.set_playhead(frame / 60.0);
    EXPECT_EQ(time.frame(), frame);
  }
  time.set_playhead(59.9 / 60.0);
  EXPECT_EQ(time.frame(), 59) << "a frame stands until the next";
}

TEST(TimeModel, ALittleLongerOrShorterKeepsThePlayhead) {
  TimeModel time;
  time.set_extent(10.0, 0.1);
  time.set_playhead(4.0);
  time.correct_duration(10.05);
  EXPECT_EQ(time.duration_s(), 10.05);
  EXPECT_EQ(time.playhead_s(), 4.0);
  EXPECT_EQ(time.visible_end_s(), 10.05);
  time.set_visible(2.0, 6.0);
  time.set_playhead(10.05);
  time.correct_duration(9.97);
  EXPECT_EQ(time.playhead_s(), 9.97);
  EXPECT_EQ(time.visible_begin_s(), 2.0);
  EXPECT_EQ(time.visible_end_s(), 6.0);
}

TEST(TimeModel, StepsRestOnFrames) {
  TimeModel time;
  time.set_extent(1.0, 0.1);
  time.set_playhead(0.34);
  time.step(1);
  EXPECT_NEAR(time.playhead_s(), 0.4, 1e-12);
  time.step(-2);
  EXPECT_NEAR(time.playhead_s(), 0.2, 1e-12);
}

TEST(TimeModel, PlaysLoopsAndStops) {
  TimeModel time;
  EXPECT_FALSE((time.set_playing(true), time.playing())) << "nothing to play";
  time.set_extent(2.0, 0.1);
  time.set_looping(true);
  time.set_playhead(1.5);
  // Without an event loop the timer does not run; time passes as the test says. Playing is a state of its own.
  time.set_speed(2.0);
  time.set_playing(true);
  time.advance(0.5);
  EXPECT_NEAR(time.playhead_s(), 0.5, 1e-12);
  time.set_looping(false);
  time.advance(10.0);
  EXPECT_EQ(time.playhead_s(), 2.0);
  EXPECT_FALSE(time.playing());
  time.set_playing(true);
  EXPECT_EQ(time.playhead_s(), 0.0) << "from the end it starts again";
  time.set_speed(-1.0);
  time.set_playhead(0.2);
  time.advance(0.5);
  EXPECT_EQ(time.playhead_s(), 0.0);
  EXPECT_FALSE(time.playing());
}

TEST(TimeModel, PlayingKeepsStepWithTheClock) {
  qint64 now = 1'000'000'000;
  TimeModel time(nullptr, [&now] {
    now += 3'000;  // reading the clock takes time as well
    return now;
  });
  time.set_extent(7200.0, 1.0 / 60.0);
  time.set_playing(true);
  const qint64 begin = now;
  for (int tick = 0; tick < 60 * 60 * 60; ++tick) {  // an hour
    now += 16'666'667 - 3'000 + (tick % 7) * 1000;
    time.catch_up();
  }
  EXPECT_NEAR(time.playhead_s(), static_cast<double>(now - begin) * 1e-9, 1e-6);
}

TEST(JobRunner, TimeLeftIsNotGuessedTooEarly) {
  EXPECT_LT(estimate_left_s(0.01, 10.0), 0.0);
  EXPECT_LT(estimate_left_s(0.5, 0.1), 0.0);
  EXPECT_DOUBLE_EQ(estimate_left_s(0.25, 3.0), 9.0);
  EXPECT_DOUBLE_EQ(estimate_left_s(1.0, 3.0), 0.0);
}

}  // namespace
}  // namespace limbwave::ui
