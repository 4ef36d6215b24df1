#include <fmt/format.h>
#include <gtest/gtest.h>

#include "estimate/chain_smoother.h"
#include "estimate/synthetic_chain.h"

namespace limbwave::estimate {
namespace {

using Estimates = std::vector<std::vector<Inclination>>;

struct Errors {
  double mean_deg = 0.0, within_2sd = 0.0;
};

Errors errors_of(const test::ChainSeries& series, const Estimates& estimates, double from_s = 0.0, double to_s = 1e9) {
  Errors errors;
  double count = 0.0;
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    for (std::size_t k = 0; k < series.times.size(); ++k) {
      if (series.times[k] >= from_s && series.times[k] < to_s) {
        const double error = geometry::angle_between(estimates[i][k].up_L, series.up_L(i, k));
        errors.mean_deg += degrees(error);
        errors.within_2sd += error <= 2.0 * estimates[i][k].sd_rad ? 1.0 : 0.0;
        count += 1.0;
      }
    }
  }
  errors.mean_deg /= count;
  errors.within_2sd /= count;
  return errors;
}

Estimates single(const test::ChainSeries& series) {
  Estimates estimates;
  for (const auto& samples : series.samples) {
    estimates.push_back(estimate_inclinations(samples, Smoothing::kAdaptive));
  }
  return estimates;
}

Estimates together(const test::ChainSeries& series) {
  auto result = smooth_chain(series.chain, series.samples, single(series), {}, {});
  EXPECT_TRUE(result);
  return *result;
}

TEST(ChainSmoother, ASwingingArmIsFoundWhereSingleSensorsFail) {
  const LimbChain chain = test::three_links();
  const auto series = test::felt_by_chain(12.0, test::swinging, 0.02, chain, chain);
  const double alone = errors_of(series, single(series), 3.0).mean_deg;
  const Estimates estimates = together(series);
  const Errors errors = errors_of(series, estimates, 3.0);
  fmt::print("moving: single sensors {:.2f}°, together {:.2f}°, {:.0f} % within 2 sd\n", alone, errors.mean_deg,
             100.0 * errors.within_2sd);
  EXPECT_GT(alone, 5.0);
  EXPECT_LT(errors.mean_deg, 0.3 * alone);
  EXPECT_GT(errors.within_2sd, 0.75);
  // At rest there is nothing to gain, and nothing must be lost.
  EXPECT_LT(errors_of(series, estimates, 0.0, 1.7).mean_deg, 0.5);
}

// Another arm than the one that is believed in: 8 % shorter, sensors 2 cm away from their places.
TEST(ChainSmoother, LengthsThatAreAlittleWrongStillHelp) {
  const LimbChain believed = test::three_links();
  LimbChain really = believed;
  for (ChainLink& link : really.links) {
    link.p_PL *= 0.92;
    link.p_LS += Vector3d(0.02, -0.01, 0.01);
  }
  const auto series = test::felt_by_chain(12.0, test::swinging, 0.05, really, believed);
  const double alone = errors_of(series, single(series), 3.0).mean_deg;
  const Errors errors = errors_of(series, together(series), 3.0);
  fmt::print("moving: single sensors {:.2f}°, together {:.2f}°, {:.0f} % within 2 sd\n", alone, errors.mean_deg,
             100.0 * errors.within_2sd);
  EXPECT_LT(errors.mean_deg, 0.5 * alone);
}

// Sensors that have nothing to do with one another: what they say alone must stand.
TEST(ChainSmoother, SensorsThatDoNotBelongTogetherAreLeftAlone) {
  const body::Rig rig = *body::load_rig("line-in-arm");
  test::ChainSeries series;
  series.chain = limb_chain(rig, *body::load_skeleton(rig.skeleton));
  for (std::size_t i = 0; i < series.chain.links.size(); ++i) {
    const double shift = 1.7 * static_cast<double>(i);
    const auto one = test::felt(
        15.0, [&](double t) { return test::slow_turn(1.6 * t + 5.0 * shift); },
        [&](double t) { return test::bursts(t + shift, 6.0); }, 0.05, 1 + i);
    series.samples.push_back(one.samples);
    auto& R_WL = series.R_WL.emplace_back();
    for (std::size_t k = 0; k < one.samples.size(); ++k) {
      R_WL.push_back(test::slow_turn(1.6 * one.samples[k].time_s + 5.0 * shift));
    }
  }
  for (const ForceSample& sample : series.samples.front()) {
    series.times.push_back(sample.time_s);
  }
  const Errors alone = errors_of(series, single(series));
  const Errors errors = errors_of(series, together(series));
  fmt::print("strangers: single sensors {:.2f}°, together {:.2f}°\n", alone.mean_deg, errors.mean_deg);
  EXPECT_LT(errors.mean_deg, 1.1 * alone.mean_deg + 0.05);
}

TEST(ChainSmoother, GapsClippedReadingsAndLateStartsAreSurvived) {
  const LimbChain chain = test::three_links();
  auto series = test::felt_by_chain(16.0, test::swinging, 0.02, chain, chain);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto cut = [](auto& all) { all.erase(all.begin() + 500, all.begin() + 560); };  // a second is lost
    cut(series.samples[i]);
    cut(series.R_WL[i]);
    for (std::size_t k = 300; k < 312; ++k) {
      series.samples[i][k].usable = false;
      series.samples[i][k].f_L.setConstant(std::nan(""));
    }
    for (std::size_t k = 0; k < 5; ++k) {
      series.samples[i][k].usable = false;
    }
  }
  series.times.erase(series.times.begin() + 500, series.times.begin() + 560);
  const Estimates estimates = together(series);
  for (const auto& inclinations : estimates) {
    ASSERT_EQ(inclinations.size(), series.times.size());
    for (std::size_t k = 0; k < inclinations.size(); ++k) {
      EXPECT_TRUE(inclinations[k].known);
      EXPECT_EQ(inclinations[k].time_s, series.times[k]);
      EXPECT_NEAR(inclinations[k].up_L.norm(), 1.0, 1e-9);
      EXPECT_TRUE(std::isfinite(inclinations[k].sd_rad));
    }
  }
  EXPECT_LT(errors_of(series, estimates, 3.0).mean_deg, 0.5 * errors_of(series, single(series), 3.0).mean_deg);
  // Nothing to estimate is no failure.
  test::ChainSeries empty = series;
  for (auto& samples : empty.samples) {
    samples.clear();
  }
  EXPECT_TRUE(smooth_chain(chain, empty.samples, single(empty), {}, {})->front().empty());
}

