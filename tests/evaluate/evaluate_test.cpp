#include "evaluate/evaluate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/units.h"
#include "geometry/so3.h"
#include "interchange/csv_poses.h"
#include "interchange/random_clip.h"

namespace limbwave::evaluate {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

Quaterniond about(const Vector3d& axis, double angle_deg) {
  return Quaterniond(Eigen::AngleAxisd(radians(angle_deg), axis.normalized()));
}

// The clip's own poses as truth, `start` seconds into the take.
Truth truth_of(const motion::Clip& clip, double start) {
  Truth truth;
  for (const body::Segment& segment : clip.skeleton.segments) {
    truth.segments.emplace_back().name = segment.name;
  }
  for (const double time : motion::key_times(clip)) {
    const auto poses = motion::pose_at(clip, time);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      truth.segments[i].times.push_back(start + time);
      truth.segments[i].R_WL.push_back(poses[i].R_WL);
      truth.segments[i].p_WL.push_back(poses[i].p_WL);
    }
  }
  return truth;
}

Evaluation must(const Result<Evaluation>& evaluation) {
  EXPECT_TRUE(evaluation.ok()) << evaluation.error().text();
  return evaluation.ok() ? *evaluation : Evaluation();
}

TEST(Evaluate, ItselfHasNoError) {
  const motion::Clip clip = test::random_clip(8, 50, 60.0, 31);
  const Evaluation evaluation = must(evaluate(clip, 12.5, truth_of(clip, 12.5)));
  EXPECT_EQ(evaluation.segments.size(), 8U);
  EXPECT_EQ(evaluation.joints.size(), 7U);
  EXPECT_LT(evaluation.all.mean_deg, 1e-9);
  EXPECT_LT(evaluation.all.inclination_max_deg, 1e-9);
  EXPECT_LT(evaluation.all.position_mean_mm, 1e-9);
}

TEST(Evaluate, ErrorsWhileSomebodyHoldsStillAreToldApart) {
  // A second of standing, one of turning by 90°, one of standing; the estimate is off by 5° while it turns and for 0.2
  // s after, by 1° otherwise.
  motion::Clip clip = test::random_clip(1, 301, 100.0, 33);
  clip.root_position = {};
  motion::RotationTrack& track = clip.joints[0].rotation;
  track.times.clear();
  track.values.clear();
  Truth truth;
  truth.segments.emplace_back().name = clip.skeleton.segments[0].name;
  for (int k = 0; k <= 300; ++k) {
    const double time = 0.01 * k;
    const Quaterniond turned = about(Vector3d::UnitX(), 90.0 * std::clamp(time - 1.0, 0.0, 1.0));
    track.times.push_back(time);
    track.values.push_back(turned * about(Vector3d::UnitX(), time > 1.0 && time < 2.2 ? 5.0 : 1.0));
    truth.segments[0].times.push_back(time);
    truth.segments[0].R_WL.push_back(turned);
    truth.segments[0].p_WL.push_back(Vector3d::Zero());
  }
  const Evaluation evaluation = must(evaluate(clip, 0.0, truth));
  EXPECT_NEAR(evaluation.all.max_deg, 5.0, 1e-6);
  EXPECT_NEAR(evaluation.still.max_deg, 1.0, 1e-6);
  EXPECT_NEAR(evaluation.still.inclination_mean_deg, 1.0, 1e-6);
  // A quarter of a second at both ends of both is not known to be still.
  EXPECT_NEAR(evaluation.still_fraction, (0.5 + 0.5) / 3.0, 0.02);
  EXPECT_NEAR(evaluation_to_json(evaluation)["still"]["fraction"].get<double>(), evaluation.still_fraction, 1e-12);

  for (std::size_t k = 0; k <= 300; ++k) {
    truth.segments[0].R_WL[k] = about(Vector3d::UnitX(), 0.3 * static_cast<double>(k));
  }
  const Evaluation moving = must(evaluate(clip, 0.0, truth));
  EXPECT_EQ(moving.still_fraction, 0.0);
  EXPECT_TRUE(std::isnan(moving.still.mean_deg));
  EXPECT_FALSE(evaluation_to_json(moving).contains("still"));
}

