/// The bars of the line-in path, on simulated takes: from a motion over the wire to inclinations.
#include <gtest/gtest.h>

#include "evaluate/evaluate.h"
#include "integration/accuracy.h"
#include "solve/compose.h"
#include "solve/solve.h"

namespace limbwave {
namespace {

using testing_support::ErrorFigures;
using testing_support::require;
using testing_support::SensorTruth;
using testing_support::simulated;
using testing_support::still_pose_errors;
using testing_support::TemporaryFolder;
using testing_support::usable_share;
using testing_support::wire_errors;
using testing_support::WireErrors;

// A decoder that left out whatever is difficult would meet any bar.
constexpr double kUsable = 0.995;

simulate::SimulateSettings settings(const std::string& motion, const std::string& errors, std::uint64_t seed) {
  simulate::SimulateSettings s;
  s.motion = motion;
  s.errors_name = errors;
  s.errors = require(simulate::load_errors(errors));
  s.seed = seed;
  return s;
}

TEST(LineInAccuracy, WithoutErrorsAccelerationsAreExact) {
  for (const char* motion : {"wave", "every-joint"}) {
    const TemporaryFolder folder;
    simulate::SimulateSettings s = settings(motion, "none", 11);
    s.format.type = acquire::SampleType::kFloat32;
    s.prologue = false;
    const take::Take take = simulated(folder / "none.take", s);
    const solve::DecodedTake decoded = require(solve::decode_take(take, {}, {}));
    const WireErrors errors = wire_errors(take, decoded);
    ASSERT_GT(errors.acceleration_g.count, 1000U);
    EXPECT_GE(errors.usable, kUsable) << motion;
    RecordProperty(std::string(motion) + "_max_g", std::to_string(errors.acceleration_g.max));
    EXPECT_LE(errors.acceleration_g.max, 1e-4) << motion;
  }
}

TEST(LineInAccuracy, WithoutErrorsOrientationsAreExact) {
  const TemporaryFolder folder;
  simulate::SimulateSettings s = settings("still", "none", 12);
  s.format.type = acquire::SampleType::kFloat32;
  const take::Take take = simulated(folder / "still.take", s);
  for (const char* calibration : {"nominal", "auto"}) {
    solve::SolveSettings wanted;
    wanted.calibration = calibration;
    solve::Solve solve = require(solve::solve_take(take, wanted, {}));
    const ErrorFigures inclination = still_pose_errors(take, solve);
    ASSERT_GT(inclination.count, 1000U);
    EXPECT_GE(usable_share(take, solve), kUsable) << calibration;
    RecordProperty(std::string("max_deg_") + calibration, std::to_string(inclination.max));
    EXPECT_LE(inclination.max, 0.01) << calibration;
  }
}

TEST(LineInAccuracy, HeadingKeysCompleteTheOrientation) {
  const TemporaryFolder folder;
  simulate::SimulateSettings s = settings("still", "none", 13);
  s.format.type = acquire::SampleType::kFloat32;
  s.prologue = false;
  const take::Take take = simulated(folder / "still.take", s);
  solve::Solve solve = require(solve::solve_take(take, {}, {}));
  const evaluate::Truth truth = require(evaluate::load_truth(take.folder / "truth.json"));
  // What a user would key, at every held pose: the heading of the truth there.
  const SensorTruth felt(take.folder);
  std::vector<std::vector<solve::HeadingKey>> headings(truth.segments.size());
  const std::vector<double> times = solve.clip.joints.front().rotation.times;
  for (std::size_t seg = 0; seg < truth.segments.size(); ++seg) {
    double previous = 0.0;
    for (const double time : times) {
      const auto& segment = truth.segments[seg];
      const auto nearest = std::min<std::size_t>(
          static_cast<std::size_t>(std::lower_bound(segment.times.begin(), segment.times.end(), time) -
                                   segment.times.begin()),
          segment.times.size() - 1);
      const double heading = geometry::heading_about_vertical(segment.R_WL[nearest]);
      previous += std::remainder(heading - previous, 2.0 * kPi);
      headings[seg].push_back({time, previous});
    }
  }
  solve::apply_headings(solve, solve::sensor_segments(take.info.rig, take.info.skeleton), headings);
  const std::vector<std::vector<Eigen::Quaterniond>> R_WL = solve::world_orientations(solve.clip);
  double worst = 0.0;
  std::size_t held = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!felt.holding(times[i])) {
      continue;
    }
    ++held;
    for (std::size_t seg = 0; seg < truth.segments.size(); ++seg) {
      const auto& segment = truth.segments[seg];
      const auto nearest = static_cast<std::size_t>(
          std::lower_bound(segment.times.begin(), segment.times.end(), times[i]) - segment.times.begin());
      worst = std::max(worst, degrees(geometry::geodesic_angle(segment.R_WL.at(nearest), R_WL[i][seg])));
    }
  }
  ASSERT_GT(held, 100U);
  EXPECT_LE(worst, 0.01);
}

class Electronics : public testing::TestWithParam<double> {};

TEST_P(Electronics, AddsLittle) {
  for (const char* motion : {"still", "reach"}) {
    const TemporaryFolder folder;
    simulate::SimulateSettings s = settings(motion, "electronics", 21);
    s.format.rate = SampleRate{GetParam()};
    s.prologue = false;
    const take::Take take = simulated(folder / "electronics.take", s);
    const solve::DecodedTake decoded = require(solve::decode_take(take, {}, {}));
    const WireErrors errors = wire_errors(take, decoded);
    ASSERT_GT(errors.inclination_deg.count, 1000U);
    EXPECT_GE(errors.usable, kUsable) << motion;
    RecordProperty(std::string(motion) + "_usable", std::to_string(errors.usable));
    RecordProperty(std::string(motion) + "_mean_deg", std::to_string(errors.inclination_deg.mean));
    RecordProperty(std::string(motion) + "_max_deg", std::to_string(errors.inclination_deg.max));
    EXPECT_LE(errors.inclination_deg.mean, 0.15) << motion;
    EXPECT_LE(errors.inclination_deg.max, 0.5) << motion;
  }
}

INSTANTIATE_TEST_SUITE_P(Rates, Electronics, testing::Values(44100.0, 48000.0, 96000.0, 192000.0));

TEST(LineInAccuracy, AccurateCalibrationReachesTheBar) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const TemporaryFolder folder;
    const take::Take take = simulated(folder / "accurate.take", settings("still", "accurate", seed));
    const solve::Solve solve = require(solve::solve_take(take, {}, {}));
    const ErrorFigures figures = still_pose_errors(take, solve);
    ASSERT_GT(figures.count, 1000U);
    EXPECT_GE(usable_share(take, solve), kUsable) << "seed " << seed;
    EXPECT_LE(figures.mean, 0.5) << "seed " << seed;
    EXPECT_LE(figures.max, 1.5) << "seed " << seed;
  }
}

TEST(LineInAccuracy, QuickCalibrationIsNoWorseThanThePaper) {
  const TemporaryFolder folder;
  const take::Take take = simulated(folder / "quick.take", settings("still", "paper", 4));
  const solve::Solve solve = require(solve::solve_take(take, {}, {}));
  const ErrorFigures figures = still_pose_errors(take, solve);
  ASSERT_GT(figures.count, 1000U);
  EXPECT_GE(usable_share(take, solve), kUsable);
  EXPECT_LE(figures.mean, 6.0);
  EXPECT_LE(figures.max, 13.0);
}

}  // namespace
}  // namespace limbwave
