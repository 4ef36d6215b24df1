// From the wires of a driver box to the poses of a whole body: decoder and filter together.
#include <gtest/gtest.h>

#include <algorithm>

#include "evaluate/evaluate.h"
#include "solve/body_solve.h"
#include "support/simulated_take.h"

namespace limbwave {
namespace {

using testing_support::require;

class DriverBoxSolve : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new test::TemporaryFolder;
    simulate::SimulateSettings settings;
    settings.rig = "driver-box-body";
    settings.motion = "walk";
    settings.errors_name = "calibrated";
    settings.seed = 5;
    settings.seconds = 8.0;
    require(simulate::simulate_take(folder_->path() / "walk.take", settings, {}));
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }
  static test::TemporaryFolder* folder_;
};
test::TemporaryFolder* DriverBoxSolve::folder_ = nullptr;

TEST_F(DriverBoxSolve, ReadingsAreThoseOfTheWiresInOrderOfTime) {
  const take::Take take = require(take::open_take(folder_->path() / "walk.take"));
  const estimate::BodyModel model = estimate::body_model(take.info.rig, take.info.skeleton);
  const estimate::BodyReadings readings = require(solve::driver_box_readings(take, model, {}));
  std::vector<int> words(model.boards.size());
  for (const estimate::InertialReading& word : readings.inertial) {
    ASSERT_TRUE(word.w_S.allFinite() && word.f_S.allFinite());
    ++words.at(static_cast<std::size_t>(word.board));
  }
  // Every board speaks from its lock to the end.
  const double expected = take.info.rig.driver_box->word_rate_hz * 8.0;
  EXPECT_EQ(words.size(), 18U);
  EXPECT_GT(*std::min_element(words.begin(), words.end()), 0.95 * expected);
  EXPECT_GT(readings.ranges.size(), 100U);
  for (const estimate::RangeReading& heard : readings.ranges) {
    EXPECT_TRUE(heard.range > 0.0 && heard.range < 3.0 && heard.confidence > 0.0);
    EXPECT_TRUE(heard.source >= 0 && heard.source < 8 && heard.board >= 0 && heard.board < 18);
  }
  EXPECT_TRUE(std::ranges::is_sorted(readings.inertial, {}, &estimate::InertialReading::time_s));
  EXPECT_TRUE(std::ranges::is_sorted(readings.ranges, {}, &estimate::RangeReading::time_s));
}

TEST_F(DriverBoxSolve, ATakeWithoutADriverBoxInItsRigIsRefused) {
  take::Take take = require(take::open_take(folder_->path() / "walk.take"));
  take.info.rig.driver_box.reset();
  const auto solved = solve::solve_sensors(take, {}, {});
  ASSERT_FALSE(solved.ok());
  EXPECT_NE(solved.error().text().find("no driver box"), std::string::npos);
}

TEST_F(DriverBoxSolve, AWalkComesOutOfTheWires) {
  const take::Take take = require(take::open_take(folder_->path() / "walk.take"));
  const solve::BodySolveSettings settings{"wires", "AGD", false, "truth"};
  const solve::Solve solved = require(solve::solve_sensors(take, settings, {}));
  const evaluate::Truth truth = require(evaluate::load_truth(take.folder / "truth.json"));
  const evaluate::Evaluation evaluation = require(evaluate::evaluate(solved.clip, 0.0, truth));
  EXPECT_LT(evaluation.all.mean_deg, 4.0);
  EXPECT_LT(evaluation.all.position_mean_mm, 40.0);
}

}  // namespace
}  // namespace limbwave
