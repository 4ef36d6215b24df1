#include "timeline/timeline_geometry.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limbwave::ui {
namespace {

constexpr double kFrame = 1.0 / 60.0;

TEST(TimeScale, PixelsAndTimesGoBothWays) {
  const TimeScale scale{10.0, 14.0, 100.0, 800.0};
  EXPECT_DOUBLE_EQ(scale.x(10.0), 100.0);
  EXPECT_DOUBLE_EQ(scale.x(14.0), 900.0);
  EXPECT_DOUBLE_EQ(scale.time(500.0), 12.0);
  for (const double t : {9.0, 10.37, 13.99}) {
    EXPECT_NEAR(scale.time(scale.x(t)), t, 1e-12);
  }
}

TEST(TimeScale, EmptyRangeStaysFinite) {
  const TimeScale scale{0.0, 0.0, 0.0, 0.0};
  EXPECT_TRUE(std::isfinite(scale.x(1.0)));
  EXPECT_TRUE(std::isfinite(scale.time(1.0)));
}

TEST(Ticks, LabelsNeverComeCloserThanAsked) {
  for (double per_pixel = 1e-5; per_pixel < 100; per_pixel *= 1.7) {
    const TickSpacing spacing = tick_spacing(per_pixel, kFrame, 70.0);
    EXPECT_GE(spacing.major_s / per_pixel, 70.0 - 1e-9) << per_pixel;
    EXPECT_GE(spacing.minor, 1);
  }
}

TEST(Ticks, CloseUpTheyStandOnFrames) {
  const TickSpacing spacing = tick_spacing(kFrame / 100, kFrame, 70.0);
  EXPECT_NEAR(spacing.major_s, kFrame, 1e-12);
}

TEST(Ticks, StayWithinTheVisiblePartAndTheClip) {
  const TimeScale scale{3590.2, 3601.0, 0.0, 900.0};
  const auto list = ticks(scale, {1.0, 5}, 3600.0);
  ASSERT_FALSE(list.empty());
  EXPECT_GE(list.front().time_s, 3590.2);
  EXPECT_NEAR(list.back().time_s, 3600.0, 1e-9);
  EXPECT_TRUE(list.back().major);
  int majors = 0;
  for (const Tick& tick : list) {
    majors += tick.major ? 1 : 0;
  }
  EXPECT_EQ(majors, 10);
}

TEST(TimeLabel, ShowsAsMuchAsItsResolution) {
  EXPECT_EQ(time_label(3.25, 1.0), "0:03");
  EXPECT_EQ(time_label(3.25, 0.1), "0:03.3");
  EXPECT_EQ(time_label(3.25, 0.001), "0:03.250");
  EXPECT_EQ(time_label(59.9996, 0.001), "1:00.000");
  EXPECT_EQ(time_label(3723.0, 1.0), "1:02:03");
  EXPECT_EQ(time_label(-1.0, 1.0), "0:00");
}

TEST(Snapping, GoesToTheNearestFrame) {
  EXPECT_NEAR(snapped_to_frame(0.51 * kFrame, kFrame), kFrame, 1e-12);
  EXPECT_NEAR(snapped_to_frame(0.49 * kFrame, kFrame), 0.0, 1e-12);
}

TEST(Hit, TakesTheNearestWithinReach) {
  EXPECT_EQ(hit({10, 20, 30}, 21, 5), 1);
  EXPECT_EQ(hit({10, 20, 30}, 15.1, 5), 1);
  EXPECT_EQ(hit({10, 20, 30}, 40, 5), -1);
  EXPECT_EQ(hit({}, 0, 5), -1);
  EXPECT_EQ(hit({10, 10}, 10, 5), 1);  // The later one is drawn on top.
}

TEST(FreeTime, KeepsItsDistance) {
  EXPECT_DOUBLE_EQ(free_time(2.0, 0.0, {1.0, 3.0}, 0.5, 10.0), 2.0);
  EXPECT_DOUBLE_EQ(free_time(1.1, 0.0, {1.0}, 0.5, 10.0), 1.5);
  EXPECT_DOUBLE_EQ(free_time(0.9, 0.0, {1.0}, 0.5, 10.0), 0.5);
  EXPECT_DOUBLE_EQ(free_time(-4.0, 1.0, {}, 0.5, 10.0), 0.0);
  EXPECT_DOUBLE_EQ(free_time(12.0, 1.0, {}, 0.5, 10.0), 10.0);
  // No room at all: stays.
  EXPECT_DOUBLE_EQ(free_time(0.6, 0.25, {0.0, 0.5, 1.0}, 0.6, 1.0), 0.25);
}

TEST(OverviewThumb, CoversTheVisiblePartAndCanBeCaught) {
  const Span all = overview_thumb(0, 100, 100, 10, 500, 24);
  EXPECT_DOUBLE_EQ(all.begin, 10);
  EXPECT_DOUBLE_EQ(all.end, 510);
  const Span tiny = overview_thumb(99.99, 100, 100, 10, 500, 24);
  EXPECT_NEAR(tiny.end, 510, 1e-6);
  EXPECT_NEAR(tiny.end - tiny.begin, 24, 1e-9);
  const Span none = overview_thumb(0, 0, 0, 10, 500, 24);
  EXPECT_DOUBLE_EQ(none.end - none.begin, 500);
}

}  // namespace
}  // namespace limbwave::ui
