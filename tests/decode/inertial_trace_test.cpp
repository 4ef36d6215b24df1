#include "decode/inertial_trace.h"

#include <gtest/gtest.h>

namespace limbwave::decode {
namespace {

using Eigen::Vector3d;

InertialReading reading(double time_s, const Vector3d& w, const Vector3d& f) {
  InertialReading r;
  r.time = Seconds{time_s};
  r.w_WS_S = w;
  r.f_S = f;
  r.valid = true;
  return r;
}

TEST(InertialTrace, LinesGiveExactMeans) {
  InertialTrace trace;
  for (int i = 0; i < 20; ++i) {
    const double t = i / 140.0;
    trace.add(reading(t, Vector3d(t, 0.0, -2.0 * t), Vector3d(1.0, 3.0 * t, 0.0)));
  }
  const FeltMotion felt = trace.over(0.031, 0.047);
  ASSERT_TRUE(felt.known);
  EXPECT_FALSE(felt.saturated);
  EXPECT_LT((felt.w_S - Vector3d(0.039, 0.0, -0.078)).norm(), 1e-12);
  EXPECT_LT((felt.f_S - Vector3d(1.0, 0.117, 0.0)).norm(), 1e-12);
}

TEST(InertialTrace, NothingIsKnownBeyondReadingsAndAcrossGaps) {
  InertialTrace trace;
  trace.add(reading(0.0, Vector3d::Zero(), Vector3d::Zero()));
  trace.add(reading(0.02, Vector3d::Zero(), Vector3d::Zero()));
  trace.add(reading(0.08, Vector3d::Zero(), Vector3d::Zero()));
  EXPECT_TRUE(trace.over(0.005, 0.015).known);
  EXPECT_FALSE(trace.over(-0.01, 0.015).known);
  EXPECT_FALSE(trace.over(0.03, 0.05).known);
  EXPECT_FALSE(trace.over(0.07, 0.09).known);
}

TEST(InertialTrace, HowFarReadingsAreJoinedIsTheCallers) {
  InertialTrace trace(0.0145);
  for (const double t : {0.0, 0.0143, 0.0290}) {
    trace.add(reading(t, Vector3d::Zero(), Vector3d::Zero()));
  }
  EXPECT_TRUE(trace.over(0.002, 0.012).known);
  EXPECT_FALSE(trace.over(0.016, 0.027).known);
}

TEST(InertialTrace, ReadingsThatAreNotValidAreLeftOut) {
  InertialTrace trace;
  trace.add(reading(0.0, Vector3d::Zero(), Vector3d::UnitX()));
  InertialReading bad = reading(0.007, Vector3d::Zero(), Vector3d(100.0, 0.0, 0.0));
  bad.valid = false;
  trace.add(bad);
  trace.add(reading(0.014, Vector3d::Zero(), Vector3d::UnitX()));
  trace.add(reading(0.007, Vector3d::Zero(), Vector3d(50.0, 0.0, 0.0)));  // out of order
  const FeltMotion felt = trace.over(0.004, 0.012);
  ASSERT_TRUE(felt.known);
  EXPECT_LT((felt.f_S - Vector3d::UnitX()).norm(), 1e-12);
}

TEST(InertialTrace, AnEndOfARangeShowsInEveryStretchItTouches) {
  InertialTrace trace;
  for (int i = 0; i < 10; ++i) {
    InertialReading r = reading(0.01 * i, Vector3d::Zero(), Vector3d::Zero());
    r.saturated = i == 5;
    trace.add(r);
  }
  EXPECT_FALSE(trace.over(0.02, 0.03).saturated);
  EXPECT_TRUE(trace.over(0.042, 0.046).saturated);
  EXPECT_TRUE(trace.over(0.052, 0.056).saturated);
  EXPECT_FALSE(trace.over(0.065, 0.075).saturated);
}

}  // namespace
}  // namespace limbwave::decode
