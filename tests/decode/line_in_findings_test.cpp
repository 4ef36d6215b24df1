// Every fault of the line has a finding that says what to do, and clean lines have none.
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <random>

#include "decode/finding_log.h"
#include "decode/findings_support.h"

namespace limbwave::decode {
namespace {

// A line that is listened to for hours: the recording that begins then has its own findings.
TEST(LineInFindings, StartAnewWithARecording) {
  LineInSignalSpec spec = moving();
  spec.seconds = 30.0;
  const test::LineInSignal signal = test::make_line_in_signal(spec);
  std::vector<float> exchanged = signal.interleaved;
  for (std::size_t n = 0; n + 1 < exchanged.size(); n += 2) {
    std::swap(exchanged[n], exchanged[n + 1]);
  }
  // Every second 10 ms are missing.
  std::vector<float> samples;
  const auto second = static_cast<std::size_t>(2 * kRate);
  for (std::size_t from = 0; from + second <= exchanged.size(); from += second) {
    samples.insert(samples.end(), exchanged.begin() + static_cast<std::ptrdiff_t>(from),
                   exchanged.begin() + static_cast<std::ptrdiff_t>(from + second - 960));
  }
  LineInDecoder decoder(LineInFormat{}, SampleRate{kRate});
  const auto codes_in = [&](double seconds_from, double seconds_to) {
    const auto from = 2 * static_cast<std::size_t>(seconds_from * kRate);
    const auto to = std::min(samples.size(), 2 * static_cast<std::size_t>(seconds_to * kRate));
    decoder.push(std::span(samples).subspan(from, to - from));
    std::map<std::string, int> codes;
    for (const Diagnostic& finding : decoder.take_diagnostics()) {
      ++codes[finding.code];
    }
    return codes;
  };
  std::map<std::string, int> before = codes_in(0.0, 15.0);
  EXPECT_EQ(before["line-in.swapped"], 1);
  EXPECT_EQ(before["line-in.sync-lost"], 5) << "the others are counted";
  decoder.restart_findings();
  std::map<std::string, int> during = codes_in(15.0, 30.0);
  EXPECT_EQ(during["line-in.swapped"], 1) << "still so";
  EXPECT_EQ(during["line-in.sync-lost"], 5) << "of this recording";
  decoder.sum_up_findings();
  const Diagnostics sums = decoder.take_diagnostics();
  ASSERT_EQ(sums.size(), 1U);
  EXPECT_EQ(sums.front().code, "line-in.sync-lost");
  EXPECT_NE(sums.front().message.find("14 times in all, 5 of them told"), std::string::npos) << sums.front().message;
  decoder.sum_up_findings();
  EXPECT_TRUE(decoder.take_diagnostics().empty()) << "once";
}

TEST(FindingLog, ToldAgainEveryMinute) {
  FindingLog log(2);
  for (int i = 0; i < 200; ++i) {
    log.add({Severity::kWarning, "code", "message", "remedy", "", 1.0 * i});
  }
  std::vector<double> times;
  for (const Diagnostic& finding : log.take()) {
    times.push_back(finding.time_s);
  }
  EXPECT_EQ(times, (std::vector<double>{0.0, 1.0, 61.0, 121.0, 181.0}));
  log.summarise();
  const Diagnostics sums = log.take();
  ASSERT_EQ(sums.size(), 1U);
  EXPECT_EQ(sums.front().message, "200 times in all, 5 of them told; the last: message");
}

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
