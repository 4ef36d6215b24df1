#include "motion/transforms.h"

#include <gtest/gtest.h>

#include <random>

#include "geometry/so3.h"
#include "interchange/random_clip.h"

namespace limbwave::motion {
namespace {

// A random clip with a mesh whose every vertex hangs on two bones.
Clip clip_with_mesh() {
  Clip clip = test::random_clip(9, 50, 60.0, 5);
  auto mesh = std::make_shared<SkinnedMesh>();
  std::mt19937 random(3);
  std::normal_distribution<float> normal;
  for (int v = 0; v < 30; ++v) {
    mesh->positions.push_back({normal(random), normal(random), normal(random)});
    mesh->segments.push_back(
        {static_cast<std::uint16_t>(random() % 9), static_cast<std::uint16_t>(random() % 9), 0, 0});
    mesh->weights.push_back({0.75F, 0.25F, 0, 0});
  }
  clip.meshes = {mesh};
  return clip;
}

// Joints of `b` from `first` on are where those of `a` are, and so is the mesh, `shift` seconds later.
void expect_same_places(const Clip& a, const Clip& b, std::size_t first = 0, double shift = 0.0) {
  for (const double t : key_times(a)) {
    const auto pose_a = pose_at(a, t);
    const auto pose_b = pose_at(b, t + shift);
    ASSERT_EQ(pose_a.size() + first, pose_b.size());
    for (std::size_t i = 0; i < pose_a.size(); ++i) {
      ASSERT_LT((pose_a[i].p_WL - pose_b[i + first].p_WL).norm(), 1e-9) << i << " at " << t;
    }
    const auto mesh_a = deformed(*a.meshes[0], a.skeleton, pose_a);
    const auto mesh_b = deformed(*b.meshes[0], b.skeleton, pose_b);
    for (std::size_t v = 0; v < mesh_a.size(); ++v) {
      ASSERT_LT((mesh_a[v] - mesh_b[v]).norm(), 2e-5F) << "vertex " << v << " at " << t;
    }
  }
}

TEST(Transforms, AnotherRestPoseMovesNothing) {
  const Clip clip = clip_with_mesh();
  const std::vector<Quaterniond> upright(9, Quaterniond::Identity());
  const Clip other = with_rest(clip, upright);
  expect_same_places(clip, other);
  for (const body::SegmentPose& pose : rest_poses(other.skeleton)) {
    EXPECT_LT(geometry::geodesic_angle(pose.R_WL, Quaterniond::Identity()), 1e-9);
  }
}

TEST(Transforms, TurnedBoneFramesMoveNothing) {
  const Clip clip = clip_with_mesh();
  std::vector<Quaterniond> turns;
  for (const Vector3d& bone : bone_directions(clip.skeleton)) {
    turns.push_back(Quaterniond::FromTwoVectors(Vector3d::UnitY(), bone));
  }
  const Clip other = with_bone_frames(clip, turns);
  expect_same_places(clip, other);
  for (const Vector3d& bone : bone_directions(other.skeleton)) {
    // Leaves have no direction of their own: they keep pointing along the old x.
    EXPECT_TRUE((bone - Vector3d::UnitY()).norm() < 1e-9 || bone == Vector3d::UnitX());
  }
}

TEST(Transforms, VelocitiesOfCurvesTurnWithTheirFrames) {
  Clip clip = test::random_clip(2, 3, 2.0, 8);
  for (JointTracks& joint : clip.joints) {
    joint.rotation.interpolation = Interpolation::kCubic;
    joint.rotation.arriving.assign(joint.rotation.times.size(), Vector3d(0.3, -1, 0.5));
    joint.rotation.leaving.assign(joint.rotation.times.size(), Vector3d(1, 2, -0.5));
  }
  const std::vector<Quaterniond> turns(2, geometry::exp_so3(Vector3d(0.4, 1, 2)));
  const Clip other = with_bone_frames(clip, turns);
  for (double t = 0.0; t < 1.0; t += 0.07) {
    const auto a = pose_at(clip, t);
    const auto b = pose_at(other, t);
    EXPECT_LT(geometry::geodesic_angle(a[1].R_WL * turns[1], b[1].R_WL), 1e-9) << t;
  }
}

TEST(Transforms, ARootBoneStandsInFrontAndMovesNothing) {
  const Clip clip = clip_with_mesh();
  const Clip other = with_root_bone(clip, "root");
  EXPECT_EQ(other.skeleton.segments[0].name, "root");
  EXPECT_EQ(other.skeleton.segments[1].parent, 0);
  EXPECT_TRUE(validate(*other.meshes[0], other.skeleton).ok());
  expect_same_places(clip, other, 1);
  const Clip walking = with_root_motion(other, RootMotion::kOnRoot);
  expect_same_places(clip, walking, 1);
  for (const double t : key_times(walking)) {
    const auto pose = pose_at(walking, t);
    EXPECT_EQ(pose[0].p_WL.z(), 0.0);
    EXPECT_LT((pose[0].p_WL - pose[1].p_WL).head<2>().norm(), 1e-12);
  }
}

TEST(Transforms, InPlaceKeepsHeightAndPose) {
  const Clip clip = clip_with_mesh();
  for (const bool under_root : {false, true}) {
    const Clip other = with_root_motion(under_root ? with_root_bone(clip, "root") : clip, RootMotion::kInPlace);
    const std::size_t hips = under_root ? 1 : 0;
    for (const double t : key_times(clip)) {
      const auto a = pose_at(clip, t);
      const auto b = pose_at(other, t);
      EXPECT_EQ(b[hips].p_WL.head<2>(), Vector3d(clip.root_position.values[0]).head<2>());
      EXPECT_EQ(b[hips].p_WL.z(), a[0].p_WL.z());
      EXPECT_LT(((a[5].p_WL - a[0].p_WL) - (b[hips + 5].p_WL - b[hips].p_WL)).norm(), 1e-9);
    }
  }
}

TEST(Transforms, TheRestFrameComesOneFrameBefore) {
  const Clip clip = clip_with_mesh();
  const Clip other = with_rest_frame(clip, Vector3d(0, 0, 1));
  expect_same_places(clip, other, 0, 1.0 / 60.0);
  EXPECT_NEAR(other.duration(), clip.duration() + 1.0 / 60.0, 1e-12);
  const auto rest = rest_poses(clip.skeleton);
  for (const double t : {0.0, 0.016}) {
    const auto first = pose_at(other, t);
    EXPECT_EQ(first[0].p_WL, Vector3d(0, 0, 1));
    for (std::size_t i = 0; i < rest.size(); ++i) {
      EXPECT_LT(geometry::geodesic_angle(first[i].R_WL, rest[i].R_WL), 1e-9);
    }
  }
}

TEST(Transforms, TheRestPoseIsPutOnTheFloor) {
  const Clip clip = clip_with_mesh();
  const Clip other = with_rest_height(clip, 0.0);
  EXPECT_NEAR(lowest_point_at_rest(other.skeleton), 0.0, 1e-12);
  expect_same_places(clip, other);
  Clip still = clip;
  still.root_position = {};
  expect_same_places(still, with_rest_height(still, 0.0));
}

}  // namespace
}  // namespace limbwave::motion
