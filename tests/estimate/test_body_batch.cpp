#include <gtest/gtest.h>

#include "estimate/body_adjoint.h"
#include "estimate/body_batch.h"
#include "support/drawn_wearer.h"

namespace limbwave::estimate {
namespace {

struct Recording {
  BodyModel model;
  BodyReadings readings;
  std::vector<std::vector<Quaterniond>> truth;
};
Recording record(const BodyFilterParameters& p, unsigned seed, int steps) {
  Drawn drawn(seed, p);
  BodyFilter filter(drawn.model, p);
  drawn.start(filter);
  Recording recording{drawn.model, {}, {}};
  for (int k = 1; k <= steps; ++k) {
    drawn.move(filter, 0.01);
    drawn.measure(filter, k % 5 == 0, recording.readings);
    recording.truth.push_back(filter.tree().segment_rotations(drawn.truth.joints));
  }
  return recording;
}

double square_error(const BodyTrack& track, const std::vector<std::vector<Quaterniond>>& truth) {
  double sum = 0.0;
  for (std::size_t i = 0; i < track.times.size(); ++i) {
    for (std::size_t s = 0; s < truth[i].size(); ++s) {
      const double e = geometry::geodesic_angle(track.R_joint[i][s], truth[i][s]);
      sum += e * e;
    }
  }
  return sum;
}

// Errors so large that one linearisation does not do.
BodyFilterParameters large_errors() {
  BodyFilterParameters p = modelled_errors_only();
  p.rest_pose = 0.5;
  p.mount_rotation = 0.15;
  p.start_rate = 0.5;
  return p;
}

TEST(BodyBatch, ErrorsThatAreNotSmallNeedMoreThanOneLinearisation) {
  double of_smoother = 0.0;
  double of_batch = 0.0;
  for (unsigned seed = 20; seed < 26; ++seed) {
    const BodyFilterParameters p = large_errors();
    const Recording recording = record(p, seed, 120);
    const auto smoothed = smooth_body(recording.model, p, recording.readings, 1000.0, {});
    const auto optimum = optimise_body(recording.model, p, recording.readings, 1000.0, {});
    ASSERT_TRUE(smoothed.ok() && optimum.ok());
    ASSERT_EQ(optimum->run.track.times.size(), recording.truth.size());
    EXPECT_LE(optimum->costs[optimum->best], optimum->costs.front());
    of_smoother += square_error(smoothed->track, recording.truth);
    of_batch += square_error(optimum->run.track, recording.truth);
  }
  EXPECT_LT(of_batch, 0.97 * of_smoother);
}

TEST(BodyBatch, StopsWhenAskedTo) {
  const BodyFilterParameters p = modelled_errors_only();
  const Recording recording = record(p, 30, 50);
  const Progress progress([](double fraction, std::string_view) { return fraction < 0.2; });
  const auto optimum = optimise_body(recording.model, p, recording.readings, 1000.0, progress);
  ASSERT_FALSE(optimum.ok());
  EXPECT_TRUE(is_cancelled(optimum.error()));
}

// Where a step is linearised about its own prediction nothing changes.
TEST(BodyFilter, LinearisedAboutItsPredictionIsTheSame) {
  const BodyFilterParameters p = modelled_errors_only();
  const Recording recording = record(p, 31, 20);
  BodyFilter plain(recording.model, p);
  BodyFilter about(recording.model, p);
  plain.start(0.0, nullptr);
  about.start(0.0, nullptr);
  for (const BodyInstant& instant : instants_of(recording.readings)) {
    BodyFilter ahead(recording.model, p);
    ahead.resume(plain.snapshot());
    const BodyInstant nothing{instant.time_s, nullptr, 0, nullptr, 0};
    ahead.step(nothing, nullptr);
    const BodyState prediction = ahead.state();
    plain.step(instant, nullptr);
    about.step(instant, nullptr, nullptr, &prediction);
  }
  EXPECT_LT(plain.difference(plain.state(), about.state()).norm(), 1e-9);
  EXPECT_LT((plain.covariance().dense() - about.covariance().dense()).norm(), 1e-12);
}

TEST(BodyFilter, DifferenceIsInjectionBackward) {
  const BodyFilterParameters p = large_errors();
  Drawn drawn(32, p);
  const BodyFilter filter(drawn.model, p);
  BodyState state = filter.state();
  VectorXd x(filter.layout().size);
  for (double& value : x) {
    value = 0.1 * drawn.normal();
  }
  filter.inject(state, x);
  EXPECT_LT((filter.difference(filter.state(), state) - x).norm(), 1e-12);
}

// The same adjoint, alone and beside those driven by chance.
TEST(BodyAdjoint, SamplesDoNotDisturbTheReadings) {
  BodyFilterParameters p = modelled_errors_only();
  p.tissue_angle = 0.02;
  const Recording recording = record(p, 33, 40);
  BodyFilter filter(recording.model, p);
  filter.start(0.0, nullptr);
  std::vector<StepRecord> steps;
  for (const BodyInstant& instant : instants_of(recording.readings)) {
    filter.step(instant, nullptr, &steps.emplace_back());
  }
  VectorXd alone = VectorXd::Zero(filter.layout().size);
  SampledAdjoint sampled(filter.layout().size);
  for (std::size_t i = steps.size(); i-- > 0;) {
    adjoint_over_step(steps[i], filter.tree(), alone);
    sampled.over_step(steps[i], filter.tree());
  }
  EXPECT_GT(alone.norm(), 0.0);
  EXPECT_LT((sampled.lambda() - alone).norm(), 1e-9 * alone.norm());
}

}  // namespace
}  // namespace limbwave::estimate
