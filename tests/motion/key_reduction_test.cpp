#include "motion/key_reduction.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/units.h"
#include "geometry/so3.h"
#include "interchange/random_clip.h"

namespace limbwave::motion {
namespace {

// A joint that swings at 1 Hz through 30 degrees while the root walks a circle, at 120 Hz.
Clip swing(double seconds) {
  Clip clip;
  clip.frame_rate_hz = 120.0;
  body::Segment segment;
  segment.name = "arm";
  clip.skeleton.segments = {segment};
  clip.joints.resize(1);
  for (int f = 0; f <= static_cast<int>(seconds * 120.0); ++f) {
    const double t = f / 120.0;
    clip.joints[0].rotation.times.push_back(t);
    clip.joints[0].rotation.values.push_back(
        geometry::exp_so3(Vector3d(0, radians(30.0) * std::sin(2.0 * kPi * t), 0)));
    clip.root_position.times.push_back(t);
    clip.root_position.values.push_back({std::cos(t), std::sin(t), 1.0});
  }
  return clip;
}

double worst_difference(const Clip& a, const Clip& b) {
  double worst = 0.0;
  for (const double t : key_times(a)) {
    for (std::size_t i = 0; i < a.joints.size(); ++i) {
      if (!a.joints[i].rotation.empty()) {
        worst =
            std::max(worst, geometry::geodesic_angle(sample(a.joints[i].rotation, t), sample(b.joints[i].rotation, t)));
      }
    }
  }
  return worst;
}

TEST(KeyReduction, StaysWithinWhatItPromisesAndSaysHowFar) {
  for (const double tolerance_deg : {0.01, 0.1, 1.0}) {
    const Clip clip = test::random_clip(15, 400, 60.0, 11);
    KeyReduction limits;
    limits.rotation_rad = radians(tolerance_deg);
    const Result<ReducedClip> fewer = reduced(clip, limits);
    ASSERT_TRUE(fewer.ok());
    const double worst = worst_difference(clip, fewer->clip);
    EXPECT_LE(worst, limits.rotation_rad * (1.0 + 1e-9));
    EXPECT_NEAR(worst, fewer->worst_rotation_rad, 1e-9);
    for (const double t : key_times(clip)) {
      EXPECT_LE((sample(clip.root_position, t) - sample(fewer->clip.root_position, t)).norm(), limits.position_m);
    }
  }
}

TEST(KeyReduction, LeavesFewKeysOfASmoothMovement) {
  const Clip clip = swing(10.0);
  KeyReduction limits;
  limits.rotation_rad = radians(0.5);
  const Result<ReducedClip> fewer = reduced(clip, limits);
  ASSERT_TRUE(fewer.ok());
  // A chord of a sine of 30 degrees at 1 Hz may be about 0.09 s long: some 110 of 1201 keys.
  EXPECT_LT(fewer->clip.joints[0].rotation.times.size(), 200U);
  EXPECT_EQ(fewer->keys_before, 2U * 1201U);
  EXPECT_EQ(fewer->clip.duration(), clip.duration());
}

TEST(KeyReduction, LongClipsInPiecesKeepTheBound) {
  const Clip clip = swing(20.0);
  KeyReduction limits;
  limits.rotation_rad = radians(0.2);
  limits.longest = 100;
  const Result<ReducedClip> fewer = reduced(clip, limits);
  ASSERT_TRUE(fewer.ok());
  EXPECT_LE(worst_difference(clip, fewer->clip), limits.rotation_rad * (1.0 + 1e-9));
}

TEST(KeyReduction, OneKeyAndHeldTracksStay) {
  Clip clip = swing(1.0);
  clip.joints[0].rotation = {{0.25}, {Quaterniond::Identity()}};
  clip.root_position.interpolation = Interpolation::kStep;
  const Result<ReducedClip> fewer = reduced(clip, KeyReduction{});
  ASSERT_TRUE(fewer.ok());
  EXPECT_EQ(fewer->clip.joints[0].rotation.times, clip.joints[0].rotation.times);
  EXPECT_EQ(fewer->clip.root_position.times, clip.root_position.times);
}

TEST(KeyReduction, CanBeCancelled) {
  const Result<ReducedClip> fewer =
      reduced(swing(1.0), KeyReduction{}, Progress([](double, std::string_view) { return false; }));
  ASSERT_FALSE(fewer.ok());
  EXPECT_TRUE(is_cancelled(fewer.error()));
}

}  // namespace
}  // namespace limbwave::motion
