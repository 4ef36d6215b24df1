#include "viewer/bone_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace limbwave::ui {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

body::Skeleton two_bones() {
  body::Skeleton skeleton;
  skeleton.name = "two";
  skeleton.segments.resize(2);
  skeleton.segments[0].name = "upper";
  skeleton.segments[0].length = 0.3;
  skeleton.segments[1].name = "lower";
  skeleton.segments[1].parent = 0;
  skeleton.segments[1].length = 0.2;
  skeleton.segments[1].p_PL = Vector3d(0.3, 0, 0);
  return skeleton;
}

// The first bone along x from the origin, the second upwards from its end.
std::vector<body::SegmentPose> bent() {
  const Eigen::Quaterniond up(Eigen::AngleAxisd(-M_PI / 2, Vector3d::UnitY()));
  return {{Eigen::Quaterniond::Identity(), Vector3d::Zero()}, {up, Vector3d(0.3, 0, 0)}};
}

ViewRay towards(const Vector3d& from, const Vector3d& to) {
  return {from, (to - from).normalized()};
}

TEST(BoneShapes, NormalsPointOutwards) {
  for (const TriangleMesh& mesh : {sphere_mesh(), box_mesh()}) {
    ASSERT_EQ(mesh.positions.size(), mesh.normals.size());
    ASSERT_EQ(mesh.positions.size() % 3, 0U);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      EXPECT_GT(mesh.positions[i].dot(mesh.normals[i]), 0.0F);
    }
  }
  const TriangleMesh bone = bone_mesh();
  for (std::size_t i = 0; i < bone.positions.size(); i += 3) {
    const Eigen::Vector3f middle = (bone.positions[i] + bone.positions[i + 1] + bone.positions[i + 2]) / 3;
    EXPECT_GT((middle - Eigen::Vector3f(0.4F, 0, 0)).dot(bone.normals[i]), 0.0F);
  }
}

TEST(BoneShapes, CornersTurnCounterClockwise) {
  for (const TriangleMesh& mesh : {bone_mesh(), sphere_mesh(), box_mesh(), rod_mesh(false)}) {
    for (std::size_t i = 0; i < mesh.positions.size(); i += 3) {
      const Eigen::Vector3f face =
          (mesh.positions[i + 1] - mesh.positions[i]).cross(mesh.positions[i + 2] - mesh.positions[i]);
      EXPECT_GE(face.dot(mesh.normals[i]), -1e-6F);  // At the poles of a sphere triangles have no area.
    }
  }
}

TEST(BoneShapes, BoundsHoldBothEndsOfEveryBone) {
  const Sphere sphere = bounds(two_bones(), bent());
  for (const Vector3d& p : {Vector3d(0, 0, 0), Vector3d(0.3, 0, 0), Vector3d(0.3, 0, 0.2)}) {
    EXPECT_LE((p - sphere.centre).norm(), sphere.radius + 1e-12);
  }
  EXPECT_LT(sphere.radius, 0.2);
  const Sphere second = segment_bounds(two_bones(), bent(), 1);
  EXPECT_LT((second.centre - Vector3d(0.3, 0, 0.1)).norm(), 1e-12);
}

TEST(BoneShapes, PickFindsTheBoneUnderTheRay) {
  const Vector3d eye(0.1, -2, 0.1);
  EXPECT_EQ(pick_segment(two_bones(), bent(), towards(eye, {0.15, 0, 0}), 0.0), 0);
  EXPECT_EQ(pick_segment(two_bones(), bent(), towards(eye, {0.3, 0, 0.15}), 0.0), 1);
  EXPECT_EQ(pick_segment(two_bones(), bent(), towards(eye, {0.1, 0, 0.2}), 0.0), -1);
}

TEST(BoneShapes, PickTakesTheNearerOfTwoBones) {
  auto poses = bent();
  poses[1] = {Eigen::Quaterniond::Identity(), Vector3d(0.0, -0.5, 0.0)};  // In front of the first one.
  EXPECT_EQ(pick_segment(two_bones(), poses, towards({0.1, -2, 0}, {0.1, 0, 0}), 0.0), 1);
  EXPECT_EQ(pick_segment(two_bones(), poses, towards({0.1, 2, 0}, {0.1, 0, 0}), 0.0), 0);
}

TEST(BoneShapes, SlackHelpsToHitThinBonesAndNothingBehindTheEyeIsHit) {
  const ViewRay beside = towards({0.15, -2, 0.05}, {0.15, 0, 0.05});
  EXPECT_EQ(pick_segment(two_bones(), bent(), beside, 0.0), -1);
  EXPECT_EQ(pick_segment(two_bones(), bent(), beside, 0.02), 0);
  EXPECT_EQ(pick_segment(two_bones(), bent(), {{0.15, -2, 0}, -Vector3d::UnitY()}, 0.0), -1);
}

TEST(BoneShapes, EmptySkeletonIsNowhere) {
  EXPECT_EQ(bounds({}, {}).radius, 0.0);
  EXPECT_EQ(pick_segment({}, {}, {}, 1.0), -1);
}

}  // namespace
}  // namespace limbwave::ui
