// Every fault of the line has a finding that says what to do, and clean lines have none.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "decode/line_in.h"
#include "support/decode_signal.h"
#include "support/line_in_signal.h"

namespace limbwave::decode {
namespace {

using test::Decoded;
using test::LineInSignalSpec;

constexpr double kRate = 48000.0;

LineInSignalSpec moving() {
  LineInSignalSpec spec;
  spec.rate = kRate;
  spec.coupling_hz = 5.0;
  spec.noise = 3e-4;
  spec.seconds = 4.0;
  spec.volts = [](int axis, double t) { return 1.65 + 0.02 * axis + 0.3 * std::sin(4.0 * t + axis); };
  return spec;
}

Decoded decode(const LineInSignalSpec& spec, const LineInParameters& parameters = {}) {
  return test::decode_signal(test::make_line_in_signal(spec).interleaved, spec.rate, parameters);
}

/// Largest error of valid cycles that lie in [from, to) seconds.
double worst_error(const LineInSignalSpec& spec, const Decoded& decoded, double from = 0.0, double to = 1e9) {
  double worst = 0.0;
  int count = 0;
  for (const LineInCycle& cycle : decoded.cycles) {
    const double time = cycle.start_sample / spec.rate;
    if (!cycle.valid || time < from || time >= to) {
      continue;
    }
    ++count;
    for (int j = 0; j < 15; ++j) {
      const auto slot = static_cast<std::size_t>(j);
      worst = std::max(worst, std::fabs(cycle.volts[slot] - test::true_volts(spec, j, cycle.sample[slot])));
    }
  }
  return count > 0 ? worst : std::numeric_limits<double>::infinity();
}

std::vector<float> stereo(double seconds, const std::function<std::pair<double, double>(double)>& value) {
  std::vector<float> samples;
  for (std::size_t n = 0; n < static_cast<std::size_t>(seconds * kRate); ++n) {
    const auto [left, right] = value(static_cast<double>(n) / kRate);
    samples.push_back(static_cast<float>(left));
    samples.push_back(static_cast<float>(right));
  }
  return samples;
}

void expect_only(const Decoded& decoded, const std::string& code) {
  EXPECT_TRUE(decoded.has(code)) << decoded.texts();
  for (const Diagnostic& finding : decoded.findings) {
    EXPECT_EQ(finding.code, code) << finding.text();
    EXPECT_FALSE(finding.message.empty());
    EXPECT_FALSE(finding.remedy.empty());
  }
}

constexpr double kNoiseBound = 2.5e-3;  // volts: more than noise ever makes of a value here

TEST(LineInFindings, InvertedAndSwappedChannelsAreTurnedBackAndTold) {
  for (const bool left : {false, true}) {
    for (const bool right : {false, true}) {
      for (const bool swapped : {false, true}) {
        LineInSignalSpec spec = moving();
        spec.left_inverted = left;
        spec.right_inverted = right;
        spec.swapped = swapped;
        const Decoded decoded = decode(spec);
        SCOPED_TRACE(decoded.texts());
        EXPECT_EQ(decoded.status.left_inverted, left);
        EXPECT_EQ(decoded.status.right_inverted, right);
        EXPECT_EQ(decoded.status.swapped, swapped);
        EXPECT_EQ(decoded.has("line-in.left-inverted"), left);
        EXPECT_EQ(decoded.has("line-in.right-inverted"), right);
        EXPECT_EQ(decoded.has("line-in.swapped"), swapped);
        EXPECT_EQ(decoded.findings.size(), static_cast<std::size_t>(left) + right + swapped);
        EXPECT_LT(worst_error(spec, decoded), kNoiseBound);
      }
    }
  }
}

TEST(LineInFindings, TheUsersWordCountsMoreThanTheSignal) {
  LineInParameters parameters;
  parameters.left = Polarity::kInverted;
  parameters.right = Polarity::kNormal;
  parameters.swapped = false;
  const Decoded decoded = decode(moving(), parameters);
  EXPECT_TRUE(decoded.status.left_inverted);
  ASSERT_FALSE(decoded.cycles.empty());
  EXPECT_LT(decoded.cycles[5].volts[0], 0.0);
}

TEST(LineInFindings, CleanLinesHaveNone) {
  for (const double rate : {44100.0, 48000.0, 88200.0, 96000.0, 192000.0}) {
    for (const double offset : {-0.1, -0.04, 0.07, 0.1}) {
      LineInSignalSpec spec = test::paper_electronics(rate, offset > 0.0 ? 5.0 : 1.0);
      spec.anti_alias = false;  // takes long and is tested elsewhere
      spec.clock_offset = offset;
      spec.slot_jitter = 0.003;
      spec.dc_offset = 0.02;
      spec.seconds = 3.0;
      spec.volts = [](int axis, double t) { return 1.65 + 0.6 * std::sin(12.0 * t + 0.3 * axis * axis); };
      const Decoded decoded = decode(spec);
      EXPECT_TRUE(decoded.findings.empty()) << rate << " " << offset << "\n" << decoded.texts();
      EXPECT_GT(decoded.cycles.size(), 150U);
      EXPECT_EQ(decoded.status.lost_cycles, 0);
      EXPECT_NEAR(decoded.status.cycle_rate_hz, 60.0 * (1.0 + offset), 1.0);
    }
  }
}

TEST(LineInFindings, WhatClippingLeavesIsRightOrMarked) {
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

TEST(LineInFindings, ClicksAreLeftOutAndTold) {
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

TEST(LineInFindings, AnUnbalancedLineIsTold) {
  for (const double left : {0.5, 1.7}) {
    LineInSignalSpec spec = moving();
    spec.full_scale_volts = 3.3;
    spec.left_gain = [left](double) { return left; };
    const Decoded decoded = decode(spec);
    expect_only(decoded, "line-in.unbalanced");
    EXPECT_NE(decoded.texts().find(left < 1.0 ? "left channel seems to be recorded at 0.5" : "at 1."),
              std::string::npos)
        << decoded.texts();
    // Values come out as they are, at the other gain.
    ASSERT_FALSE(decoded.cycles.empty());
    const LineInCycle& cycle = decoded.cycles.back();
    EXPECT_NEAR(cycle.volts[3], left * test::true_volts(spec, 3, cycle.sample[3]), left * kNoiseBound);
  }
  LineInSignalSpec slightly = moving();
  slightly.left_gain = [](double) { return 0.8; };
  EXPECT_TRUE(decode(slightly).findings.empty());
}

TEST(LineInFindings, AReferenceAmongTheSensorsIsTold) {
  LineInSignalSpec spec = moving();
  spec.reference_volts = 1.65;  // a board whose reference is not where the rig says
  spec.volts = [](int axis, double t) { return 1.65 + (axis % 2 == 0 ? 0.3 : -0.3) + 0.1 * std::sin(4.0 * t + axis); };
  const Decoded decoded = decode(spec);
  expect_only(decoded, "line-in.no-reference");
  EXPECT_FALSE(decoded.status.left_inverted);
  EXPECT_FALSE(decoded.status.right_inverted);
  EXPECT_LT(worst_error(spec, decoded), kNoiseBound);
  // The user can say what the signal cannot.
  spec.left_inverted = true;
  LineInParameters parameters;
  parameters.left = Polarity::kInverted;
  const Decoded told = decode(spec, parameters);
  EXPECT_TRUE(told.has("line-in.no-reference"));
  EXPECT_TRUE(told.status.left_inverted);
  EXPECT_LT(worst_error(spec, told), kNoiseBound);
}

TEST(LineInFindings, NothingButSilence) {
  std::mt19937 generator(1);
  std::normal_distribution<double> noise(0.0, 3e-4);
  expect_only(test::decode_signal(stereo(3.0,
                                         [&](double) {
                                           return std::pair{noise(generator), noise(generator)};
                                         }),
                                  kRate),
              "line-in.silent");
  expect_only(test::decode_signal(std::vector<float>(200000, 0.0F), kRate), "line-in.silent");
}

TEST(LineInFindings, MonoInputs) {
  auto samples = test::make_line_in_signal(moving()).interleaved;
  auto copies = samples;
  auto mixed = samples;
  auto deaf = samples;
  for (std::size_t i = 0; i < samples.size(); i += 2) {
    copies[i] = 0.5F * copies[i + 1];
    mixed[i] = mixed[i + 1] = 0.5F * (samples[i] + samples[i + 1]);
    deaf[i + 1] = 0.0F;
  }
  expect_only(test::decode_signal(copies, kRate), "line-in.mono");
  expect_only(test::decode_signal(mixed, kRate), "line-in.mono");
  expect_only(test::decode_signal(deaf, kRate), "line-in.mono");
  for (std::size_t i = 0; i < samples.size(); i += 2) {
    samples[i] = 0.0F;
  }
  expect_only(test::decode_signal(samples, kRate), "line-in.no-slots");
}

TEST(LineInFindings, WrongInputs) {
  std::mt19937 generator(2);
  std::normal_distribution<double> noise(0.0, 0.1);
  const double turn = 2.0 * std::numbers::pi;
  for (const double hz : {50.0, 60.0}) {
    const Decoded hum = test::decode_signal(
        stereo(3.0,
               [&](double t) {
                 return std::pair{0.3 * std::sin(turn * hz * t), 0.2 * std::sin(turn * hz * t + 1.0)};
               }),
        kRate);
    expect_only(hum, "line-in.wrong-input");
    EXPECT_NE(hum.texts().find("hum"), std::string::npos);
    EXPECT_TRUE(hum.cycles.empty());
  }
  expect_only(test::decode_signal(stereo(3.0,
                                         [&](double) {
                                           return std::pair{noise(generator), noise(generator)};
                                         }),
                                  kRate),
              "line-in.wrong-input");
  // Music: a melody of decaying notes with overtones.
  const Decoded music = test::decode_signal(
      stereo(5.0,
             [&](double t) {
               const double note = 220.0 * std::pow(2.0, std::floor(std::fmod(t * 4.0, 7.0)) / 12.0);
               const double decay = std::exp(-6.0 * std::fmod(t, 0.25));
               const double tone = std::sin(turn * note * t) + 0.5 * std::sin(turn * 2.0 * note * t + 0.4);
               return std::pair{0.3 * decay * tone,
                                0.3 * decay * tone * std::cos(3.0 * t) + 0.05 * std::sin(turn * 90.0 * t)};
             }),
      kRate);
  EXPECT_TRUE(music.cycles.empty());
  EXPECT_FALSE(music.findings.empty());
  EXPECT_FALSE(music.status.locked);
}

TEST(LineInFindings, ABoardWithAnotherClock) {
  LineInSignalSpec spec = moving();
  spec.cycle_hz = 80.0;
  const Decoded decoded = decode(spec);
  expect_only(decoded, "line-in.clock-rate");
  EXPECT_NE(decoded.texts().find("80.0"), std::string::npos) << decoded.texts();
}

TEST(LineInFindings, TooLowALevelIsStillDecoded) {
  LineInSignalSpec spec = moving();
  spec.full_scale_volts = 3.3 / 0.012;
  spec.noise = 0.0;
  spec.bits = 16;
  const Decoded decoded = decode(spec);
  expect_only(decoded, "line-in.low-level");
  EXPECT_LT(worst_error(spec, decoded), 0.02);
}

TEST(LineInFindings, TooLowARateIsTold) {
  for (const double rate : {22050.0, 32000.0}) {
    LineInSignalSpec spec = test::paper_electronics(rate, 5.0);
    spec.noise = 2e-4;
    spec.seconds = 4.0;
    const Decoded decoded = decode(spec);
    EXPECT_EQ(decoded.has("line-in.low-rate"), rate < 30000.0) << decoded.texts();
    EXPECT_LT(worst_error(spec, decoded), 0.005) << rate;
  }
}

TEST(LineInFindings, ClippedSlotsAreMarked) {
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

TEST(LineInFindings, AClippedCounterKeepsTheLastGoodScale) {
  LineInSignalSpec spec = moving();
  spec.bits = 16;
  spec.noise = 0.0;
  spec.right_gain = [](double t) { return t < 2.0 ? 1.0 : 1.9; };
  const Decoded decoded = decode(spec);
  EXPECT_TRUE(decoded.has("line-in.counter-clipped")) << decoded.texts();
  EXPECT_LT(worst_error(spec, decoded, 2.1), 2e-3);
}

TEST(LineInFindings, AMovedKnobIsFollowedAndTold) {
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

TEST(LineInFindings, ASlowlyTurnedKnobToo) {
  LineInSignalSpec spec = moving();
  spec.gain = [](double t) { return t < 2.0 ? 1.0 : t < 2.5 ? 1.0 - 0.8 * (t - 2.0) : 0.6; };
  const Decoded decoded = decode(spec);
  expect_only(decoded, "line-in.level-changed");
  EXPECT_LT(worst_error(spec, decoded, 0.0, 2.0), kNoiseBound);
  EXPECT_LT(worst_error(spec, decoded, 2.55), kNoiseBound);
  EXPECT_LT(worst_error(spec, decoded), 0.01);
}

TEST(LineInFindings, ABalanceThatChangesIsTold) {
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

TEST(LineInFindings, HumIsToldAndCostsNoCycles) {
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

TEST(LineInFindings, SteadyHumIsTakenOut) {
  // With harmonics, a mains a little off, a drifting clock and moving sensors.
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
        samples[2 * n] += static_cast<float>(
            amplitude * (std::sin(phase) + 0.2 * std::sin(2.0 * phase + 1.0) + 0.4 * std::sin(3.0 * phase + 2.0)));
      }
      const Decoded decoded = test::decode_signal(samples, kRate);
      SCOPED_TRACE(testing::Message() << mains << " Hz, " << amplitude << "\n" << decoded.texts());
      if (amplitude > 0.002) {
        expect_only(decoded, "line-in.hum");
      }
      // Not taken out it is up to 1.6 amplitudes of full scale (2.36 V), and as much again from the reference.
      EXPECT_LT(worst_error(spec, decoded, 2.0), clean + 0.1 * 2.0 * 1.6 * amplitude * 3.3 / 1.4);
    }
  }
}

TEST(LineInFindings, SamplesLostWithoutNotice) {
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

TEST(LineInFindings, APlugPulledAndPutBack) {
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

TEST(LineInFindings, KnownGapsKeepTheClock) {
  const LineInSignalSpec spec = moving();
  const auto samples = test::make_line_in_signal(spec).interleaved;
  LineInDecoder decoder(LineInFormat{}, SampleRate{kRate});
  const std::size_t from = 2 * 90001;
  const std::size_t to = from + 2 * 5432;
  decoder.push(std::span(samples).first(from));
  decoder.gap(SampleCount{5432});
  decoder.push(std::span(samples).subspan(to));
  decoder.finish();
  const Decoded decoded{decoder.take_cycles(), decoder.take_diagnostics(), decoder.status()};
  EXPECT_TRUE(decoded.findings.empty()) << decoded.texts();
  EXPECT_LT(worst_error(spec, decoded), kNoiseBound);
  int gaps = 0;
  for (const LineInCycle& cycle : decoded.cycles) {
    gaps += cycle.gap_before ? 1 : 0;
    EXPECT_EQ(cycle.number,
              std::llround((cycle.start_sample - decoded.cycles.front().start_sample) / cycle.period_samples));
  }
  EXPECT_EQ(gaps, 1);
}

TEST(LineInFindings, SamplesThatAreNotNumbers) {
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

TEST(LineInFindings, FaultsThatKeepComingAreCounted) {
  auto samples = test::make_line_in_signal(moving()).interleaved;
  for (std::size_t i = 0; i < 20; ++i) {
    samples[2 * (60000 + 3000 * i)] = std::numeric_limits<float>::quiet_NaN();
  }
  const Decoded decoded = test::decode_signal(samples, kRate);
  expect_only(decoded, "line-in.not-finite");
  EXPECT_EQ(decoded.findings.size(), 6U) << decoded.texts();
  EXPECT_NE(decoded.findings.back().message.find("20 times"), std::string::npos) << decoded.texts();
}

TEST(LineInFindings, ShortAndEmptySignals) {
  expect_only(test::decode_signal(std::vector<float>(200, 0.1F), kRate), "line-in.too-short");
  LineInDecoder decoder(LineInFormat{}, SampleRate{kRate});
  decoder.finish();
  EXPECT_TRUE(decoder.take_cycles().empty());
  LineInSignalSpec spec = moving();
  spec.seconds = 0.3;
  const Decoded decoded = decode(spec);
  EXPECT_TRUE(decoded.findings.empty()) << decoded.texts();
  EXPECT_GE(decoded.cycles.size(), 15U);
  EXPECT_LT(worst_error(spec, decoded), 2.0 * kNoiseBound);
}

}  // namespace
}  // namespace limbwave::decode
