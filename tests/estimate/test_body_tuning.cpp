#include <gtest/gtest.h>

#include "estimate/body_tuning.h"
#include "support/drawn_wearer.h"

namespace limbwave::estimate {
namespace {

// Readings of a wearer who is drawn with these parameters.
struct Recording {
  BodyModel model;
  BodyReadings readings;
};
Recording record(const BodyFilterParameters& p, unsigned seed) {
  Drawn drawn(seed, p);
  BodyFilter filter(drawn.model, p);
  drawn.start(filter);
  Recording recording{drawn.model, {}};
  for (int k = 1; k <= 300; ++k) {
    drawn.move(filter, 0.01);
    drawn.measure(filter, k % 5 == 0, recording.readings);
  }
  return recording;
}

double factor(const BodyTuning& tuning, const std::string& what) {
  for (const TunedNoise& noise : tuning.noises) {
    if (noise.what == what) {
      return noise.factor;
    }
  }
  return 0.0;
}

TEST(BodyTuning, FindsAWrongNoiseAgain) {
  const BodyFilterParameters right = modelled_errors_only();
  const Recording recording = record(right, 7);
  BodyFilterParameters wrong = right;
  wrong.range_noise *= 4.0;
  wrong.acceleration_walk /= 3.0;
  const auto tuning = tune_body(recording.model, wrong, recording.readings, {}, {});
  ASSERT_TRUE(tuning.ok());
  EXPECT_GT(tuning->after, tuning->before + 100.0);
  EXPECT_NEAR(std::log2(factor(*tuning, "ranges")), -2.0, 0.35);
  EXPECT_NEAR(std::log2(factor(*tuning, "movement")), std::log2(3.0), 0.35);
  EXPECT_NEAR(std::log2(factor(*tuning, "inertial")), 0.0, 0.35);
  EXPECT_DOUBLE_EQ(tuning->parameters.range_noise, wrong.range_noise * factor(*tuning, "ranges"));
  EXPECT_DOUBLE_EQ(tuning->parameters.bone_scale, wrong.bone_scale);
}

TEST(BodyTuning, LeavesAloneWhatIsNotUsed) {
  BodyFilterParameters p = modelled_errors_only();
  const Recording recording = record(p, 8);
  p.use_ranges = false;
  BodyTuningSettings quick;
  quick.seconds = 0.5;
  quick.accuracy = 1.0;
  const auto tuning = tune_body(recording.model, p, recording.readings, quick, {});
  ASSERT_TRUE(tuning.ok());
  EXPECT_EQ(factor(*tuning, "ranges"), 0.0);
  EXPECT_EQ(tuning->parameters.range_noise, p.range_noise);
  EXPECT_NEAR(tuning->seconds, 0.5, 0.011);
}

TEST(BodyTuning, StopsWhenAskedTo) {
  const BodyFilterParameters p = modelled_errors_only();
  const Recording recording = record(p, 9);
  double furthest = 0.0;
  const Progress progress([&](double fraction, std::string_view) {
    EXPECT_GE(fraction, furthest);
    furthest = fraction;
    return fraction < 0.3;
  });
  const auto tuning = tune_body(recording.model, p, recording.readings, {}, progress);
  ASSERT_FALSE(tuning.ok());
  EXPECT_TRUE(is_cancelled(tuning.error()));
}

}  // namespace
}  // namespace limbwave::estimate