TEST(Evaluate, KnownErrorsAreFoundExactly) {
  // The child is off by 4° about the world's vertical (heading) in odd frames, by 2° in even ones, on top of 3° of
  // inclination of everything through the root.
  const motion::Clip clip = test::random_clip(2, 40, 60.0, 32);
  Truth truth = truth_of(clip, 0.0);
  for (std::size_t k = 0; k < 40; ++k) {
    const Quaterniond tilt = about(Vector3d::UnitX(), 3.0);
    const double heading = k % 2 == 1 ? 4.0 : 2.0;
    truth.segments[0].R_WL[k] = tilt * truth.segments[0].R_WL[k];
    truth.segments[1].R_WL[k] = tilt * about(Vector3d::UnitZ(), heading) * truth.segments[1].R_WL[k];
    truth.segments[1].p_WL[k] += Vector3d(0.0, 0.003, 0.004);
  }
  const Evaluation evaluation = must(evaluate(clip, 0.0, truth));
  const ErrorStatistics& root = evaluation.segments.at("joint0");
  EXPECT_NEAR(root.mean_deg, 3.0, 1e-9);
  EXPECT_NEAR(root.sd_deg, 0.0, 1e-6);
  EXPECT_NEAR(root.inclination_mean_deg, 3.0, 1e-9);
  EXPECT_NEAR(root.inclination_max_deg, 3.0, 1e-9);
  EXPECT_NEAR(root.position_mean_mm, 0.0, 1e-9);
  const ErrorStatistics& child = evaluation.segments.at("joint1");
  EXPECT_NEAR(child.inclination_rms_deg, 3.0, 1e-9);
  EXPECT_NEAR(child.position_mean_mm, 5.0, 1e-9);
  // Relative to the parent only the heading is left.
  ASSERT_EQ(evaluation.joints.count("joint0"), 0U);
  const ErrorStatistics& joint = evaluation.joints.at("joint1");
  EXPECT_NEAR(joint.mean_deg, 3.0, 1e-9);
  EXPECT_NEAR(joint.sd_deg, 1.0, 1e-9);
  EXPECT_NEAR(joint.rms_deg, std::sqrt(10.0), 1e-9);
  EXPECT_NEAR(joint.p95_deg, 4.0, 1e-9);
  EXPECT_NEAR(joint.max_deg, 4.0, 1e-9);
  EXPECT_TRUE(std::isnan(joint.inclination_mean_deg));
}

TEST(Evaluate, PercentileInterpolates) {
  // Errors of 0, 1, ..., 10 degrees: the 95th percentile lies half-way from 9 to 10.
  const motion::Clip clip = test::random_clip(1, 11, 60.0, 33);
  Truth truth = truth_of(clip, 0.0);
  for (std::size_t k = 0; k < 11; ++k) {
    truth.segments[0].R_WL[k] = truth.segments[0].R_WL[k] * about({1, 2, 3}, static_cast<double>(10 - k));
  }
  const Evaluation evaluation = must(evaluate(clip, 0.0, truth));
  EXPECT_NEAR(evaluation.all.p95_deg, 9.5, 1e-9);
  EXPECT_NEAR(evaluation.all.mean_deg, 5.0, 1e-9);
  EXPECT_NEAR(evaluation.all.sd_deg, std::sqrt(10.0), 1e-9);
}

TEST(Evaluate, HeadingAloneIsNoInclinationError) {
  const motion::Clip clip = test::random_clip(3, 30, 60.0, 34);
  Truth truth = truth_of(clip, 0.0);
  for (Truth::SegmentTruth& segment : truth.segments) {
    for (Quaterniond& R : segment.R_WL) {
      R = about(Vector3d::UnitZ(), 137.0) * R;
    }
  }
  const Evaluation evaluation = must(evaluate(clip, 0.0, truth));
  EXPECT_NEAR(evaluation.all.mean_deg, 137.0, 1e-6);
  EXPECT_LT(evaluation.all.inclination_max_deg, 1e-6);
  EXPECT_LT(evaluation.joints.at("joint1").max_deg, 1e-6);
}

TEST(Evaluate, AClipWithoutRootMotionIsMovedToTheTruthsRoot) {
  motion::Clip clip = test::random_clip(3, 30, 60.0, 35);
  const Truth truth = truth_of(clip, 0.0);
  clip.root_position = {};
  EXPECT_LT(must(evaluate(clip, 0.0, truth)).all.position_mean_mm, 1e-9);
  // Where the root is unknown there is nothing to move to.
  Truth rootless = truth;
  for (Vector3d& p : rootless.segments[0].p_WL) {
    p.setConstant(NAN);
  }
  const Evaluation evaluation = must(evaluate(clip, 0.0, rootless));
  EXPECT_TRUE(std::isnan(evaluation.all.position_mean_mm));
  EXPECT_LT(evaluation.all.mean_deg, 1e-9);
}

