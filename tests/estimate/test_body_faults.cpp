// Sensors that fail, are mixed up or lie: nothing diverges, and what happened is told.
#include <gmock/gmock.h>

#include "estimate/sensor_mixup.h"
#include "support/worn_boards.h"

namespace limbwave::estimate {
namespace {

using namespace testing_support;

constexpr int kLeftShin = 3;

class Walk {
 public:
  explicit Walk(BodyModel worn, double seconds = 9.0, unsigned seed = 2)
      : model(std::move(worn)), person(model.skeleton) {
    readings =
        read_poses([this](double t) { return person.poses(t); }, model, seconds, 100.0, BoardErrors::worn(), seed);
  }
  struct Outcome {
    double legs = 0.0, right = 0.0, late = 0.0;  // mean errors, degrees
    Diagnostics found;
    BodyRun run;
    std::vector<int> suspects;
  };
  [[nodiscard]] Outcome solve(RootMode root = RootMode::kGiven) const {
    BodyFilterParameters p;
    p.root = root;
    BodyWatch watch(model, {});
    Result<BodyRun> run = filter_body(model, p, readings, 50.0, {}, &watch);
    EXPECT_TRUE(run.ok());
    Outcome out;
    const PosesAt poses = [this](double t) { return person.poses(t); };
    out.legs = joint_error(run->track, poses, model.skeleton, legs());
    out.right = joint_error(run->track, poses, model.skeleton, {"right_thigh", "right_shin", "right_foot"});
    out.late = joint_error(run->track, poses, model.skeleton, legs(), run->track.times.back() - 1.5);
    out.found = run->diagnostics;
    const Diagnostics since = watch.findings();
    out.found.insert(out.found.end(), since.begin(), since.end());
    out.suspects = suspicious_boards(model, *run, watch);
    out.run = *std::move(run);
    return out;
  }
  BodyModel model;
  WalkingPerson person;
  BodyReadings readings;
};

TEST(BodyFaults, AHealthyWalkIsNotReported) {
  const Walk walk(eight_boards());
  const Walk::Outcome out = walk.solve();
  for (const Diagnostic& d : out.found) {
    EXPECT_EQ(d.severity, Severity::kInfo) << d.text();
  }
  EXPECT_TRUE(out.suspects.empty());
  EXPECT_LT(out.legs, 4.0);
  std::printf("healthy: legs %.2f deg\n", out.legs);
}

TEST(BodyFaults, ABoardDeadFromTheStart) {
  Walk walk(eight_boards());
  std::erase_if(walk.readings.inertial, [](const InertialReading& r) { return r.board == kLeftShin; });
  const Walk::Outcome out = walk.solve();
  EXPECT_TRUE(mentions(out.found, "body.board-dead", "\"left_shin\" was never heard"));
  EXPECT_LT(out.right, 4.0);
  std::printf("dead: legs %.2f, right leg %.2f deg\n", out.legs, out.right);
}

TEST(BodyFaults, ABoardThatDiesInMidTake) {
  for (const bool frozen : {false, true}) {
    Walk walk(eight_boards());
    Eigen::Vector3d w(0, 0, 0), f(0, 0, 9.8);
    std::erase_if(walk.readings.inertial, [&](InertialReading& r) {
      if (r.board != kLeftShin) {
        return false;
      }
      if (r.time_s < 5.0) {
        w = r.w_S;
        f = r.f_S;
        return false;
      }
      r.w_S = w;
      r.f_S = f;
      return !frozen;
    });
    const Walk::Outcome out = walk.solve();
    EXPECT_TRUE(mentions(out.found, frozen ? "body.board-frozen" : "body.board-died", "\"left_shin\"")) << frozen;
    EXPECT_TRUE(mentions(out.found, frozen ? "body.board-frozen" : "body.board-died", "from 5.0 s on")) << frozen;
    EXPECT_LT(out.right, 4.0);
    for (const auto& sigma : out.run.track.sigma) {
      EXPECT_LT(*std::max_element(sigma.begin(), sigma.end()), 6.0);  // rad: bounded, however long
    }
    std::printf("dies: legs %.2f, right leg %.2f deg\n", out.legs, out.right);
  }
}

TEST(BodyFaults, ABoardThatComesBackIsUsedAgain) {
  Walk walk(eight_boards());
  std::erase_if(walk.readings.inertial,
                [](const InertialReading& r) { return r.board == kLeftShin && r.time_s > 4.5 && r.time_s < 6.0; });
  const Walk::Outcome out = walk.solve();
  EXPECT_TRUE(mentions(out.found, "body.board-silent", "from 4.5 s on until 6.0 s"));
  EXPECT_LT(out.late, 4.5);
}

TEST(BodyFaults, FiveSecondsOfBlackout) {
  Walk walk(eight_boards(), 13.0);
  const auto dark = [](const auto& r) { return r.time_s > 4.5 && r.time_s < 9.5; };
  std::erase_if(walk.readings.inertial, dark);
  for (const RootMode root : {RootMode::kGiven, RootMode::kFree}) {
    const Walk::Outcome out = walk.solve(root);
    EXPECT_TRUE(mentions(out.found, "body.blackout", "for 5.0 s from 4.5 s on"));
    EXPECT_FALSE(mentions(out.found, "body.board-silent"));
    std::printf("blackout: last 1.5 s %.2f deg\n", out.late);
    EXPECT_LT(out.late, 12.0);
  }
}

TEST(BodyFaults, NeighboursExchangedAreNamedAndPutRight) {
  Walk walk(eight_boards(), 8.0);
  const Walk::Outcome healthy = walk.solve();
  for (InertialReading& r : walk.readings.inertial) {
    r.board = r.board == 2 ? kLeftShin : (r.board == kLeftShin ? 2 : r.board);
  }
  const Walk::Outcome wrong = walk.solve();
  ASSERT_FALSE(wrong.suspects.empty());
  BodyFilterParameters p;
  p.root = RootMode::kGiven;
  const auto mixup = find_mixup(walk.model, p, {}, walk.readings, wrong.suspects, {});
  ASSERT_TRUE(mixup.ok());
  ASSERT_TRUE(mixup->has_value());
  EXPECT_EQ((*mixup)->board, kLeftShin);
  EXPECT_EQ((*mixup)->other, 2);
  EXPECT_THAT(tell(**mixup, walk.model).text(), testing::HasSubstr("\"left_thigh\" and \"left_shin\" are exchanged"));
  undo_mixup(**mixup, walk.readings);
  const Walk::Outcome right = walk.solve();
  EXPECT_DOUBLE_EQ(right.legs, healthy.legs);
  EXPECT_GT(wrong.legs, 2.0 * right.legs);
}

TEST(BodyFaults, LeftAndRightExchangedAreNamed) {
  Walk walk(eight_boards(), 8.0);
  for (InertialReading& r : walk.readings.inertial) {
    r.board = r.board == 2 ? 5 : (r.board == 5 ? 2 : r.board);
  }
  const Walk::Outcome wrong = walk.solve();
  BodyFilterParameters p;
  p.root = RootMode::kGiven;
  const auto mixup = find_mixup(walk.model, p, {}, walk.readings, wrong.suspects, {});
  ASSERT_TRUE(mixup.ok() && mixup->has_value());
  EXPECT_EQ((*mixup)->board, 5);
  EXPECT_EQ((*mixup)->other, 2);
}

TEST(BodyFaults, ABoardUpsideDownIsFoundAndTurned) {
  for (int axis = 0; axis < 3; ++axis) {
    Walk walk(eight_boards(), 8.0);
    const Eigen::Quaterniond half(Eigen::AngleAxisd(EIGEN_PI, Eigen::Vector3d::Unit(axis)));
    for (InertialReading& r : walk.readings.inertial) {
      if (r.board == kLeftShin) {
        r.w_S = half * r.w_S;
        r.f_S = half * r.f_S;
      }
    }
    const Walk::Outcome wrong = walk.solve();
    ASSERT_FALSE(wrong.suspects.empty()) << axis;
    BodyFilterParameters p;
    p.root = RootMode::kGiven;
    const auto mixup = find_mixup(walk.model, p, {}, walk.readings, wrong.suspects, {});
    ASSERT_TRUE(mixup.ok() && mixup->has_value()) << axis;
    EXPECT_EQ((*mixup)->board, kLeftShin) << axis;
    EXPECT_EQ((*mixup)->axis, axis);
  }
}

TEST(BodyFaults, AThirdOfRangesWrongByUpToHalfAMetre) {
  BodyModel model = eight_boards();
  for (BodyBoard& board : model.boards) {
    board.microphone = true;
  }
  const int pelvis = model.skeleton.find("pelvis");
  model.sources = {{"a", pelvis, {0.05, 0.08, -0.12}, -Vector3d::UnitZ()},
                   {"b", pelvis, {0.05, -0.08, -0.12}, -Vector3d::UnitZ()},
                   {"c", model.skeleton.find("chest"), {0.1, 0.0, -0.12}, -Vector3d::UnitZ()}};
  Walk walk(model, 8.0);
  const Walk::Outcome clean = walk.solve();
  std::mt19937 random(8);
  std::uniform_real_distribution<double> off(-0.5, 0.5);
  std::uniform_real_distribution<double> dice(0.0, 1.0);
  for (RangeReading& r : walk.readings.ranges) {
    r.range += dice(random) < 0.3 ? off(random) : 0.0;
  }
  const Walk::Outcome wrong = walk.solve();
  std::printf("ranges: clean %.2f, a third wrong %.2f deg\n", clean.legs, wrong.legs);
  EXPECT_LT(wrong.legs, clean.legs + 0.7);
  std::int64_t gated = 0;
  std::int64_t all = 0;
  for (const ReadingCount& count : wrong.run.ranges) {
    gated += count.gated;
    all += count.gated + count.used;
  }
  EXPECT_NEAR(static_cast<double>(gated) / static_cast<double>(all), 0.3, 0.05);
}

// Silence that the box fills with nothing, noise that is no reading: no NaN may come through.
TEST(BodyFaults, NotANumberComesNowhereThrough) {
  Walk walk(eight_boards(), 6.0);
  for (std::size_t i = 0; i < walk.readings.inertial.size(); i += 7) {
    walk.readings.inertial[i].f_S.x() = i % 2 == 0 ? INFINITY : kMissing;
    walk.readings.inertial[i].w_S.z() = i % 3 == 0 ? -INFINITY : kMissing;
  }
  const Walk::Outcome out = walk.solve();
  EXPECT_LT(out.legs, 5.0);
}

}  // namespace
}  // namespace limbwave::estimate
