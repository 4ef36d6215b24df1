#include <gtest/gtest.h>

#include "base/units.h"
#include "body/skeleton.h"
#include "geometry/so3.h"

namespace limbwave::body {
namespace {

Skeleton arm() {
  Result<Skeleton> skeleton = load_skeleton("arm");
  EXPECT_TRUE(skeleton.ok());
  return std::move(skeleton).value();
}

TEST(Kinematics, RestPoseStandsWithTheArmHanging) {
  const Skeleton skeleton = arm();
  const std::vector<SegmentPose> poses =
      poses_from_joints(skeleton, std::vector<Quaterniond>(5, Quaterniond::Identity()), skeleton.segments[0].p_PL);
  EXPECT_NEAR((poses[0].R_WL * Vector3d::UnitX() - Vector3d::UnitZ()).norm(), 0.0, 1e-12);
  for (std::size_t s = 1; s < 5; ++s) {
    EXPECT_NEAR((poses[s].R_WL * Vector3d::UnitX() + Vector3d::UnitZ()).norm(), 0.0, 1e-12) << s;
  }
  // The shoulder is to the right, hip height plus its height on the torso.
  EXPECT_NEAR((poses[1].p_WL - Vector3d(0.0, -0.19, 0.97 + 0.46)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(poses[2].p_WL.z(), 0.97 + 0.46 - 0.30, 1e-12);
}

TEST(Kinematics, BentElbowBringsTheForearmForward) {
  const Skeleton skeleton = arm();
  std::vector<Quaterniond> joints(5, Quaterniond::Identity());
  joints[2] = geometry::exp_so3(radians(90.0) * skeleton.segments[2].joint.axis);
  const std::vector<SegmentPose> poses = poses_from_joints(skeleton, joints, Vector3d::Zero());
  EXPECT_NEAR((poses[2].R_WL * Vector3d::UnitX() - Vector3d::UnitX()).norm(), 0.0, 1e-12);
  EXPECT_NEAR((poses[3].p_WL - poses[2].p_WL - Vector3d(0.26, 0.0, 0.0)).norm(), 0.0, 1e-12);
}

TEST(Kinematics, OrientationsAndJointsAgree) {
  const Skeleton skeleton = arm();
  std::vector<Quaterniond> joints;
  for (int i = 0; i < 5; ++i) {
    joints.push_back(geometry::exp_so3(Vector3d(0.3 * i, -0.5, 0.2 * i)));
  }
  const Vector3d root(1.0, 2.0, 3.0);
  const std::vector<SegmentPose> poses = poses_from_joints(skeleton, joints, root);
  std::vector<Quaterniond> R_WL;
  for (const SegmentPose& pose : poses) {
    R_WL.push_back(pose.R_WL);
  }
  const std::vector<SegmentPose> again = poses_from_orientations(skeleton, R_WL, root);
  for (std::size_t s = 0; s < 5; ++s) {
    EXPECT_NEAR((again[s].p_WL - poses[s].p_WL).norm(), 0.0, 1e-12);
  }
  // Bones keep their lengths whatever the pose.
  EXPECT_NEAR((poses[3].p_WL - poses[2].p_WL).norm(), skeleton.segments[2].length, 1e-12);
}

}  // namespace
}  // namespace limbwave::body
