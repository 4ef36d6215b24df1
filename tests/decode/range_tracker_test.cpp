#include "decode/range_tracker.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/so3.h"

namespace limbwave::decode {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kSlot = 0.008;
const Vector3d kTurn(0.6, -0.4, 0.9);          // rad/s, of C
const Vector3d kUp(9.80665, 0.0, 0.0);         // m/s², in axes that do not turn
const Vector3d kFirst(-0.35, 0.1, -0.3);       // m
const Vector3d kSpeed(0.5, -0.3, 0.2);         // m/s, at first
const Vector3d kAcceleration(-1.0, 0.6, 0.4);  // m/s²

RangingFormat four_sources() {
  RangingFormat format;
  for (const Vector3d& p :
       {Vector3d(0.1, 0.1, -0.1), Vector3d(-0.1, 0.1, -0.1), Vector3d(0.1, -0.1, -0.12), Vector3d(-0.1, -0.1, -0.08)}) {
    RangingSource source;
    source.position = p;
    source.normal = -Vector3d::UnitZ();
    format.sources.push_back(source);
  }
  format.receiver = kFirst;
  return format;
}

Quaterniond turned(double t) {
  return Quaterniond(geometry::exp_so3(-t * kTurn));  // from axes that do not turn to C
}

Vector3d place(double t) {
  return turned(t) * Vector3d(kFirst + t * kSpeed + 0.5 * t * t * kAcceleration);
}

// C turns where it is; the board does not turn and is accelerated.
TrackerStep step_at(int slot, bool words) {
  const double t = slot * kSlot;
  TrackerStep step;
  step.source.time_s = t;
  step.source.dt = slot > 0 ? kSlot : 0.0;
  step.source.place = four_sources().sources[static_cast<std::size_t>(slot % 4)].position;
  step.source.normal = -Vector3d::UnitZ();
  step.source.known = step.board.felt.known = words && slot > 0;
  step.source.w_C = kTurn;
  step.source.f_C = turned(t - 0.5 * kSlot) * kUp;
  step.board.felt.f_S = kUp + kAcceleration;
  return step;
}

double range_at(int slot) {
  const TrackerStep step = step_at(slot, true);
  const double t = slot * kSlot;
  double flight = 0.0;
  for (int i = 0; i < 5; ++i) {
    // C goes on turning while sound is under way, but the source has left it.
    const Vector3d moved = place(t) + flight * (turned(t) * Vector3d(kSpeed + t * kAcceleration));
    flight = (moved - step.source.place).norm() / four_sources().speed_of_sound;
  }
  return flight * four_sources().speed_of_sound;
}

RangeTracker started(int slots) {
  RangeTracker tracker(four_sources(), {});
  for (int slot = 0; slot < slots; ++slot) {
    const TrackerStep step = step_at(slot, true);
    tracker.advance(step);
    tracker.collect(slot % 4, step.source, range_at(slot), 1e-8);
    tracker.update(slot % 4, step.source, range_at(slot), 1e-8);
  }
  return tracker;
}

TEST(RangeTracker, WordsTellHowARangeGoesOn) {
  RangeTracker tracker = started(125);
  for (int slot = 125; slot < 141; ++slot) {
    tracker.advance(step_at(slot, true));
    const auto expected = tracker.expect(slot % 4, step_at(slot, true).source);
    ASSERT_TRUE(expected);
    EXPECT_NEAR(expected->range, range_at(slot), 1.5e-3) << slot;
    EXPECT_NEAR(expected->range, range_at(slot), 4.0 * std::sqrt(expected->variance)) << slot;
  }
}

// Without updates dead reckoning goes back the way it came; it only gets less sure.
TEST(RangeTracker, RetreatUndoesAdvance) {
  RangeTracker tracker = started(125);
  const TrackerStep here = step_at(124, true);
  const auto before = tracker.expect(0, here.source);
  ASSERT_TRUE(before);
  for (int slot = 125; slot < 145; ++slot) {
    tracker.advance(step_at(slot, true));
  }
  for (int slot = 144; slot >= 125; --slot) {
    tracker.retreat(step_at(slot, true));
  }
  const auto after = tracker.expect(0, here.source);
  ASSERT_TRUE(after);
  EXPECT_NEAR(after->range, before->range, 2e-3);
  EXPECT_GT(after->variance, before->variance);
}

// Where words end, the acceleration that was felt goes on for a while; where they come again, it is felt again.
TEST(RangeTracker, WordsMayEndAndComeAgain) {
  RangeTracker tracker = started(125);
  for (int slot = 125; slot < 250; ++slot) {
    const bool words = slot < 150 || slot >= 175;
    const TrackerStep step = step_at(slot, words);
    tracker.advance(step);
    const auto expected = tracker.expect(slot % 4, step.source);
    ASSERT_TRUE(expected) << slot;
    EXPECT_NEAR(expected->range, range_at(slot), 6.0 * std::sqrt(expected->variance) + 1e-3) << slot;
    tracker.update(slot % 4, step.source, range_at(slot), 1e-8);
  }
}

TEST(RangeTracker, WithoutRangesNothingIsExpectedAfterAWhile) {
  RangeTracker tracker = started(125);
  for (int slot = 125; slot < 125 + 200; ++slot) {
    tracker.advance(step_at(slot, true));
  }
  EXPECT_FALSE(tracker.expect(0, step_at(324, true).source));
}

}  // namespace
}  // namespace limbwave::decode
