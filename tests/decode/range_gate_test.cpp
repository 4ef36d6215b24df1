#include "decode/range_gate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace limbwave::decode {
namespace {

using Eigen::Vector3d;

const std::vector<Vector3d> kAnchors = {{-3, 3, 1}, {0, 3, 1.3},  {3, 3, 1},   {3, 0, 0.7},
                                        {3, -3, 1}, {0, -3, 1.3}, {-3, -3, 1}, {-3, 0, 0.7}};

Vector3d walk(double t) {
  return {1.5 * std::cos(0.5 * t), 1.2 * std::sin(0.7 * t), 1.0 + 0.1 * std::sin(t)};
}

struct Trial {
  int count = 0, accepted = 0, outliers = 0, outliers_accepted = 0, clean_refused = 0;
  double squares = 0.0, normalised = 0.0;
  std::vector<RangeReading> readings;
};

// Every pair with an offset and a noise of its own, one range in thirty far off.
Trial run(unsigned seed, double seconds, bool jump = false) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  RangeGateParameters parameters;
  parameters.place_sd = {5.0, 5.0, 0.5};
  parameters.place = {0.0, 0.0, 1.0};
  RangeGate gate(kAnchors, 4, parameters);
  std::vector<double> offsets;
  std::vector<double> noises;
  for (std::size_t a = 0; a < kAnchors.size(); ++a) {
    offsets.push_back(0.15 + 0.05 * normal(random));
    noises.push_back(0.01 * std::pow(1.3, static_cast<double>(a)));
  }
  Trial result;
  for (int n = 0; n < static_cast<int>(seconds * 100.0); ++n) {
    const double t = 0.01 * n;
    const double shifted = jump && t > 0.5 * seconds ? t + 3.0 : t;
    for (std::size_t a = 0; a < kAnchors.size(); ++a) {
      const double truth = (walk(shifted) - kAnchors[a]).norm();
      const bool outlier = uniform(random) < 1.0 / 30.0;
      const double off = outlier ? (uniform(random) < 0.5 ? -1.0 : 1.0) * (0.6 + 2.0 * uniform(random)) : 0.0;
      const RangeReading reading =
          gate.push(static_cast<int>(a), Seconds{t}, truth + offsets[a] + noises[a] * normal(random) + off);
      result.readings.push_back(reading);
      if (t < 10.0) {
        continue;  // offsets are being learnt
      }
      const bool accepted = reading.verdict == RangeVerdict::kAccepted;
      ++result.count;
      result.accepted += accepted ? 1 : 0;
      result.outliers += outlier ? 1 : 0;
      result.outliers_accepted += outlier && accepted ? 1 : 0;
      result.clean_refused += !outlier && !accepted ? 1 : 0;
      if (accepted) {
        const double error = reading.range - truth;
        result.squares += error * error;
        result.normalised += error * error / reading.variance;
      }
    }
  }
  for (std::size_t a = 0; a < kAnchors.size(); ++a) {
    if (!jump) {
      // Outliers, clipped, make it a little larger.
      EXPECT_GT(gate.noise_sd(static_cast<int>(a)), 0.6 * noises[a]) << a;
      EXPECT_LT(gate.noise_sd(static_cast<int>(a)), 2.0 * noises[a]) << a;
    }
  }
  return result;
}

TEST(RangeGate, RefusesWhatIsFarOffAndNothingElse) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Trial result = run(seed, 60.0);
    EXPECT_GT(result.outliers, 1000);
    EXPECT_LE(result.outliers_accepted, result.outliers / 100);
    EXPECT_LE(result.clean_refused, result.count / 200);
    const double rms = std::sqrt(result.squares / result.accepted);
    const double normalised = std::sqrt(result.normalised / result.accepted);
    EXPECT_LT(rms, 0.08) << seed;
    EXPECT_GT(normalised, 0.5) << seed;
    EXPECT_LT(normalised, 1.7) << seed;
  }
}

TEST(RangeGate, FindsAReceiverThatWasCarriedElsewhere) {
  const Trial result = run(7, 40.0, true);
  int late = 0;
  for (std::size_t i = result.readings.size() - 800; i < result.readings.size(); ++i) {
    late += result.readings[i].verdict == RangeVerdict::kAccepted ? 1 : 0;
  }
  EXPECT_GT(late, 700);
}

TEST(RangeGate, WhatIsNoRangeIsNothingHeard) {
  RangeGate gate(kAnchors, 0);
  for (const double range : {std::nan(""), 0.0, -1.0, HUGE_VAL}) {
    const RangeReading reading = gate.push(2, Seconds{0.0}, range);
    EXPECT_EQ(reading.verdict, RangeVerdict::kNothingHeard);
    EXPECT_TRUE(std::isinf(reading.variance));
  }
  EXPECT_EQ(gate.push(99, Seconds{0.0}, 1.0).verdict, RangeVerdict::kNothingHeard);
  const RangeReading early = gate.push(2, Seconds{0.0}, 2.5);
  EXPECT_EQ(early.verdict, RangeVerdict::kAmbiguous);
  EXPECT_EQ(early.source, 2);
  EXPECT_EQ(early.receiver, 0);
  EXPECT_FALSE(gate.running());
}

}  // namespace
}  // namespace limbwave::decode