// Windows of a long take are blended: no jump where they meet.
TEST(ChainSmoother, WindowsFitTogether) {
  const LimbChain chain = test::three_links();
  const auto series = test::felt_by_chain(30.0, test::swinging, 0.02, chain, chain);
  const Estimates estimates = together(series);
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    for (std::size_t k = 1; k < series.times.size(); ++k) {
      const double turned = geometry::angle_between(estimates[i][k].up_L, estimates[i][k - 1].up_L);
      const double really = geometry::angle_between(series.up_L(i, k), series.up_L(i, k - 1));
      EXPECT_LT(degrees(std::abs(turned - really)), 2.5) << i << " at " << series.times[k];
    }
  }
  EXPECT_LT(errors_of(series, estimates, 3.0).mean_deg, 0.3 * errors_of(series, single(series), 3.0).mean_deg);
}

TEST(ChainSmoother, TheSameReadingsGiveTheSameResult) {
  const LimbChain chain = test::three_links();
  const auto series = test::felt_by_chain(5.0, test::swinging, 0.02, chain, chain);
  const Estimates once = together(series);
  EXPECT_EQ(together(series)[2][200].up_L, once[2][200].up_L);
}

TEST(ChainSmoother, StopsWhenAsked) {
  const LimbChain chain = test::three_links();
  const auto series = test::felt_by_chain(5.0, test::swinging, 0.02, chain, chain);
  int calls = 0;
  double last = 0.0;
  const Progress stop([&](double fraction, std::string_view) {
    EXPECT_GE(fraction, last);
    last = fraction;
    return ++calls < 4;
  });
  const auto result = smooth_chain(chain, series.samples, single(series), {}, stop);
  ASSERT_FALSE(result);
  EXPECT_TRUE(is_cancelled(result.error()));
  EXPECT_EQ(calls, 4);
}

TEST(LimbChain, LinksAreTheSegmentsThatCarrySensors) {
  const body::Rig rig = *body::load_rig("line-in-arm");
  const body::Skeleton skeleton = *body::load_skeleton(rig.skeleton);
  const LimbChain chain = limb_chain(rig, skeleton);
  ASSERT_EQ(chain.links.size(), 5U);
  EXPECT_EQ(chain.roots(), 1);
  EXPECT_EQ(chain.links[4].parent, 3);
  EXPECT_LT((chain.links[2].p_PL - Vector3d(0.30, 0.0, 0.0)).norm(), 1e-9);
  // Without the sensor of the hand, the fingers hang on the forearm, with the hand at rest.
  body::Rig fewer = rig;
  fewer.accelerometers.erase(fewer.accelerometers.begin() + 3);
  const LimbChain shorter = limb_chain(fewer, skeleton);
  ASSERT_EQ(shorter.links.size(), 4U);
  EXPECT_EQ(shorter.links[3].parent, 2);
  EXPECT_LT((shorter.links[3].p_PL - Vector3d(0.35, 0.0, 0.0)).norm(), 1e-9);
  EXPECT_EQ(shorter.sensors[3], 3);
}

}  // namespace
}  // namespace limbwave::estimate
