/// From a take to a clip: what is refused and what is said.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <map>

#include "geometry/so3.h"
#include "solve/codes.h"
#include "solve/compose.h"
#include "solve/report_text.h"
#include "solve/solve.h"
#include "support/simulated_take.h"

namespace limbwave::solve {
namespace {

using test::codes;
using testing::Contains;
using testing::HasSubstr;
using testing_support::require;

take::Take perfect_take(const std::filesystem::path& folder) {
  simulate::SimulateSettings settings;
  settings.seconds = 4.0;
  settings.prologue = false;
  settings.format.type = acquire::SampleType::kFloat32;
  return testing_support::simulated(folder, settings);
}

double largest_difference(const Solve& a, const Solve& b) {
  const auto R_a = world_orientations(a.clip);
  const auto R_b = world_orientations(b.clip);
  double largest = 0.0;
  for (std::size_t i = 0; i < std::min(R_a.size(), R_b.size()); ++i) {
    for (std::size_t s = 0; s < R_a[i].size(); ++s) {
      largest = std::max(largest, geometry::geodesic_angle(R_a[i][s], R_b[i][s]));
    }
  }
  return largest;
}

// However short the smoothing: what comes out goes on being what the limbs did.
TEST(SolveTake, SmoothingOverNoTimeIsNearlyNone) {
  const test::TemporaryFolder folder;
  const take::Take take = perfect_take(folder / "wave.take");
  SolveSettings none;
  none.smoothing = Smoothing::kNone;
  const Solve plain = require(solve_take(take, none, {}));
  ASSERT_GT(plain.clip.joints.front().rotation.times.size(), 200U);
  for (const Smoothing smoothing : {Smoothing::kAdaptive, Smoothing::kBridging}) {
    for (const double time_s : {0.0, 1e-9, 0.001}) {
      SolveSettings settings;
      settings.smoothing = smoothing;
      settings.smoothing_s = time_s;
      const Solve solve = require(solve_take(take, settings, {}));
      EXPECT_LT(largest_difference(solve, plain), 0.6) << name(smoothing) << " " << time_s;
    }
  }
}

// An hour's take must not be deaf for seconds.
TEST(SolveTake, CanBeStoppedWithinEveryStage) {
  const test::TemporaryFolder folder;
  simulate::SimulateSettings simulation;
  simulation.seconds = 2.0;
  const take::Take take = testing_support::simulated(folder / "wave.take", simulation);
  std::map<std::string, int> asked;
  SolveSettings settings;
  settings.smoothing = Smoothing::kBridging;
  double last = 0.0;
  require(solve_take(take, settings, Progress([&](double fraction, std::string_view what) {
                       EXPECT_GE(fraction, last - 1e-9) << what;
                       last = fraction;
                       ++asked[std::string(what)];
                       return true;
                     })));
  EXPECT_GE(asked["calibrating"], 5) << "per sensor";
  EXPECT_GE(asked["estimating"], 10) << "per sensor and filter";
  for (const auto& [stage, count] : asked) {
    for (const int stop_at : {1, count}) {
      int times = 0;
      bool stopped = false;
      const Result<Solve> solve =
          solve_take(take, settings, Progress([&, &stage = stage](double, std::string_view what) {
                       times += what == stage ? 1 : 0;
                       stopped = stopped || (what == stage && times == stop_at);
                       return !stopped;
                     }));
      if (stage != "done") {
        ASSERT_FALSE(solve) << stage << " " << stop_at;
        EXPECT_TRUE(is_cancelled(solve.error())) << stage << " " << stop_at;
      }
    }
  }
}

TEST(LimbOrientations, WhatIsNotANumberIsNoLimbAtRest) {
  std::vector<estimate::Inclination> inclinations(5);
  for (std::size_t i = 0; i < inclinations.size(); ++i) {
    inclinations[i].time_s = 0.5 * static_cast<double>(i);
    inclinations[i].known = true;
  }
  EXPECT_EQ(require(limb_orientations(inclinations, "forearm")).size(), 5U);
  inclinations[3].up_L.y() = std::numeric_limits<double>::quiet_NaN();
  const auto refused = limb_orientations(inclinations, "forearm");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().place, "forearm");
  EXPECT_THAT(refused.error().message, HasSubstr("1.50 s"));
}

TEST(SolveTake, SlotsThatAreTooShortForTheRateAreRefused) {
  const test::TemporaryFolder folder;
  take::Take take = perfect_take(folder / "wave.take");
  take.info.rig.line_in.cycle_rate_hz = 700.0;  // 4.3 samples a slot without, 3.9 with the tolerance of the clock
  const Result<Solve> solve = solve_take(take, {}, {});
  ASSERT_FALSE(solve);
  EXPECT_THAT(solve.error().message, HasSubstr("3.9 samples"));
  EXPECT_THAT(solve.error().remedy, HasSubstr("49280"));
}

TEST(SolveTake, ASensorWithoutASegmentIsToldAndLeavesTheOthersInPlace) {
  const test::TemporaryFolder folder;
  take::Take take = perfect_take(folder / "wave.take");
  const Solve whole = require(solve_take(take, {}, {}));
  take.info.rig.accelerometers[1].segment = "tail";
  const Solve solve = require(solve_take(take, {}, {}));
  EXPECT_THAT(solve.report.diagnostics,
              Contains(testing::AllOf(testing::Field(&Diagnostic::code, "solve.no-segment"),
                                      testing::Field(&Diagnostic::place, take.info.rig.accelerometers[1].name),
                                      testing::Field(&Diagnostic::message, HasSubstr("tail")))));
  ASSERT_EQ(solve.trust.size(), 5U);
  EXPECT_TRUE(solve.trust[1].empty());
  for (const std::size_t s : {0U, 2U, 3U, 4U}) {
    EXPECT_EQ(solve.trust[s], whole.trust[s]) << s;
  }
  EXPECT_EQ(solve.report.sensors.size(), 4U);
}

}  // namespace
}  // namespace limbwave::solve
