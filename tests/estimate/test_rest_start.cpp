// The start from the rest pose (Vlasic et al. 2007, §5.4).
#include <gmock/gmock.h>

#include "estimate/rest_start.h"
#include "support/worn_boards.h"

namespace limbwave::estimate {
namespace {

using namespace testing_support;
using testing::HasSubstr;

// Somebody who stands, each joint off the rest pose by `off` rad as far as it can turn.
class Standing {
 public:
  explicit Standing(const BodyModel& worn, double off = 0.0, const BoardErrors& errors = {}, unsigned seed = 1)
      : model(worn) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    R_joint.assign(model.skeleton.segments.size(), Eigen::Quaterniond::Identity());
    for (std::size_t s = 1; s < R_joint.size(); ++s) {
      const body::Joint& joint = model.skeleton.segments[s].joint;
      const double angle = off * (normal(random) > 0.0 ? 1.0 : -1.0);
      R_joint[s] = Eigen::Quaterniond(Eigen::AngleAxisd(angle, joint.axis));
    }
    const auto poses = body::poses_from_joints(model.skeleton, R_joint, model.skeleton.segments.front().p_PL);
    readings = read_poses([&](double) { return poses; }, model, 1.2, 100.0, errors, seed);
  }
  BodyModel model;
  std::vector<Eigen::Quaterniond> R_joint;
  BodyReadings readings;
};

double worst_gravity(const BodyFilter& filter, const BodyReadings& readings) {
  body::TreeKinematics kinematics(filter.tree());
  kinematics.update(filter.state().joints, bone_scales(filter.tree(), filter.state()));
  const auto boards = look_at_rest(filter.model(), readings, {});
  double worst = 0.0;
  for (std::size_t b = 0; b < boards.size(); ++b) {
    const BodyBoard& board = filter.model().boards[b];
    const Eigen::Quaterniond R_WS(Eigen::Quaterniond(kinematics.link(filter.tree().link_of(board.segment)).R_WL) *
                                  board.R_LS * filter.state().mount_rotation[b]);
    const Eigen::Vector3d expected =
        R_WS.conjugate() * Eigen::Vector3d(0, 0, kStandardGravity) + filter.state().accelerometer_bias[b];
    worst = std::max(worst, (boards[b].force - expected).norm());
  }
  return worst;
}

TEST(RestStart, PoseAndMountingsAgreeWithGravityAndRatesIntegrateToZero) {
  BoardErrors errors = BoardErrors::worn();
  errors.rate_bias = 0.01;
  const Standing standing(eight_boards(), 0.07, errors);
  BodyFilter filter(standing.model, free_root());
  filter.start(0.0, nullptr);
  const double before = worst_gravity(filter, standing.readings);
  const Result<RestStart> start = start_at_rest(filter, standing.readings, {}, nullptr);
  ASSERT_TRUE(start.ok());
  EXPECT_TRUE(start->diagnostics.empty());
  EXPECT_GT(before, 0.5);
  EXPECT_LT(worst_gravity(filter, standing.readings), 0.12);  // scale and offsets are left: the prior of 0.1 m/s²
  for (std::size_t b = 0; b < standing.model.boards.size(); ++b) {
    Eigen::Vector3d turned = Eigen::Vector3d::Zero();
    int count = 0;
    for (const InertialReading& reading : standing.readings.inertial) {
      if (reading.board == static_cast<int>(b) && reading.time_s <= 1.0) {
        turned += (reading.w_S - filter.state().gyroscope_bias[b]) / 100.0;
        ++count;
      }
    }
    EXPECT_LT(turned.norm(), 1e-9) << count;
  }
}

// What gravity can tell of a hinge, it tells: a knee that is bent.
TEST(RestStart, FindsABentKnee) {
  const Standing standing(eight_boards(), 0.06);
  BodyFilter filter(standing.model, free_root());
  ASSERT_TRUE(start_at_rest(filter, standing.readings, {}, nullptr).ok());
  const auto found = filter.tree().segment_rotations(filter.state().joints);
  const auto knee = static_cast<std::size_t>(standing.model.skeleton.find("left_shin"));
  const double error = geometry::geodesic_angle(found[knee], standing.R_joint[knee]);
  EXPECT_LT(error, 0.7 * 0.06);  // shared with the mountings, whose prior is as wide
}

TEST(RestStart, RefusesWhoMovedAndSaysWhich) {
  Standing standing(eight_boards(), 0.0, BoardErrors::worn());
  for (InertialReading& reading : standing.readings.inertial) {
    if (reading.board == 3) {
      reading.w_S.y() += 0.3 * std::sin(9.0 * reading.time_s);
    }
  }
  BodyFilter filter(standing.model, free_root());
  RestParameters rest;
  rest.mode = StartMode::kRest;
  const Result<RestStart> refused = start_at_rest(filter, standing.readings, rest, nullptr);
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(refused.error().message, HasSubstr("\"left_shin\" moved"));
  EXPECT_THAT(refused.error().message, testing::Not(HasSubstr("right_shin")));
  EXPECT_THAT(refused.error().remedy, HasSubstr("standing still"));
  // Otherwise it is told, and the others' biases are known all the same.
  rest.mode = StartMode::kAny;
  const Result<RestStart> told = start_at_rest(filter, standing.readings, rest, nullptr);
  ASSERT_TRUE(told.ok());
  EXPECT_TRUE(mentions(told->diagnostics, "body.not-still", "left_shin"));
  EXPECT_FALSE(told->moving);
}

TEST(RestStart, SomebodyWhoWalksStartsInMidMotion) {
  const BodyModel model = eight_boards();
  const WalkingPerson person(model.skeleton);
  BodyReadings readings =
      read_poses([&](double t) { return person.poses(t + 8.0); }, model, 1.5, 100.0, BoardErrors::worn());
  BodyFilter filter(model, free_root());
  const Result<RestStart> start = start_at_rest(filter, readings, {}, nullptr);
  ASSERT_TRUE(start.ok());
  EXPECT_TRUE(start->moving);
  EXPECT_TRUE(mentions(start->diagnostics, "body.starts-moving"));
}

TEST(RestStart, ABoardUpsideDownIsNamedAndLeftOut) {
  Standing standing(eight_boards(), 0.0, BoardErrors::worn());
  const Eigen::Quaterniond half(Eigen::AngleAxisd(EIGEN_PI, Eigen::Vector3d::UnitZ()));
  for (InertialReading& reading : standing.readings.inertial) {
    if (reading.board == 3) {
      reading.f_S = half * reading.f_S;
      reading.w_S = half * reading.w_S;
    }
  }
  BodyFilter filter(standing.model, free_root());
  const Result<RestStart> start = start_at_rest(filter, standing.readings, {}, nullptr);
  ASSERT_TRUE(start.ok());
  EXPECT_TRUE(mentions(start->diagnostics, "body.board-turned", "left_shin"));
  EXPECT_EQ(std::count_if(start->boards.begin(), start->boards.end(), [](const auto& b) { return b.turned; }), 1);
  for (const Eigen::Quaterniond& mount : filter.state().mount_rotation) {
    EXPECT_LT(geometry::geodesic_angle(mount, Eigen::Quaterniond::Identity()), 0.1);
  }
}

// Sitting is no defect of the sensors.
TEST(RestStart, AnotherPoseIsNoMountingError) {
  BodyModel model = eight_boards();
  std::vector<Eigen::Quaterniond> R(model.skeleton.segments.size(), Eigen::Quaterniond::Identity());
  for (const char* side : {"left_", "right_"}) {
    R[static_cast<std::size_t>(model.skeleton.find(std::string(side) + "thigh"))] =
        Eigen::AngleAxisd(radians(-80.0), Eigen::Vector3d::UnitY());
    R[static_cast<std::size_t>(model.skeleton.find(std::string(side) + "shin"))] =
        Eigen::AngleAxisd(radians(80.0), Eigen::Vector3d::UnitY());
  }
  const auto poses = body::poses_from_joints(model.skeleton, R, model.skeleton.segments.front().p_PL);
  const BodyReadings readings = read_poses([&](double) { return poses; }, model, 1.2, 100.0, BoardErrors::worn());
  BodyFilter filter(model, free_root());
  const Result<RestStart> start = start_at_rest(filter, readings, {}, nullptr);
  ASSERT_TRUE(start.ok());
  EXPECT_TRUE(start->strange);
  EXPECT_TRUE(mentions(start->diagnostics, "body.not-rest-pose"));
  EXPECT_LT(worst_gravity(filter, readings), 0.3);
  const auto found = filter.tree().segment_rotations(filter.state().joints);
  const auto thigh = static_cast<std::size_t>(model.skeleton.find("left_thigh"));
  EXPECT_LT(geometry::geodesic_angle(found[thigh], R[thigh]), radians(8.0));
}

}  // namespace
}  // namespace limbwave::estimate
