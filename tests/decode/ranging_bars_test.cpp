// What ranging must reach on simulated takes, as `limbwave evaluate` measures it.
#include <gtest/gtest.h>

#include "support/ranging_take.h"
#include "support/simulated_take.h"

namespace limbwave {
namespace {

using testing_support::require;

struct Case {
  const char* motion;
  const char* errors;
  std::uint64_t seed;
};

evaluate::RangeStatistics measured(const Case& c, decode::RangingMethod method = decode::RangingMethod::kCarrier) {
  const test::TemporaryFolder folder;
  simulate::SimulateSettings settings;
  settings.rig = "driver-box-body";
  settings.motion = c.motion;
  settings.errors_name = c.errors;
  settings.seed = c.seed;
  settings.seconds = 12.0;
  require(simulate::simulate_take(folder.path() / "a.take", settings, {}));
  const auto take = require(testing_support::open_ranging_take(folder.path() / "a.take"));
  evaluate::DriverBoxComparison comparison = take->comparison();
  decode::DriverBoxParameters parameters;
  parameters.ranging.method = method;
  (void)require(take->decode(parameters, [&](const decode::RangeReading& reading) { comparison.add(reading); }));
  const evaluate::RangeStatistics r = comparison.ranges();
  std::printf(
      "%s, %s, seed %d: %.1f %% of %d clear pairs, median %.3f mm, 95 %% %.3f mm, slips %.1e, > 20 mm %.1e, "
      "missed %.2f %%, flagged %.2f %%, nis %.2f\n",
      c.motion, c.errors, static_cast<int>(c.seed),
      100.0 * static_cast<double>(r.clear_accepted) / static_cast<double>(r.clear), static_cast<int>(r.clear),
      r.median_mm, r.p95_mm, r.slips, r.wrong, 100.0 * r.missed_occlusions, 100.0 * r.false_occlusions, r.nis);
  return r;
}

// Limbs that move in front of the body.
TEST(RangingBars, CarrierPhase) {
  for (const Case& c : {Case{"reach", "calibrated", 31}, Case{"wave", "calibrated", 32}}) {
    const evaluate::RangeStatistics r = measured(c);
    EXPECT_GE(static_cast<double>(r.clear_accepted), 0.85 * static_cast<double>(r.clear)) << c.motion;
    EXPECT_LE(r.median_mm, 0.3) << c.motion;
    EXPECT_LE(r.p95_mm, 1.0) << c.motion;
    EXPECT_LE(r.slips, 2e-3) << c.motion;
    EXPECT_LE(r.wrong, 1e-3) << c.motion;
    EXPECT_LE(r.missed_occlusions, 0.02) << c.motion;
    EXPECT_LE(r.false_occlusions, 0.02) << c.motion;
    // A variance tells what it promises: squared errors are as large on average, or smaller by what calibration left.
    EXPECT_LT(r.nis, 1.5) << c.motion;
    EXPECT_GT(r.nis, 0.1) << c.motion;
    EXPECT_LT(r.beyond_3_sd, 0.03) << c.motion;
  }
}

// Chips, skin and bones as the paper met them, and feet and hands that are heard at 12 to 18 dB now and then.
TEST(RangingBars, CarrierPhaseOfTheWholeBody) {
  for (const Case& c : {Case{"squat", "paper", 33}, Case{"walk", "paper", 34}}) {
    const evaluate::RangeStatistics r = measured(c);
    EXPECT_GE(static_cast<double>(r.clear_accepted), 0.8 * static_cast<double>(r.clear)) << c.motion;
    EXPECT_LE(r.median_mm, 0.3) << c.motion;
    EXPECT_LE(r.p95_mm, 1.0) << c.motion;
    EXPECT_LE(r.slips, 2e-3) << c.motion;
    EXPECT_LE(r.wrong, 1e-3) << c.motion;
    EXPECT_LE(r.missed_occlusions, 0.02) << c.motion;
    EXPECT_LE(r.false_occlusions, 0.02) << c.motion;
  }
}

}  // namespace
}  // namespace limbwave
