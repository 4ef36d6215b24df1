#include "simulate/sound_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace limbwave::simulate {
namespace {

constexpr double kWavelength = 0.0086;

TEST(SoundPath, PassageIsTheNearestApproach) {
  const WorldCapsule limb{{0.0, -0.2, 0.0}, {0.0, 0.2, 0.0}, 0.05};
  // Across the middle, 3 cm above the skin.
  const Passage over = passage({-0.4, 0.0, 0.08}, {0.4, 0.0, 0.08}, limb);
  EXPECT_NEAR(over.clearance, 0.03, 1e-12);
  EXPECT_NEAR(over.along, 0.5, 1e-12);
  EXPECT_NEAR(passage({-0.4, 0.0, 0.0}, {0.4, 0.0, 0.0}, limb).clearance, -0.05, 1e-12);
  // Against points along both lines, any way round.
  std::mt19937 random(5);
  std::uniform_real_distribution<double> at(-0.5, 0.5);
  for (int trial = 0; trial < 200; ++trial) {
    const auto point = [&] { return Vector3d(at(random), at(random), at(random)); };
    const WorldCapsule capsule{point(), point(), 0.04};
    const Vector3d p = point();
    const Vector3d q = point();
    double nearest = INFINITY;
    for (int i = 0; i <= 200; ++i) {
      for (int j = 0; j <= 200; ++j) {
        const Vector3d x = p + i / 200.0 * (q - p);
        const Vector3d y = capsule.a + j / 200.0 * (capsule.b - capsule.a);
        nearest = std::min(nearest, (x - y).norm());
      }
    }
    EXPECT_NEAR(passage(p, q, capsule).clearance, nearest - 0.04, 3e-3);
    EXPECT_LE(passage(p, q, capsule).clearance, nearest - 0.04 + 1e-12);
  }
}

// ITU-R P.526-15, figure of J(v): 6.0 dB where the line grazes the edge, 0 dB below v = -0.78.
TEST(SoundPath, KnifeEdgeIsAsPublished) {
  EXPECT_NEAR(knife_edge_loss_db(0.0, 0.3, 0.3, kWavelength), 6.0, 0.1);
  const double scale = std::sqrt(2.0 / kWavelength * (1.0 / 0.3 + 1.0 / 0.3));
  EXPECT_NEAR(knife_edge_loss_db(1.0 / scale, 0.3, 0.3, kWavelength), 13.9, 0.2);
  EXPECT_NEAR(knife_edge_loss_db(2.4 / scale, 0.3, 0.3, kWavelength), 20.5, 0.3);
  EXPECT_EQ(knife_edge_loss_db(-0.8 / scale, 0.3, 0.3, kWavelength), 0.0);
}

// The shadow of a limb that moves into the way begins before the line is cut, and grows without a jump.
TEST(SoundPath, ALimbShadesSmoothly) {
  double before = 0.0;
  for (int i = -100; i <= 45; ++i) {
    const double height = 0.05 + 1e-3 * i;  // of the limb's upper side over the line
    const WorldCapsule limb{{0.0, -0.3, height - 0.05}, {0.0, 0.3, height - 0.05}, 0.05};
    const Shade by = shade({-0.4, 0.0, 0.05}, {0.4, 0.0, 0.05}, {limb}, kWavelength);
    EXPECT_GE(by.loss_db, before - 1e-9) << i;
    EXPECT_LT(by.loss_db - before, 1.5) << i;
    EXPECT_EQ(by.detour > 0.0, i > 0) << i;
    if (i == 0) {
      EXPECT_NEAR(by.loss_db, 6.0, 0.1);
    }
    before = by.loss_db;
  }
  EXPECT_GT(before, 15.0);
}

TEST(SoundPath, LimbsFarFromTheWayDoNothing) {
  const WorldCapsule limb{{0.0, -0.3, 0.3}, {0.0, 0.3, 0.3}, 0.05};
  const Shade by = shade({-0.4, 0.0, 0.0}, {0.4, 0.0, 0.0}, {limb}, kWavelength);
  EXPECT_EQ(by.loss_db, 0.0);
  EXPECT_EQ(by.detour, 0.0);
}

TEST(SoundPath, AMirrorsImageIsAsFarBehindIt) {
  const Mirror wall{-Vector3d::UnitX(), -2.0, 0.6};  // sound is where x < 2
  EXPECT_NEAR((wall.image({0.5, 1.0, 1.0}) - Vector3d(3.5, 1.0, 1.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(wall.height({0.5, 1.0, 1.0}), 1.5, 1e-12);
}

}  // namespace
}  // namespace limbwave::simulate
