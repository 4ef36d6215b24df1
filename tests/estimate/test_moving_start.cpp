// Recordings that begin in mid-motion are started from their first seconds.
#include "estimate/moving_start.h"
#include "support/worn_boards.h"

namespace limbwave::estimate {
namespace {

using namespace testing_support;

// Boards on trunk and legs hear five sources on the trunk.
BodyModel hearing_boards() {
  BodyModel model = eight_boards();
  for (BodyBoard& board : model.boards) {
    board.microphone = true;
  }
  const int chest = model.skeleton.find("chest");
  const int pelvis = model.skeleton.find("pelvis");
  model.sources = {{"upper left", chest, {0.20, 0.10, -0.12}, {0, 0, -1}},
                   {"upper right", chest, {0.20, -0.10, -0.12}, {0, 0, -1}},
                   {"lower left", chest, {0.02, 0.12, -0.12}, {0, 0, -1}},
                   {"left", pelvis, {0.05, 0.10, -0.11}, {0, 0, -1}},
                   {"right", pelvis, {0.05, -0.10, -0.11}, {0, 0, -1}}};
  return model;
}

// A walker whose recording begins with one knee high: far from the rest pose, and turning.
std::vector<body::SegmentPose> mid_stride(const WalkingPerson& person, double t) {
  return person.poses(t + 5.93);
}

TEST(MovingStart, AWalkerIsFoundInMidStride) {
  const BodyModel model = hearing_boards();
  const WalkingPerson person(model.skeleton);
  const auto poses = [&](double t) { return mid_stride(person, t); };
  const BodyReadings readings = read_poses(poses, model, 2.5, 60.0, BoardErrors::worn(), 3);
  const auto found = find_moving_start(model, free_root(), {}, readings, {});
  ASSERT_TRUE(found.ok());
  ASSERT_TRUE(found->has_value());
  double error[2];
  for (const bool near : {false, true}) {
    BodyWatch watch(model, {});
    if (near) {
      watch.start_near(**found);
    }
    const auto run = smooth_body(model, free_root(), readings, 50.0, {}, 1.5, &watch);
    ASSERT_TRUE(run.ok());
    error[near ? 1 : 0] = joint_error(run->track, poses, model.skeleton, legs());
  }
  std::printf("legs: from the rest pose %.2f degrees, from the start that was found %.2f\n", error[0], error[1]);
  EXPECT_LT(error[1], error[0]);
  EXPECT_LT(error[1], 4.0);
}

TEST(MovingStart, WhoRestsInTheRestPoseStartsThere) {
  const BodyModel model = hearing_boards();
  const WalkingPerson person(model.skeleton);
  const BodyReadings readings =
      read_poses([&](double t) { return person.poses(t); }, model, 1.5, 60.0, BoardErrors::worn(), 3);
  const auto found = find_moving_start(model, free_root(), {}, readings, {});
  ASSERT_TRUE(found.ok());
  EXPECT_FALSE(found->has_value());
}

TEST(MovingStart, WithoutRangesThereIsNothingToFindItBy) {
  const BodyModel model = eight_boards();
  const WalkingPerson person(model.skeleton);
  const BodyReadings readings =
      read_poses([&](double t) { return mid_stride(person, t); }, model, 1.0, 60.0, BoardErrors::worn(), 3);
  const auto found = find_moving_start(model, free_root(), {}, readings, {});
  ASSERT_TRUE(found.ok());
  EXPECT_FALSE(found->has_value());
}

TEST(MovingStart, StopsWhenAskedTo) {
  const BodyModel model = hearing_boards();
  const WalkingPerson person(model.skeleton);
  const BodyReadings readings =
      read_poses([&](double t) { return mid_stride(person, t); }, model, 1.0, 60.0, BoardErrors::worn(), 3);
  const Progress stop([](double, std::string_view) { return false; });
  EXPECT_FALSE(find_moving_start(model, free_root(), {}, readings, stop).ok());
}

}  // namespace
}  // namespace limbwave::estimate
