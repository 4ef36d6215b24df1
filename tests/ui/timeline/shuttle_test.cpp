#include "timeline/shuttle.h"

#include <gtest/gtest.h>

#include "common/time_model.h"

namespace limbwave::ui {
namespace {

TEST(Shuttle, DoublesUpToFourTimes) {
  double speed = 0.25;
  bool playing = false;
  for (const double expected : {1.0, 2.0, 4.0, 4.0}) {
    speed = shuttle_speed(speed, playing, 1);
    playing = true;
    EXPECT_DOUBLE_EQ(speed, expected);
  }
}

TEST(Shuttle, TurnsAroundAtNormalSpeed) {
  EXPECT_DOUBLE_EQ(shuttle_speed(4.0, true, -1), -1.0);
  EXPECT_DOUBLE_EQ(shuttle_speed(-1.0, true, -1), -2.0);
  EXPECT_DOUBLE_EQ(shuttle_speed(-2.0, true, 1), 1.0);
  EXPECT_DOUBLE_EQ(shuttle_speed(0.1, true, 1), 1.0);
}

// Playing is driven by ticks of any length and never goes against its direction except where it loops.
TEST(Playing, IsMonotonicWhateverTheTicks) {
  TimeModel time;
  time.set_extent(10.0, 1.0 / 60.0);
  time.set_looping(false);
  time.set_speed(0.1);
  time.set_playing(true);
  double before = 0.0;
  double elapsed = 0.0;
  for (const double tick : {0.016, 0.0, 0.031, 0.5, 0.001}) {
    time.advance(tick);
    elapsed += tick;
    EXPECT_GE(time.playhead_s(), before);
    before = time.playhead_s();
  }
  EXPECT_NEAR(time.playhead_s(), 0.1 * elapsed, 1e-12);
  time.advance(1000.0);
  EXPECT_DOUBLE_EQ(time.playhead_s(), 10.0);
  EXPECT_FALSE(time.playing());
}

TEST(Playing, LoopsBothWays) {
  TimeModel time;
  time.set_extent(2.0, 1.0 / 60.0);
  time.set_speed(1.0);
  time.set_playing(true);
  time.set_playhead(1.9);
  time.advance(0.3);
  EXPECT_NEAR(time.playhead_s(), 0.2, 1e-12);
  time.set_speed(-2.0);
  time.advance(0.2);
  EXPECT_NEAR(time.playhead_s(), 1.8, 1e-12);
  EXPECT_TRUE(time.playing());
}

}  // namespace
}  // namespace limbwave::ui
