#include "motion/clip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/units.h"
#include "geometry/so3.h"

namespace limbwave::motion {
namespace {

Quaterniond about(const Vector3d& axis, double angle) {
  return Quaterniond(Eigen::AngleAxisd(angle, axis.normalized()));
}

// Two bones: an upper arm at (0, 0, 1) and a forearm at its end, 0.3 m along x.
Clip arm() {
  Clip clip;
  clip.name = "arm";
  body::Segment upper;
  upper.name = "upper";
  upper.p_PL = {0, 0, 1};
  upper.length = 0.3;
  body::Segment fore;
  fore.name = "fore";
  fore.parent = 0;
  fore.p_PL = {0.3, 0, 0};
  fore.R_PL_rest = about(Vector3d::UnitZ(), 0.5);
  fore.length = 0.25;
  clip.skeleton.segments = {upper, fore};
  clip.joints.resize(2);
  return clip;
}

TEST(Track, HoldsOutsideAndIsExactOnKeys) {
  const RotationTrack track{{1.0, 2.0}, {about(Vector3d::UnitX(), 0.1), about(Vector3d::UnitX(), 0.3)}};
  EXPECT_EQ(sample(track, -5.0).coeffs(), track.values[0].coeffs());
  EXPECT_EQ(sample(track, 1.0).coeffs(), track.values[0].coeffs());
  EXPECT_EQ(sample(track, 2.0).coeffs(), track.values[1].coeffs());
  EXPECT_EQ(sample(track, 9.0).coeffs(), track.values[1].coeffs());
  EXPECT_NEAR(geometry::geodesic_angle(sample(track, 1.25), about(Vector3d::UnitX(), 0.15)), 0.0, 1e-12);
}

TEST(Track, GoesTheShorterWayWhateverTheSign) {
  const Quaterniond a = about(Vector3d::UnitZ(), radians(10.0));
  Quaterniond b = about(Vector3d::UnitZ(), radians(50.0));
  b.coeffs() *= -1.0;
  const RotationTrack track{{0.0, 1.0}, {a, b}};
  EXPECT_NEAR(geometry::geodesic_angle(sample(track, 0.5), about(Vector3d::UnitZ(), radians(30.0))), 0.0, 1e-12);
}

TEST(Track, OneKeyServesEveryTime) {
  const PositionTrack track{{0.5}, {Vector3d(1, 2, 3)}};
  for (const double t : {-1.0, 0.5, 3.0}) {
    EXPECT_EQ(sample(track, t), Vector3d(1, 2, 3));
  }
}

TEST(Track, StepHolds) {
  PositionTrack track{{0.0, 1.0}, {Vector3d::Zero(), Vector3d::Ones()}};
  track.interpolation = Interpolation::kStep;
  EXPECT_EQ(sample(track, 0.999), Vector3d::Zero());
  EXPECT_EQ(sample(track, 1.0), Vector3d::Ones());
}

TEST(Track, CubicReproducesParabolaBetweenUnevenKeysAndConstantRotationRate) {
  // Away from the ends the velocities are those of the parabola through three neighbours, so a parabola is exact.
  PositionTrack track;
  track.interpolation = Interpolation::kCubic;
  RotationTrack turning;
  turning.interpolation = Interpolation::kCubic;
  const Vector3d axis = Vector3d(1, -2, 0.5).normalized();
  for (const double t : {0.0, 0.1, 0.35, 0.5, 0.9, 1.0}) {
    track.times.push_back(t);
    track.values.emplace_back(t * t, 1.0 - 3.0 * t, -2.0 * t * t);
    turning.times.push_back(t);
    turning.values.push_back(about(axis, 2.0 * t));
  }
  for (double t = 0.1; t < 0.9; t += 0.013) {
    EXPECT_LT((sample(track, t) - Vector3d(t * t, 1.0 - 3.0 * t, -2.0 * t * t)).norm(), 1e-12);
    EXPECT_LT(geometry::geodesic_angle(sample(turning, t), about(axis, 2.0 * t)), 1e-9);
  }
}

TEST(Pose, ComposesAlongTheChain) {
  Clip clip = arm();
  clip.joints[0].rotation = {{0.0, 1.0}, {Quaterniond::Identity(), about(Vector3d::UnitY(), -kPi / 2)}};
  const auto poses = pose_at(clip, 1.0);  // The upper arm points up.
  ASSERT_EQ(poses.size(), 2U);
  EXPECT_LT((poses[0].p_WL - Vector3d(0, 0, 1)).norm(), 1e-12);
  EXPECT_LT((poses[1].p_WL - Vector3d(0, 0, 1.3)).norm(), 1e-12);
  const Quaterniond expected = about(Vector3d::UnitY(), -kPi / 2) * about(Vector3d::UnitZ(), 0.5);
  EXPECT_LT(geometry::geodesic_angle(poses[1].R_WL, expected), 1e-12);
}

TEST(Pose, RestIsWhatAClipWithoutKeysShows) {
  const Clip clip = arm();
  EXPECT_EQ(clip.duration(), 0.0);
  const auto posed = pose_at(clip, 0.3);
  const auto rest = rest_poses(clip.skeleton);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT((posed[i].p_WL - rest[i].p_WL).norm(), 1e-15);
    EXPECT_LT(geometry::geodesic_angle(posed[i].R_WL, rest[i].R_WL), 1e-12);
  }
}

TEST(Clip, ResamplingKeepsMultiplesOfTheFrame) {
  Clip clip = arm();
  clip.joints[1].rotation = {{0.0, 0.4, 1.0}, {Quaterniond::Identity(), about({1, 1, 0}, 1.0), about({0, 1, 2}, 2.0)}};
  clip.root_position = {{0.0, 1.0}, {Vector3d::Zero(), Vector3d(2, 0, 0)}};
  const Clip at10 = resampled(clip, 10.0);
  ASSERT_EQ(at10.joints[1].rotation.times.size(), 11U);
  EXPECT_TRUE(at10.joints[0].rotation.empty());
  EXPECT_EQ(at10.frame_rate_hz, 10.0);
  for (std::size_t i = 0; i < 11; ++i) {
    const double t = static_cast<double>(i) / 10.0;
    EXPECT_DOUBLE_EQ(at10.joints[1].rotation.times[i], t);
    EXPECT_LT(geometry::geodesic_angle(at10.joints[1].rotation.values[i], sample(clip.joints[1].rotation, t)), 1e-12);
    EXPECT_NEAR(at10.root_position.values[i].x(), 2.0 * t, 1e-12);
  }
  // The clip ends between two frames: the last whole one counts.
  EXPECT_EQ(frame_count(1.0, 3.5), 4U);
  // Times of a file at 120 Hz, rounded to a microsecond, lose no frame.
  EXPECT_EQ(frame_count(2.291666, 120.0), 275U + 1U);
}

TEST(Clip, TrimmingKeepsTheMotion) {
  Clip clip = arm();
  clip.joints[0].rotation = {{0.0, 1.0, 2.0}, {about({0, 0, 1}, 0), about({0, 0, 1}, 1), about({0, 0, 1}, 0)}};
  clip.root_position = {{0.0, 2.0}, {Vector3d::Zero(), Vector3d(2, 0, 0)}};
  const Clip part = trimmed(clip, 0.5, 1.75);
  EXPECT_DOUBLE_EQ(part.duration(), 1.25);
  for (double t = 0.0; t <= 1.25; t += 0.05) {
    const auto whole = pose_at(clip, 0.5 + t);
    const auto cut = pose_at(part, t);
    EXPECT_LT((whole[1].p_WL - cut[1].p_WL).norm(), 1e-12);
  }
}

TEST(Clip, ConcatenationPlaysOneAfterTheOther) {
  Clip first = arm();
  first.frame_rate_hz = 10.0;
  first.joints[0].rotation = {{0.0, 0.5}, {about({0, 0, 1}, 0), about({0, 0, 1}, 1)}};  // Ends before the root does.
  first.root_position = {{0.0, 1.0}, {Vector3d::Zero(), Vector3d(1, 0, 0)}};
  Clip second = arm();
  second.joints[0].rotation = {{0.2, 0.4}, {about({0, 0, 1}, 2), about({0, 0, 1}, 0.3)}};
  second.joints[1].rotation = {{0.0, 0.3}, {about({0, 1, 0}, 2), about({0, 0, 1}, 0.3)}};
  const Result<Clip> both = concatenated(first, second);
  ASSERT_TRUE(both.ok()) << both.error().text();
  EXPECT_NEAR(both->duration(), 1.5, 1e-12);
  for (double t = 0.0; t <= 1.0; t += 0.05) {
    EXPECT_LT((pose_at(*both, t)[1].p_WL - pose_at(first, t)[1].p_WL).norm(), 1e-12) << t;
    EXPECT_LT(geometry::geodesic_angle(pose_at(*both, t)[1].R_WL, pose_at(first, t)[1].R_WL), 1e-9) << t;
  }
  for (double t = 0.0; t <= 0.4; t += 0.05) {
    EXPECT_LT((pose_at(*both, 1.1 + t)[1].p_WL - pose_at(second, t)[1].p_WL).norm(), 1e-12) << t;
    EXPECT_LT(geometry::geodesic_angle(pose_at(*both, 1.1 + t)[1].R_WL, pose_at(second, t)[1].R_WL), 1e-9) << t;
  }
  for (const JointTracks& joint : both->joints) {
    for (std::size_t i = 1; i < joint.rotation.times.size(); ++i) {
      EXPECT_GT(joint.rotation.times[i], joint.rotation.times[i - 1]);
    }
  }
  second.skeleton.segments[1].name = "other";
  EXPECT_FALSE(concatenated(first, second).ok());
}

TEST(Clip, KeyTimesAreTheUnion) {
  Clip clip = arm();
  clip.joints[0].rotation = {{0.0, 0.5}, {Quaterniond::Identity(), Quaterniond::Identity()}};
  clip.joints[1].rotation = {{0.25, 0.5000001}, {Quaterniond::Identity(), Quaterniond::Identity()}};
  EXPECT_EQ(key_times(clip), (std::vector<double>{0.0, 0.25, 0.5}));
}

}  // namespace
}  // namespace limbwave::motion
