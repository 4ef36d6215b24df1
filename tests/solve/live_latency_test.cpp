#include "solve/live_latency.h"

#include <gtest/gtest.h>

namespace limbwave::solve {
namespace {

PoseTimes pose_at(double begin, double drawing) {
  PoseTimes times;
  times.oldest_slot = begin;
  times.instant = begin + 0.008;
  times.cycle_end = begin + 0.016;
  times.arrived = begin + 0.020;
  times.solved = begin + 0.021;
  if (drawing > 0.0) {
    times.taken = begin + 0.023;
    times.drawn = begin + 0.023 + drawing;
  }
  return times;
}

TEST(LatencyMeter, TakesTheWayApart) {
  LatencyMeter meter;
  EXPECT_EQ(meter.report().poses, 0U);
  for (int i = 0; i < 100; ++i) {
    meter.add(pose_at(1.0 + 0.016 * i, 0.001 * (i + 1)));
  }
  const LatencyReport report = meter.report();
  EXPECT_EQ(report.poses, 100U);
  EXPECT_NEAR(report.of(LatencyStage::kCycle).mean_s, 0.016, 1e-9);
  EXPECT_NEAR(report.of(LatencyStage::kArrival).max_s, 0.004, 1e-9);
  EXPECT_NEAR(report.of(LatencyStage::kSolve).p95_s, 0.001, 1e-9);
  EXPECT_NEAR(report.of(LatencyStage::kHandover).mean_s, 0.002, 1e-9);
  EXPECT_NEAR(report.of(LatencyStage::kDraw).mean_s, 0.0505, 1e-9);
  EXPECT_NEAR(report.of(LatencyStage::kDraw).p95_s, 0.095, 1e-9);
  EXPECT_NEAR(report.of(LatencyStage::kDraw).max_s, 0.100, 1e-9);
  double sum = 0.0;
  for (std::size_t s = 0; s + 1 < kLatencyStages; ++s) {
    sum += report.stages[s].mean_s;
  }
  EXPECT_NEAR(report.of(LatencyStage::kTotal).mean_s, sum, 1e-9) << "nothing is left out";
  EXPECT_NEAR(report.over_budget, 0.43, 1e-9);  // 23 ms and more than 57 ms of drawing
}

TEST(LatencyMeter, WithoutAScreenItEndsWithThePose) {
  LatencyMeter meter;
  meter.add(pose_at(1.0, 0.0));
  const LatencyReport report = meter.report();
  EXPECT_NEAR(report.of(LatencyStage::kTotal).mean_s, 0.021, 1e-9);
  EXPECT_EQ(report.of(LatencyStage::kDraw).max_s, 0.0);
}

TEST(LatencyMeter, ForgetsAndRefusesNonsense) {
  LatencyMeter meter(2.0);
  meter.add(pose_at(1.0, 0.5));
  meter.add(pose_at(10.0, 0.01));
  EXPECT_EQ(meter.report().poses, 1U);
  PoseTimes backwards = pose_at(10.1, 0.01);
  backwards.arrived = backwards.cycle_end - 0.001;
  meter.add(backwards);
  meter.add(PoseTimes{});
  EXPECT_EQ(meter.report().poses, 1U);
}

}  // namespace
}  // namespace limbwave::solve
