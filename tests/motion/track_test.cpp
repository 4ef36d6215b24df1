#include "motion/track.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/so3.h"

namespace limbwave::motion {
namespace {

TEST(Track, EveryKeyGoesOnInItsOwnWay) {
  PositionTrack track{{0.0, 1.0, 2.0, 3.0},
                      {Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(2, 0, 0), Vector3d(4, 0, 0)}};
  track.key_interpolation = {Interpolation::kStep, Interpolation::kLinear, Interpolation::kCubic,
                             Interpolation::kLinear};
  EXPECT_EQ(sample(track, 0.9).x(), 0.0);
  EXPECT_DOUBLE_EQ(sample(track, 1.25).x(), 1.25);
  // Catmull-Rom from slope 1.5 to slope 2: x(1/2) = 3 + (1.5 - 2) / 8.
  EXPECT_DOUBLE_EQ(sample(track, 2.5).x(), 3.0 - 0.0625);
}

TEST(Track, CubicPiecesKeepTheVelocitiesTheyWereGiven) {
  PositionTrack line{{0.0, 2.0}, {Vector3d(0, 0, 0), Vector3d(1, 0, 0)}, Interpolation::kCubic};
  line.arriving = {Vector3d(9, 9, 9), Vector3d(-1, 0, 0)};
  line.leaving = {Vector3d(3, 0, 0), Vector3d(9, 9, 9)};
  const double h = 1e-5;
  EXPECT_NEAR(sample(line, h).x() / h, 3.0, 1e-3);
  EXPECT_NEAR((1.0 - sample(line, 2.0 - h).x()) / h, -1.0, 1e-3);

  RotationTrack turn{
      {0.0, 0.5}, {Quaterniond::Identity(), geometry::exp_so3(Vector3d(0, 0.3, 1.0))}, Interpolation::kCubic};
  turn.arriving = {Vector3d::Zero(), Vector3d(0.5, 0, 0)};
  turn.leaving = {Vector3d(0, 2, 0), Vector3d::Zero()};
  EXPECT_LT((geometry::log_so3(sample(turn, h)) / h - Vector3d(0, 2, 0)).norm(), 1e-3);
  const Quaterniond last = turn.values[1];
  EXPECT_LT((geometry::log_so3(sample(turn, 0.5 - h).conjugate() * last) / h - Vector3d(0.5, 0, 0)).norm(), 1e-3);
}

TEST(Track, ATrimmedCurveKeepsItsShape) {
  const PositionTrack whole{{0.0, 1.0, 1.5, 4.0},
                            {Vector3d(0, 1, 0), Vector3d(1, 0, 2), Vector3d(2, 5, 0), Vector3d(4, 0, 1)},
                            Interpolation::kCubic};
  const PositionTrack part = trimmed(whole, 0.4, 2.7);
  for (double t = 0.4; t < 2.7; t += 0.05) {
    EXPECT_LT((sample(part, t - 0.4) - sample(whole, t)).norm(), 1e-5) << t;
  }
}

TEST(Track, JoinedCurvesKeepTheirShape) {
  const PositionTrack first{
      {0.0, 1.0, 1.5}, {Vector3d(0, 1, 0), Vector3d(1, 0, 2), Vector3d(2, 5, 0)}, Interpolation::kCubic};
  const PositionTrack second{{0.0, 2.0}, {Vector3d(7, 1, 0), Vector3d(1, 0, 2)}, Interpolation::kStep};
  PositionTrack both = first;
  append(both, second, 1.5, 1.6, Vector3d::Zero());
  for (double t = 0.0; t < 1.5; t += 0.05) {
    EXPECT_LT((sample(both, t) - sample(first, t)).norm(), 1e-12) << t;
  }
  EXPECT_EQ(sample(both, 3.0), Vector3d(7, 1, 0));
  EXPECT_EQ(sample(both, 3.6), Vector3d(1, 0, 2));
  EXPECT_LT((sample(both, 1.55) - Vector3d(4.5, 3, 0)).norm(), 1e-9);
}

}  // namespace
}  // namespace limbwave::motion