TEST(Evaluate, GapsAreLeftOutAndSamplesInterpolated) {
  const motion::Clip clip = test::random_clip(1, 61, 60.0, 36);
  Truth truth = truth_of(motion::resampled(clip, 240.0), 0.0);
  Truth::SegmentTruth& segment = truth.segments[0];
  // Nothing is known from 0.3 to 0.5 s, and what is known before is wrong by 5°.
  Truth::SegmentTruth holed;
  holed.name = segment.name;
  for (std::size_t i = 0; i < segment.times.size(); ++i) {
    if (segment.times[i] <= 0.3 || segment.times[i] >= 0.5) {
      holed.times.push_back(segment.times[i]);
      holed.R_WL.push_back(segment.times[i] <= 0.3 ? segment.R_WL[i] * about({0, 0, 1}, 5.0) : segment.R_WL[i]);
      holed.p_WL.push_back(segment.p_WL[i]);
    }
  }
  truth.segments[0] = holed;
  // A start off the grid of the truth: keys fall between samples.
  const Evaluation evaluation = must(evaluate(clip, 0.0, truth));
  EXPECT_NEAR(evaluation.all.mean_deg, 5.0 * 19 / (19 + 31), 1e-6);
  const Evaluation shifted = must(evaluate(motion::trimmed(clip, 0.001, 0.25), 0.001, truth));
  EXPECT_NEAR(shifted.all.mean_deg, 5.0, 1e-3);
}

TEST(Evaluate, FailsWithoutAnythingInCommon) {
  const motion::Clip clip = test::random_clip(2, 5, 60.0, 37);
  Truth truth = truth_of(clip, 0.0);
  EXPECT_FALSE(evaluate(clip, 100.0, truth).ok());
  truth.segments[0].name = "a";
  truth.segments[1].name = "b";
  EXPECT_FALSE(evaluate(clip, 0.0, truth).ok());
  EXPECT_FALSE(evaluate(clip, 0.0, {}).ok());
}

TEST(Evaluate, JsonHasTheDocumentedKeysAndLeavesOutWhatIsNotKnown) {
  const motion::Clip clip = test::random_clip(2, 5, 60.0, 38);
  Truth truth = truth_of(clip, 0.0);
  Evaluation evaluation = must(evaluate(clip, 0.0, truth));
  evaluation.take_seconds = 2.0;
  evaluation.decode_seconds = 0.5;
  evaluation.solve_seconds = 0.25;
  const nlohmann::json json = evaluation_to_json(evaluation);
  EXPECT_EQ(json["seconds"], (nlohmann::json{{"take", 2.0}, {"decode", 0.5}, {"solve", 0.25}}));
  for (const char* key : {"mean_deg", "sd_deg", "rms_deg", "p95_deg", "max_deg", "position_mean_mm"}) {
    EXPECT_TRUE(json["joints"]["joint1"].contains(key)) << key;
    EXPECT_TRUE(json["segments"]["joint0"].contains(key)) << key;
  }
  for (const char* key : {"inclination_mean_deg", "inclination_rms_deg", "inclination_max_deg"}) {
    EXPECT_FALSE(json["joints"]["joint1"].contains(key)) << key;
    EXPECT_TRUE(json["segments"]["joint0"].contains(key)) << key;
    EXPECT_TRUE(json["all"].contains(key)) << key;
  }
  truth.segments.pop_back();
  truth.segments[0].p_WL.clear();
  const nlohmann::json less = evaluation_to_json(must(evaluate(clip, 0.0, truth)));
  EXPECT_FALSE(less.contains("joints"));
  EXPECT_FALSE(less.contains("seconds"));
  EXPECT_FALSE(less["all"].contains("position_mean_mm"));
  EXPECT_NO_THROW(static_cast<void>(less.dump()));
}

TEST(Evaluate, AgreesWithTheClipsOwnCsv) {
  motion::Clip clip = test::random_clip(5, 30, 60.0, 39);
  clip.skeleton.segments[2].name = "hand, \"left\"";
  const Result<std::string> csv = interchange::csv_poses_text(clip);
  ASSERT_TRUE(csv.ok());
  const Result<Truth> truth = truth_from_csv(*csv, "poses.csv");
  ASSERT_TRUE(truth.ok()) << truth.error().text();
  ASSERT_EQ(truth->segments.size(), 5U);
  const Evaluation evaluation = must(evaluate(clip, 0.0, *truth));
  EXPECT_EQ(evaluation.segments.size(), 5U);
  EXPECT_LT(evaluation.all.max_deg, 1e-6);
  EXPECT_LT(evaluation.all.position_mean_mm, 1e-3);
}

}  // namespace
}  // namespace limbwave::evaluate
