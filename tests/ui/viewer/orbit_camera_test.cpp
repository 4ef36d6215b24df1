#include "viewer/orbit_camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace limbwave::ui {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

const Vector2d kSize(800, 600);

TEST(OrbitCamera, TargetIsInTheMiddleFromEverySide) {
  OrbitCamera camera;
  for (const double yaw : {0.0, 1.0, 2.5, -3.0}) {
    for (const double pitch : {-1.2, 0.0, 0.7}) {
      OrbitCamera turned = camera;
      turned.orbit(yaw, pitch);
      const auto pixel = turned.project(turned.target(), kSize);
      ASSERT_TRUE(pixel.has_value());
      EXPECT_LT((*pixel - kSize / 2).norm(), 1e-9);
      EXPECT_NEAR((turned.position() - turned.target()).norm(), turned.distance(), 1e-12);
      EXPECT_NEAR(turned.right().dot(turned.up()), 0.0, 1e-12);
      EXPECT_NEAR(turned.up().norm(), 1.0, 1e-12);
      EXPECT_GT(turned.up().z(), 0.0);
    }
  }
}

TEST(OrbitCamera, RayThroughAProjectedPointMeetsThePoint) {
  OrbitCamera camera;
  camera.orbit(0.4, -0.2);
  const Vector3d point(0.3, -0.4, 1.3);
  const auto pixel = camera.project(point, kSize);
  ASSERT_TRUE(pixel.has_value());
  const ViewRay ray = camera.ray(*pixel, kSize);
  const Vector3d offset = point - ray.origin;
  EXPECT_LT((offset - offset.dot(ray.direction) * ray.direction).norm(), 1e-9);
}

TEST(OrbitCamera, PointsBehindTheCameraHaveNoPixel) {
  const OrbitCamera camera;
  EXPECT_FALSE(camera.project(camera.position() - camera.forward(), kSize).has_value());
}

TEST(OrbitCamera, PanMovesAPointAtTheTargetsDepthWithThePointer) {
  OrbitCamera camera;
  const Vector3d point = camera.target();
  camera.pan(40, -25, kSize.y());
  const auto pixel = camera.project(point, kSize);
  ASSERT_TRUE(pixel.has_value());
  EXPECT_LT((*pixel - (kSize / 2 + Vector2d(40, -25))).norm(), 1e-9);
}

TEST(OrbitCamera, FramedSphereFitsInTallAndWidePictures) {
  const Vector3d centre(0.2, 0.1, 1.1);
  const double radius = 0.6;
  for (const Vector2d& size : {Vector2d(800, 600), Vector2d(300, 900), Vector2d(1600, 300)}) {
    OrbitCamera camera;
    camera.frame(centre, radius, size.x() / size.y());
    double farthest = 0;
    for (const Vector3d& side : {camera.right(), camera.up(), Vector3d(-camera.right()), Vector3d(-camera.up())}) {
      const auto pixel = camera.project(centre + radius * side, size);
      ASSERT_TRUE(pixel.has_value());
      EXPECT_GE(pixel->x(), 0);
      EXPECT_LE(pixel->x(), size.x());
      EXPECT_GE(pixel->y(), 0);
      EXPECT_LE(pixel->y(), size.y());
      farthest = std::max(farthest, (*pixel - size / 2).cwiseQuotient(size / 2).cwiseAbs().maxCoeff());
    }
    EXPECT_GT(farthest, 0.8) << "the sphere should fill the picture";
  }
}

TEST(OrbitCamera, FramedPointsFillThePictureAndStayInside) {
  const std::vector<Vector3d> points{{0, 0, 1.0}, {0.3, 0.1, 1.4}, {-0.2, 0.5, 0.9}, {0.1, -0.7, 1.1}};
  for (const Vector2d& size : {Vector2d(800, 600), Vector2d(300, 900), Vector2d(1600, 300)}) {
    for (const double yaw : {0.0, 1.1, 2.9}) {
      OrbitCamera camera;
      camera.orbit(yaw, 0.4);
      const Vector3d forward = camera.forward();
      camera.frame(points, size.x() / size.y());
      EXPECT_LT((camera.forward() - forward).norm(), 1e-12);
      double farthest = 0;
      for (const Vector3d& point : points) {
        const auto pixel = camera.project(point, size);
        ASSERT_TRUE(pixel.has_value());
        farthest = std::max(farthest, (*pixel - size / 2).cwiseQuotient(size / 2).cwiseAbs().maxCoeff());
      }
      EXPECT_LT(farthest, 1.0);
      EXPECT_NEAR(farthest, 1 / 1.15, 1e-6);
    }
  }
  OrbitCamera camera;
  camera.frame(std::vector<Vector3d>{}, 1.0);
  EXPECT_DOUBLE_EQ(camera.distance(), OrbitCamera().distance());
}

TEST(OrbitCamera, ViewsLookAlongTheAxes) {
  OrbitCamera camera;
  camera.look(ViewDirection::kFront);  // The subject faces +x: the camera stands there and looks back.
  EXPECT_LT((camera.forward() + Vector3d::UnitX()).norm(), 1e-9);
  EXPECT_LT((camera.right() - Vector3d::UnitY()).norm(), 1e-9);  // The subject's left is on the right.
  camera.look(ViewDirection::kSide);
  EXPECT_LT((camera.forward() - Vector3d::UnitY()).norm(), 1e-9);
  camera.look(ViewDirection::kTop);
  EXPECT_LT((camera.forward() + Vector3d::UnitZ()).norm(), 2e-3);
  EXPECT_LT((camera.up() - Vector3d::UnitX()).norm(), 2e-3);  // Forwards is up in the picture.
}

TEST(OrbitCamera, ZoomAndPitchStayWithinLimits) {
  OrbitCamera camera;
  for (int i = 0; i < 1000; ++i) {
    camera.zoom(1.5);
    camera.orbit(0.0, 0.1);
  }
  EXPECT_GT(camera.distance(), 0.0);
  EXPECT_LT(camera.pitch(), std::numbers::pi / 2);
  EXPECT_GT(camera.near_plane(), 0.0);
  EXPECT_LT(camera.near_plane(), camera.distance());
  for (int i = 0; i < 1000; ++i) {
    camera.zoom(0.5);
  }
  EXPECT_TRUE(std::isfinite(camera.distance()));
  EXPECT_GT(camera.far_plane(), camera.distance());
}

}  // namespace
}  // namespace limbwave::ui
