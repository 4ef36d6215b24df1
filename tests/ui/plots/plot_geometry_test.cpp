#include "plots/plot_geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "plots/level_meter.h"

namespace limbwave::ui {
namespace {

TEST(PlotGeometry, AxisMapsBothWays) {
  const AxisMap map{-1.0, 1.0, 100.0, 0.0};
  EXPECT_DOUBLE_EQ(map.to_pixel(0.0), 50.0);
  EXPECT_DOUBLE_EQ(map.to_pixel(1.0), 0.0);
  EXPECT_DOUBLE_EQ(map.to_value(map.to_pixel(0.37)), 0.37);
}

TEST(PlotGeometry, TicksAreRoundNumbersAndFew) {
  EXPECT_DOUBLE_EQ(nice_step(10.0, 10), 1.0);
  EXPECT_DOUBLE_EQ(nice_step(10.0, 4), 5.0);
  EXPECT_DOUBLE_EQ(nice_step(0.037, 10), 0.005);
  EXPECT_DOUBLE_EQ(nice_step(0.0, 10), 1.0);
  for (const double span : {0.013, 1.0, 7.7, 3600.0}) {
    EXPECT_LE(ticks(0.0, span, nice_step(span, 8)).size(), 9U) << span;
  }
  EXPECT_EQ(ticks(0.1, 0.95, 0.25).size(), 3U);
  EXPECT_TRUE(ticks(0.0, 1e9, 1e-9).empty()) << "absurd steps give nothing rather than a frozen window";
}

TEST(PlotGeometry, DecimationKeepsEveryPeak) {
  std::vector<double> times(100000), values(100000, 0.0);
  for (std::size_t i = 0; i < times.size(); ++i) {
    times[i] = static_cast<double>(i);
  }
  values[54321] = 1.0;
  values[54322] = -1.0;
  const AxisMap x{0.0, 100000.0, 0.0, 200.0}, y{-1.0, 1.0, 100.0, 0.0};
  const QPolygonF line = decimated_line(times, values, x, y);
  EXPECT_LE(line.size(), 4 * 201);
  double top = 50.0, bottom = 50.0;
  for (const QPointF& point : line) {
    top = std::min(top, point.y());
    bottom = std::max(bottom, point.y());
  }
  EXPECT_DOUBLE_EQ(top, 0.0);
  EXPECT_DOUBLE_EQ(bottom, 100.0);
}

TEST(PlotGeometry, DecimationLeavesOutWhatIsNotANumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> times{0.0, 1.0, 2.0}, values{1.0, nan, 2.0};
  const QPolygonF line = decimated_line(times, values, {0, 2, 0, 100}, {0, 2, 100, 0});
  EXPECT_EQ(line.size(), 2);
  EXPECT_TRUE(decimated_line({}, {}, {0, 1, 0, 100}, {0, 1, 100, 0}).isEmpty());
}

decode::LineInCycle cycle_at(double start, double period, bool valid) {
  decode::LineInCycle cycle;
  cycle.start_sample = start;
  cycle.period_samples = period;
  cycle.valid = valid;
  return cycle;
}

TEST(ScopeWindow, StandsStillOnTheNewestWholeCycle) {
  const std::vector<decode::LineInCycle> cycles{cycle_at(1000, 800, true), cycle_at(1800, 800, true),
                                                cycle_at(2600, 800, false), cycle_at(3400, 800, true)};
  // 4000 samples from 500 on end at 4500: the last cycle (3400..4200) fits with its margin.
  const ScopeWindow window = scope_window(cycles, 500, 4000, 960);
  ASSERT_TRUE(window.cycle.has_value());
  EXPECT_EQ(window.cycle->start_sample, 3400);
  EXPECT_LT(window.first_sample, 3400);
  EXPECT_GT(window.last_sample, 4200);
  // When it is cut off, the newest valid one before it is shown; the invalid one never is.
  const ScopeWindow earlier = scope_window(cycles, 500, 3500, 960);
  ASSERT_TRUE(earlier.cycle.has_value());
  EXPECT_EQ(earlier.cycle->start_sample, 1800);
}

TEST(ScopeWindow, RunsFreeWithoutSync) {
  const ScopeWindow window = scope_window({}, 100, 4800, 960);
  EXPECT_FALSE(window.cycle.has_value());
  EXPECT_EQ(window.last_sample, 4900);
  EXPECT_EQ(window.first_sample, 3940);
  EXPECT_EQ(scope_window({}, 100, 10, 960).first_sample, 100) << "not before the first sample";
}

TEST(Ranges, ScopeShowsThePeakWithSomethingToSpare) {
  EXPECT_EQ(scope_range(0.0), 0.01);
  EXPECT_EQ(scope_range(0.3), 0.5);
  EXPECT_EQ(scope_range(0.49), 0.7);
  EXPECT_EQ(scope_range(0.95), 1.0);
  EXPECT_EQ(scope_range(3.0), 1.0);
}

TEST(Ranges, StripsDoNotJumpToAndFro) {
  EXPECT_EQ(strip_range(9.8, 0.0), 10.0);
  EXPECT_EQ(strip_range(15.0, 10.0), 20.0);
  EXPECT_EQ(strip_range(9.9, 20.0), 20.0) << "just inside the smaller range: stay";
  EXPECT_EQ(strip_range(5.0, 20.0), 10.0) << "well inside: shrink";
  EXPECT_EQ(strip_range(1e6, 20.0), 100.0);
}

TEST(MinMaxOutline, GoesThereAndBack) {
  const std::vector<signal::MinMaxPoint> points{{0, 10, -1.0F, 1.0F}, {10, 10, -0.5F, 0.5F}};
  const QPolygonF outline = min_max_outline(points, {0, 20, 0, 20}, {-1, 1, 100, 0});
  ASSERT_EQ(outline.size(), 4);
  EXPECT_EQ(outline.front(), QPointF(5, 0));
  EXPECT_EQ(outline.back(), QPointF(5, 100));
}

TEST(LevelMeter, ScaleEndsAtSixtyDecibels) {
  EXPECT_DOUBLE_EQ(level_position(1.0), 1.0);
  EXPECT_DOUBLE_EQ(level_position(0.001), 0.0);
  EXPECT_DOUBLE_EQ(level_position(0.0), 0.0);
  EXPECT_NEAR(level_position(0.0316228), 0.5, 1e-6);
  EXPECT_DOUBLE_EQ(level_position(5.0), 1.0);
}

}  // namespace
}  // namespace limbwave::ui
