// What happens to a line while it runs: clipping, clicks, hum, knobs, lost samples. It is told, what is spoilt is
// marked, and what is left is right.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "decode/findings_support.h"

namespace limbwave::decode {
namespace {

TEST(LineInDisturbances, WhatClippingLeavesIsRightOrMarked) {
  // Three axes swing far beyond full scale, now one, now several in a cycle; the coupling makes what is cut off of one
  // slot an error of all that follow.
  for (const double corner : {1.0, 5.0, 20.0}) {
    LineInSignalSpec spec = moving();
    spec.coupling_hz = corner;
    spec.noise = 0.0;
    spec.bits = 16;
    spec.seconds = 6.0;
    spec.volts = [](int axis, double t) {
      const double swing = axis == 1 || axis == 6 || axis == 12 ? 2.5 : 0.2;
      return 1.65 + swing * std::sin((5.0 + 0.3 * axis) * t + axis);
    };
    const Decoded decoded = decode(spec);
    int unmarked = 0;
    int beside = 0;
    double worst = 0.0;
    for (const LineInCycle& cycle : decoded.cycles) {
      for (int j = 0; j < 15; ++j) {
        const auto slot = static_cast<std::size_t>(j);
        if (!cycle.valid || ((cycle.clipped | cycle.uncertain) >> slot & 1U) != 0) {
          continue;
        }
        ++unmarked;
        beside += cycle.clipped != 0 ? 1 : 0;
        worst = std::max(worst, std::fabs(cycle.volts[slot] - test::true_volts(spec, j, cycle.sample[slot])));
      }
    }
    EXPECT_TRUE(decoded.has("line-in.clipped")) << corner;
    EXPECT_GT(unmarked, 2500) << corner;
    EXPECT_GT(beside, 500) << corner;
    EXPECT_LT(worst, kNoiseBound) << corner;
  }
}

TEST(LineInDisturbances, ClicksAreLeftOutAndTold) {
  for (const double corner : {0.0, 5.0}) {
    for (const auto& [height, length] : {std::pair{0.05F, 5}, {0.4F, 1}, {0.4F, 20}}) {
      LineInSignalSpec spec = moving();
      spec.coupling_hz = corner;
      auto samples = test::make_line_in_signal(spec).interleaved;
      int clicks = 0;
      for (std::size_t at = 60000; at + 1000 < samples.size() / 2; at += 7019, ++clicks) {
        for (std::size_t k = 0; k < static_cast<std::size_t>(length); ++k) {
          float& left = samples[2 * (at + k)];
          left += left > 0.0F ? -height : height;
        }
      }
      const Decoded decoded = test::decode_signal(samples, kRate);
      SCOPED_TRACE(testing::Message() << corner << " Hz, " << height << " x " << length << "\n" << decoded.texts());
      expect_only(decoded, "line-in.click");
      double worst = 0.0;
      int left_out = 0;
      for (const LineInCycle& cycle : decoded.cycles) {
        for (int j = 0; j < 15; ++j) {
          const auto slot = static_cast<std::size_t>(j);
          if ((cycle.uncertain >> slot & 1U) != 0) {
            ++left_out;
          } else if (cycle.valid) {
            worst = std::max(worst, std::fabs(cycle.volts[slot] - test::true_volts(spec, j, cycle.sample[slot])));
          }
        }
      }
      EXPECT_GE(left_out, clicks / 2);
      EXPECT_LE(left_out, 2 * clicks);
      // A click where a slot begins is in no reading, only in the integral: 20 samples of it are 0.4 % of 0.4.
      EXPECT_LT(worst, corner > 0.0 && length > 5 ? 4.0 * kNoiseBound : kNoiseBound);
    }
  }
}

TEST(LineInDisturbances, ClippedSlotsAreMarked) {
  LineInSignalSpec spec = moving();
  spec.bits = 16;
  spec.volts = [](int axis, double t) { return axis == 4 && t > 2.0 && t < 2.5 ? 5.0 : 1.65 + 0.02 * axis; };
  const Decoded decoded = decode(spec);
  ASSERT_EQ(decoded.findings.size(), 2U) << decoded.texts();
  EXPECT_EQ(decoded.findings[0].code, "line-in.clipped");
  EXPECT_EQ(decoded.findings[1].code, "line-in.clipped-total");
  std::int64_t clipped = 0;
  for (const LineInCycle& cycle : decoded.cycles) {
    const double time = cycle.start_sample / kRate;
    EXPECT_EQ(cycle.clipped & ~(1U << 4U), 0U) << time;
    if (time > 2.0 && time < 2.48) {
      EXPECT_EQ(cycle.clipped, 1U << 4U) << time;
    }
    clipped += cycle.clipped != 0 ? 1 : 0;
  }
  EXPECT_EQ(decoded.status.clipped_slots, clipped);
  // The values before and after it in the cycle are as good as ever.
  double worst = 0.0;
  for (const LineInCycle& cycle : decoded.cycles) {
    for (std::size_t slot = 0; slot < 15; ++slot) {
      if (slot != 4) {
        worst = std::max(
            worst, std::fabs(cycle.volts[slot] - test::true_volts(spec, static_cast<int>(slot), cycle.sample[slot])));
      }
    }
  }
  EXPECT_LT(worst, kNoiseBound);
  EXPECT_NE(decoded.findings.front().message.find("sensor 2 axis y"), std::string::npos) << decoded.texts();
}

TEST(LineInDisturbances, AClippedCounterKeepsTheLastGoodScale) {
  LineInSignalSpec spec = moving();
  spec.bits = 16;
  spec.noise = 0.0;
  spec.right_gain = [](double t) { return t < 2.0 ? 1.0 : 1.9; };
  const Decoded decoded = decode(spec);
  EXPECT_TRUE(decoded.has("line-in.counter-clipped")) << decoded.texts();
  EXPECT_LT(worst_error(spec, decoded, 2.1), 2e-3);
}

TEST(LineInDisturbances, AMovedKnobIsFollowedAndTold) {
  for (const double factor : {0.4, 0.8, 0.97, 1.3}) {
    for (const double when : {2.0, 2.003, 2.0075, 2.011}) {
      LineInSignalSpec spec = moving();
      spec.gain = [&](double t) { return t < when ? 1.0 : factor; };
      const Decoded decoded = decode(spec);
      SCOPED_TRACE(testing::Message() << factor << " at " << when << "\n" << decoded.texts());
      ASSERT_TRUE(decoded.has("line-in.level-changed"));
      // A big jump beside an edge can hide that edge.
      EXPECT_LE(decoded.findings.size(), factor < 0.5 ? 2U : 1U);
      for (const Diagnostic& finding : decoded.findings) {
        EXPECT_NEAR(finding.time_s, when, 0.04);
      }
      EXPECT_LT(worst_error(spec, decoded), kNoiseBound / std::min(1.0, factor));
      // No more than the cycle in which it happened and its neighbours are given up.
      int invalid = 0;
      for (const LineInCycle& cycle : decoded.cycles) {
        invalid += cycle.valid ? 0 : 1;
      }
      EXPECT_LE(invalid + decoded.status.lost_cycles, 3);
    }
  }
}

TEST(LineInDisturbances, ASlowlyTurnedKnobToo) {
  LineInSignalSpec spec = moving();
  spec.gain = [](double t) { return t < 2.0 ? 1.0 : t < 2.5 ? 1.0 - 0.8 * (t - 2.0) : 0.6; };
  const Decoded decoded = decode(spec);
  expect_only(decoded, "line-in.level-changed");
  EXPECT_LT(worst_error(spec, decoded, 0.0, 2.0), kNoiseBound);
  EXPECT_LT(worst_error(spec, decoded, 2.55), kNoiseBound);
  EXPECT_LT(worst_error(spec, decoded), 0.01);
}

TEST(LineInDisturbances, ABalanceThatChangesIsTold) {
  LineInSignalSpec left = moving();
  left.left_gain = [](double t) { return t < 2.0 ? 1.0 : 0.8; };
  const Decoded left_decoded = decode(left);
  expect_only(left_decoded, "line-in.balance-changed");
  const std::string text = left_decoded.texts();
  EXPECT_TRUE(text.find("factor of 0.79") != std::string::npos || text.find("factor of 0.80") != std::string::npos)
      << text;
  LineInSignalSpec right = moving();
  right.right_gain = left.left_gain;
  expect_only(decode(right), "line-in.balance-changed");
}

TEST(LineInDisturbances, HumIsToldAndCostsNoCycles) {
  for (const double hum : {0.005, 0.02}) {
    LineInSignalSpec spec = moving();
    spec.hum = hum;
    const Decoded decoded = decode(spec);
    expect_only(decoded, "line-in.hum");
    EXPECT_EQ(decoded.findings.size(), 1U);
    int invalid = 0;
    for (const LineInCycle& cycle : decoded.cycles) {
      invalid += cycle.valid ? 0 : 1;
    }
    EXPECT_LE(invalid, 6);
  }
}

TEST(LineInDisturbances, SteadyHumIsTakenOut) {
  // With harmonics, a mains a little off, a drifting clock and moving sensors; a ground loop hums on the counter as
  // well.
  for (const bool counter_hums : {false, true}) {
    for (const double mains : {49.97, 60.03}) {
      for (const double amplitude : {0.002, 0.01, 0.03}) {
        LineInSignalSpec spec = moving();
        spec.seconds = 8.0;
        spec.clock_offset = mains < 55.0 ? 0.03 : -0.06;
        spec.clock_wander = 0.003;
        auto samples = test::make_line_in_signal(spec).interleaved;
        const double clean = worst_error(spec, test::decode_signal(samples, kRate), 2.0);
        for (std::size_t n = 0; n < samples.size() / 2; ++n) {
          const double phase = 2.0 * std::numbers::pi * mains * static_cast<double>(n) / kRate;
          const double hum =
              amplitude * (std::sin(phase) + 0.2 * std::sin(2.0 * phase + 1.0) + 0.4 * std::sin(3.0 * phase + 2.0));
          samples[2 * n] += static_cast<float>(hum);
          samples[2 * n + 1] += static_cast<float>(counter_hums ? hum : 0.0);
        }
        const Decoded decoded = test::decode_signal(samples, kRate);
        SCOPED_TRACE(testing::Message() << mains << " Hz, " << amplitude << (counter_hums ? ", both\n" : "\n")
                                        << decoded.texts());
        if (amplitude > 0.002) {
          expect_only(decoded, "line-in.hum");
        }
        // Not taken out it is up to 1.6 amplitudes of full scale (2.36 V), and as much again from the reference.
        EXPECT_LT(worst_error(spec, decoded, 2.0), clean + 0.1 * 2.0 * 1.6 * amplitude * 3.3 / 1.4);
        const auto valid = std::count_if(decoded.cycles.begin(), decoded.cycles.end(), [](const LineInCycle& cycle) {
          return cycle.valid && cycle.start_sample > 2.0 * kRate;
        });
        EXPECT_GT(static_cast<double>(valid), 0.98 * 6.0 * 60.0 * (1.0 + spec.clock_offset));
      }
    }
  }
}

TEST(LineInDisturbances, SamplesLostWithoutNotice) {
  LineInSignalSpec spec = moving();
  const auto signal = test::make_line_in_signal(spec).interleaved;
  for (const std::size_t lost : {12UL, 100UL, 333UL, 1234UL, 9000UL}) {
    auto samples = signal;
    const std::size_t at = 2 * 100000;
    samples.erase(samples.begin() + at, samples.begin() + static_cast<std::ptrdiff_t>(at + 2 * lost));
    const Decoded decoded = test::decode_signal(samples, kRate);
    SCOPED_TRACE(testing::Message() << lost << "\n" << decoded.texts());
    expect_only(decoded, "line-in.sync-lost");
    LineInSignalSpec late = spec;  // after the loss the take is ahead of the board
    late.volts = [&](int axis, double t) { return spec.volts(axis, t + static_cast<double>(lost) / kRate); };
    EXPECT_LT(worst_error(spec, decoded, 0.0, 100000.0 / kRate - 1.0 / 60.0), kNoiseBound);
    EXPECT_LT(worst_error(late, decoded, 100000.0 / kRate), kNoiseBound);
    // Found again at once.
    double longest = 0.0;
    for (std::size_t i = 1; i < decoded.cycles.size(); ++i) {
      longest = std::max(longest, decoded.cycles[i].start_sample - decoded.cycles[i - 1].start_sample);
      const bool apart =
          decoded.cycles[i].start_sample - decoded.cycles[i - 1].start_sample - decoded.cycles[i - 1].period_samples >
          1.0;
      EXPECT_EQ(decoded.cycles[i].gap_before, apart);
    }
    EXPECT_LT(longest, 3.2 * 800.0);
  }
}

TEST(LineInDisturbances, APlugPulledAndPutBack) {
  LineInSignalSpec spec = moving();
  spec.seconds = 8.0;
  const auto on = [](double t) { return t < 2.0 || t > 4.3 ? 1.0 : 0.0; };
  spec.gain = on;
  const Decoded decoded = decode(spec);
  EXPECT_TRUE(decoded.has("line-in.sync-lost")) << decoded.texts();
  EXPECT_TRUE(decoded.has("line-in.silent")) << decoded.texts();
  EXPECT_TRUE(decoded.status.locked);
  EXPECT_LT(worst_error(spec, decoded, 0.0, 1.95), kNoiseBound);
  EXPECT_LT(worst_error(spec, decoded, 5.5), kNoiseBound);
  const LineInCycle& last = decoded.cycles.back();
  EXPECT_EQ(last.number, std::llround((last.start_sample - decoded.cycles.front().start_sample) / last.period_samples));
}

// What a session puts in the place of samples that it knows are lost.
TEST(LineInDisturbances, SilenceForLostSamplesKeepsTheClock) {
  for (const double corner : {1.0, 5.0, 20.0}) {
    LineInSignalSpec spec = moving();
    spec.coupling_hz = corner;
    const auto whole = test::make_line_in_signal(spec).interleaved;
    for (const std::size_t lost : {64U, 480U, 799U, 800U, 5432U, 40000U}) {
      for (const std::size_t from : {90001U, 90117U, 90403U, 90688U}) {
        auto samples = whole;
        std::fill_n(samples.begin() + static_cast<std::ptrdiff_t>(2 * from), 2 * lost, 0.0F);
        const Decoded decoded = test::decode_signal(samples, kRate);
        SCOPED_TRACE(testing::Message() << corner << " Hz, " << lost << " from " << from << "\n" << decoded.texts());
        EXPECT_LT(worst_error(spec, decoded), kNoiseBound);
        for (const LineInCycle& cycle : decoded.cycles) {
          const double cycles = (cycle.start_sample - decoded.cycles.front().start_sample) / cycle.period_samples;
          EXPECT_EQ(cycle.number, std::llround(cycles));
          const bool silent = cycle.start_sample < static_cast<double>(from + lost) &&
                              cycle.start_sample + cycle.period_samples > static_cast<double>(from);
          EXPECT_FALSE(cycle.valid && silent && cycle.uncertain == 0 && lost > 100) << cycle.start_sample;
        }
      }
    }
  }
}

TEST(LineInDisturbances, SamplesThatAreNotNumbers) {
  const LineInSignalSpec spec = moving();
  auto samples = test::make_line_in_signal(spec).interleaved;
  samples[2 * 20000] = std::numeric_limits<float>::quiet_NaN();
  for (std::size_t i = 100000; i < 100400; ++i) {
    samples[i] = std::numeric_limits<float>::infinity();
  }
  const Decoded decoded = test::decode_signal(samples, kRate);
  expect_only(decoded, "line-in.not-finite");
  EXPECT_EQ(decoded.findings.size(), 2U) << decoded.texts();
  EXPECT_LT(worst_error(spec, decoded), kNoiseBound);
  EXPECT_GT(decoded.cycles.size(), 220U);
}

}  // namespace
}  // namespace limbwave::decode
