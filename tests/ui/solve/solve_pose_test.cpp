#include "workspaces/solve/solve_pose.h"

#include <gtest/gtest.h>

#include "solve/compose.h"
#include "ui/support/solve_fixture.h"

namespace limbwave::ui::testing {
namespace {

struct Poses : ::testing::Test {
  take::Take take = made_up_take(QStringLiteral("/tmp/none.take"), 4.0);
  solve::Solve solved = made_up_solve(take, {}, 4.0);
  std::vector<bool> sensed = segments_with_sensors(take.info.rig, take.info.skeleton);
};

double difference(const std::vector<body::SegmentPose>& a, const std::vector<body::SegmentPose>& b) {
  double most = a.size() == b.size() ? 0.0 : 1e9;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    most = std::max({most, (a[i].p_WL - b[i].p_WL).norm(), a[i].R_WL.angularDistance(b[i].R_WL)});
  }
  return most;
}

TEST_F(Poses, WithoutEditsTheyAreTheClips) {
  std::vector<body::SegmentPose> poses;
  for (const double t : {0.0, 1.234, 4.0, 9.0}) {
    edited_pose(
        solved.clip, solved.clip.skeleton, sensed, [](int, double) { return 0.0; }, t, poses);
    EXPECT_LT(difference(poses, motion::pose_at(solved.clip, t)), 1e-12);
  }
}

// The quick way of the viewer and the thorough way of saving give the same figure.
TEST_F(Poses, HeadingsTurnAsWhenTheyAreWrittenIntoTheClip) {
  std::vector<std::vector<solve::HeadingKey>> keys(take.info.skeleton.segments.size());
  keys[1] = {{0.5, 0.4}, {3.0, -1.0}};
  keys[3] = {{1.0, 0.8}};
  solve::Solve written = solved;
  solve::apply_headings(written, solve::sensor_segments(take.info.rig, take.info.skeleton), keys);
  std::vector<body::SegmentPose> poses;
  for (const double t : {0.0, 0.5, 2.0, 3.5}) {
    edited_pose(
        solved.clip, solved.clip.skeleton, sensed,
        [&](int segment, double time) { return solve::heading_at(keys[static_cast<std::size_t>(segment)], time); }, t,
        poses);
    EXPECT_LT(difference(poses, motion::pose_at(written.clip, t)), 1e-9) << t;
  }
}

// A body filter knows joints of bones without sensors, too: they are not straightened, neither seen nor written.
TEST_F(Poses, BonesWithoutSensorsKeepTheirBend) {
  const std::size_t bare = 2, parent = 1;
  ASSERT_EQ(take.info.skeleton.segments[bare].parent, static_cast<int>(parent));
  sensed[bare] = false;
  const double t = 1.5;
  const auto before = motion::pose_at(solved.clip, t);
  const body::Quaterniond bend = before[parent].R_WL.conjugate() * before[bare].R_WL;
  ASSERT_GT(bend.angularDistance(take.info.skeleton.segments[bare].R_PL_rest), 0.05);
  std::vector<body::SegmentPose> poses;
  edited_pose(
      solved.clip, solved.clip.skeleton, sensed, [](int, double) { return 0.0; }, t, poses);
  EXPECT_LT(difference(poses, before), 1e-12);
  edited_pose(
      solved.clip, solved.clip.skeleton, sensed,
      [&](int segment, double) { return segment == static_cast<int>(parent) ? 0.7 : 0.0; }, t, poses);
  EXPECT_NEAR(poses[parent].R_WL.angularDistance(before[parent].R_WL), 0.7, 1e-9);
  EXPECT_LT((poses[parent].R_WL.conjugate() * poses[bare].R_WL).angularDistance(bend), 1e-9);
  std::vector<std::vector<solve::HeadingKey>> keys(take.info.skeleton.segments.size());
  keys[parent] = {{0.0, 0.7}};
  std::vector<int> segments;
  for (std::size_t s = 0; s < sensed.size(); ++s) {
    segments.push_back(sensed[s] ? static_cast<int>(s) : -1);
  }
  solve::Solve written = solved;
  solve::apply_headings(written, segments, keys);
  EXPECT_LT(difference(poses, motion::pose_at(written.clip, t)), 1e-9);
}

TEST_F(Poses, LengthsMoveTheChildrenOnly) {
  const body::Skeleton longer =
      body::with_length(solved.clip.skeleton, 1, solved.clip.skeleton.segments[1].length + 0.1);
  std::vector<body::SegmentPose> poses;
  edited_pose(
      solved.clip, longer, sensed, [](int, double) { return 0.0; }, 1.0, poses);
  const auto before = motion::pose_at(solved.clip, 1.0);
  EXPECT_LT((poses[1].p_WL - before[1].p_WL).norm(), 1e-12);
  EXPECT_NEAR((poses[2].p_WL - before[2].p_WL).norm(), 0.1, 1e-12);
  EXPECT_LT(poses[2].R_WL.angularDistance(before[2].R_WL), 1e-9);
}

TEST_F(Poses, TruthIsInterpolatedAndGapsFollowTheParent) {
  evaluate::Truth truth;
  EXPECT_TRUE(truth_pose(truth, take.info.skeleton, 1.0).empty());
  const Eigen::Quaterniond turned(Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitZ()));
  truth.segments.push_back({"upper_arm",
                            {0.0, 2.0},
                            {Eigen::Quaterniond::Identity(), turned},
                            {Eigen::Vector3d::Zero(), Eigen::Vector3d(2.0, 0.0, 0.0)}});
  const int upper = take.info.skeleton.find("upper_arm");
  ASSERT_GE(upper, 0);
  const auto poses = truth_pose(truth, take.info.skeleton, 1.0);
  const body::SegmentPose& arm = poses[static_cast<std::size_t>(upper)];
  EXPECT_NEAR(arm.R_WL.angularDistance(Eigen::Quaterniond(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()))), 0, 1e-9);
  EXPECT_LT((arm.p_WL - Eigen::Vector3d(1, 0, 0)).norm(), 1e-12);
  const int fore = take.info.skeleton.find("forearm");
  const body::Segment& child = take.info.skeleton.segments[static_cast<std::size_t>(fore)];
  EXPECT_LT((poses[static_cast<std::size_t>(fore)].p_WL - (arm.p_WL + arm.R_WL * child.p_PL)).norm(), 1e-12);
  truth.segments[0].p_WL[1].setConstant(std::nan(""));
  for (const auto& pose : truth_pose(truth, take.info.skeleton, 1.0)) {
    EXPECT_TRUE(pose.p_WL.allFinite());
  }
}

TEST_F(Poses, ElevationIsTheBonesAngleOverTheHorizontal) {
  const int fore = take.info.skeleton.find("forearm");
  const auto lists = elevations(solved.clip, {fore, -1});
  ASSERT_EQ(lists.size(), 2U);
  ASSERT_EQ(lists[0].size(), solved.clip.joints[0].rotation.times.size());
  for (const std::size_t i : {std::size_t{0}, std::size_t{60}, std::size_t{200}}) {
    const double t = solved.clip.joints[0].rotation.times[i];
    const double expected = 0.7 * std::sin(1.3 * t + 0.5 * fore) - 0.2;
    EXPECT_NEAR(lists[0][i], expected * 180 / M_PI, 1e-3);
    EXPECT_TRUE(std::isnan(lists[1][i]));
  }
}

}  // namespace
}  // namespace limbwave::ui::testing
