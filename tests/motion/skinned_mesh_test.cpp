#include "motion/skinned_mesh.h"

#include <gtest/gtest.h>

#include <limits>

#include "motion/clip.h"

namespace limbwave::motion {
namespace {

using Eigen::Vector3f;

// Two bones along x, 1 m each, and a vertex in the middle of each and one at the joint between, moved by both.
struct Arm {
  body::Skeleton skeleton;
  SkinnedMesh mesh;

  Arm() {
    body::Segment upper;
    upper.name = "upper";
    upper.length = 1.0;
    body::Segment fore;
    fore.name = "fore";
    fore.parent = 0;
    fore.p_PL = {1, 0, 0};
    fore.length = 1.0;
    skeleton.segments = {upper, fore};
    mesh.name = "skin";
    mesh.positions = {{0.5F, 0, 0}, {1.5F, 0, 0}, {1, 0, 0.1F}};
    mesh.triangles = {{0, 1, 2}};
    mesh.segments = {{0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}};
    mesh.weights = {{1, 0, 0, 0}, {1, 0, 0, 0}, {0.5F, 0.5F, 0, 0}};
  }
};

TEST(SkinnedMesh, StaysWhereItIsAtRest) {
  const Arm arm;
  const std::vector<Vector3f> at_rest = deformed(arm.mesh, arm.skeleton, rest_poses(arm.skeleton));
  for (std::size_t v = 0; v < at_rest.size(); ++v) {
    EXPECT_LT((at_rest[v] - arm.mesh.positions[v]).norm(), 1e-6F);
  }
}

TEST(SkinnedMesh, FollowsItsBonesAndBlendsBetween) {
  const Arm arm;
  std::vector<body::SegmentPose> poses = rest_poses(arm.skeleton);
  poses[1].R_WL = Eigen::Quaterniond(Eigen::AngleAxisd(1.5707963267948966, Eigen::Vector3d::UnitZ()));
  const std::vector<Vector3f> bent = deformed(arm.mesh, arm.skeleton, poses);
  EXPECT_LT((bent[0] - Vector3f(0.5F, 0, 0)).norm(), 1e-6F);
  EXPECT_LT((bent[1] - Vector3f(1, 0.5F, 0)).norm(), 1e-6F);
  EXPECT_LT((bent[2] - Vector3f(1, 0, 0.1F)).norm(), 1e-6F);
}

TEST(SkinnedMesh, IsBoundWhereItSays) {
  Arm arm;
  std::vector<body::SegmentPose> poses = rest_poses(arm.skeleton);
  poses[1].R_WL = Eigen::Quaterniond(Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitY()));
  poses[1].p_WL += Eigen::Vector3d(0, 0.2, 0);
  arm.mesh.bind_poses = poses;
  const std::vector<Vector3f> bound = deformed(arm.mesh, arm.skeleton, poses);
  for (std::size_t v = 0; v < bound.size(); ++v) {
    EXPECT_LT((bound[v] - arm.mesh.positions[v]).norm(), 1e-6F);
  }
}

TEST(SkinnedMesh, NamesWhatIsWrong) {
  const Arm good;
  EXPECT_TRUE(validate(good.mesh, good.skeleton).ok());
  Arm arm;
  arm.mesh.weights[2] = {0.5F, 0.4F, 0, 0};
  EXPECT_EQ(validate(arm.mesh, arm.skeleton).error().message, "the weights of vertex 2 sum to 0.9, not 1");
  arm = Arm();
  arm.mesh.segments[1][0] = 2;
  EXPECT_EQ(validate(arm.mesh, arm.skeleton).error().message, "vertex 1 has a wrong bone or weight");
  arm = Arm();
  arm.mesh.triangles[0][1] = 3;
  EXPECT_EQ(validate(arm.mesh, arm.skeleton).error().message, "triangle 0 has a corner beyond the 3 vertices");
  arm = Arm();
  arm.mesh.positions[2].x() = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(validate(arm.mesh, arm.skeleton).error().message, "vertex 2 has a number that is not finite");
  arm = Arm();
  arm.mesh.weights.pop_back();
  EXPECT_FALSE(validate(arm.mesh, arm.skeleton).ok());
}

}  // namespace
}  // namespace limbwave::motion
