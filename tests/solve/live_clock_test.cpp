#include "solve/live_clock.h"

#include <gtest/gtest.h>

#include <random>

namespace limbwave::solve {
namespace {

constexpr double kRate = 48000.0;
constexpr double kStart = 1000.0;  // when sample 0 was captured

TEST(CaptureClock, LateBlocksDoNotMoveIt) {
  CaptureClock clock(SampleRate{kRate});
  EXPECT_FALSE(clock.known());
  std::mt19937 random(1);
  std::exponential_distribution<double> lateness(1.0 / 0.004);
  std::int64_t frames = 0;
  for (int block = 0; block < 3000; ++block) {  // half a minute
    frames += 480;
    const double captured = kStart + static_cast<double>(frames) / kRate;
    clock.arrived(frames, captured + (block % 50 == 7 ? 0.0 : lateness(random)));
    if (block > 7) {
      ASSERT_NEAR(clock.time_of(static_cast<double>(frames)), captured, 1e-9) << block;
    }
    ASSERT_LE(clock.time_of(static_cast<double>(frames)), captured + 0.2);
  }
}

TEST(CaptureClock, FollowsADeviceWhoseClockIsOff) {
  for (const double ppm : {-100.0, 100.0}) {
    CaptureClock clock(SampleRate{kRate});
    std::int64_t frames = 0;
    for (int block = 0; block < 60000; ++block) {  // ten minutes: 60 ms of drift
      frames += 480;
      const double captured = kStart + static_cast<double>(frames) / (kRate * (1.0 + 1e-6 * ppm));
      clock.arrived(frames, captured);
      ASSERT_NEAR(clock.time_of(static_cast<double>(frames)), captured, 1.1e-3) << ppm;
    }
  }
}

TEST(CaptureClock, StartsAgainAfterALoss) {
  CaptureClock clock(SampleRate{kRate});
  clock.arrived(480, kStart);
  clock.restart();
  EXPECT_FALSE(clock.known());
  clock.arrived(960, kStart + 5.0);
  EXPECT_DOUBLE_EQ(clock.time_of(960.0), kStart + 5.0);
}

}  // namespace
}  // namespace limbwave::solve
