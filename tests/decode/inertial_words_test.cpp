#include "decode/inertial_words.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "simulate/word_line.h"

namespace limbwave::decode {
namespace {

constexpr double kRate = 140000.0;
constexpr double kAmplitude = 0.03;

// Six channels that move as a body's do, fast ones too.
simulate::WordReading motion(double t) {
  simulate::WordReading reading{};
  for (std::size_t c = 0; c < reading.size(); ++c) {
    const double value =
        900.0 * std::sin(2.0 * 3.14159265 * (0.7 + 0.4 * static_cast<double>(c)) * t + static_cast<double>(c)) +
        300.0 * std::sin(2.0 * 3.14159265 * 6.0 * t);
    reading[c] = static_cast<int>(std::lround(value));
  }
  return reading;
}

struct Line {
  std::vector<float> samples;
  std::vector<simulate::WordLine::SentFrame> sent;
};

Line make_line(double seconds, const simulate::WordLineErrors& errors, std::uint64_t seed, double noise = 0.0) {
  Line line;
  line.samples.resize(static_cast<std::size_t>(seconds * kRate));
  simulate::WordLine words(140.0, errors, seed, 0, motion);
  words.add(line.samples.data(), static_cast<int>(line.samples.size()), kRate, kAmplitude);
  line.sent = words.take_sent();
  std::mt19937_64 random(seed);
  std::normal_distribution<float> normal(0.0F, static_cast<float>(std::max(noise, 1e-9)));
  for (float& sample : line.samples) {
    sample += noise > 0.0 ? normal(random) : 0.0F;
  }
  return line;
}

std::vector<InertialReading> decode(const Line& line, WordStatus* status = nullptr, std::size_t block = 4096) {
  InertialWordDecoder decoder({}, SampleRate{kRate}, 0);
  for (std::size_t i = 0; i < line.samples.size(); i += block) {
    decoder.push(line.samples.data() + i, std::min(block, line.samples.size() - i), 1);
  }
  if (status != nullptr) {
    *status = decoder.status();
  }
  return decoder.take_readings();
}

// How many valid readings differ from what was sent; `times_s` is the largest error of a reading's time.
int wrong(const Line& line, const std::vector<InertialReading>& readings, double* time_s = nullptr) {
  const WordFormat format;
  int count = 0;
  for (const InertialReading& reading : readings) {
    const simulate::WordLine::SentFrame* nearest = &line.sent.front();
    for (const auto& frame : line.sent) {
      if (std::abs(frame.start_s - reading.time.value) < std::abs(nearest->start_s - reading.time.value)) {
        nearest = &frame;
      }
    }
    if (time_s != nullptr) {
      *time_s = std::max(*time_s, std::abs(nearest->start_s - reading.time.value));
    }
    bool same = true;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto axis = static_cast<Eigen::Index>(c);
      same = same && std::lround(reading.w_WS_S[axis] / format.gyroscope_range_rad_s * 2048.0) == nearest->held[c] &&
             std::lround(reading.f_S[axis] / format.accelerometer_range_m_s2 * 2048.0) == nearest->held[c + 3];
    }
    count += reading.valid && !same ? 1 : 0;
  }
  return count;
}

TEST(InertialWords, PerfectLineIsExactAtAnyClock) {
  for (const double ppm : {-200.0, -70.0, 0.0, 130.0, 200.0}) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const Line line = make_line(1.5, {ppm * 1e-6, 0.0, 0.0}, seed);
      WordStatus status;
      const auto readings = decode(line, &status);
      double time_s = 0.0;
      EXPECT_EQ(wrong(line, readings, &time_s), 0);
      EXPECT_EQ(status.counters.lost, 0);
      EXPECT_EQ(status.counters.bit_errors, 0);
      ASSERT_GT(readings.size(), 195U);
      EXPECT_LT(time_s, 8e-6) << ppm;  // a tenth of a bit
      // Locked, decoded and exact from the sixth frame after the lock.
      EXPECT_LT(readings.front().time.value, 0.050) << ppm << " " << seed;
      EXPECT_TRUE(readings.at(6).valid);
    }
  }
}

// Heard a millisecond at a time, at clocks all over the tolerance and started anywhere in a frame, with one bit in a
// hundred wrong.
TEST(InertialWords, LocksWithinFiftyMilliseconds) {
  double longest = 0.0;
  int late = 0;
  int lines = 0;
  for (int ppm = -200; ppm <= 200; ppm += 25) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed, ++lines) {
      const Line line = make_line(0.2, {ppm * 1e-6, 0.0, seed % 2 == 0 ? 0.01 : 0.0}, 100 * seed + 7);
      InertialWordDecoder decoder({}, SampleRate{kRate}, 0);
      double locked = -1.0;
      for (std::size_t i = 0; i + 140 <= line.samples.size() && locked < 0.0; i += 140) {
        decoder.push(line.samples.data() + i, 140, 1);
        locked = decoder.status().locked ? static_cast<double>(i + 140) / kRate : -1.0;
      }
      ASSERT_GT(locked, 0.0) << ppm << " ppm, seed " << seed;
      // What the counters say is what was heard, to a step of a millisecond and the filter's delay.
      EXPECT_NEAR(decoder.status().counters.lock_s, locked, 2e-3);
      longest = std::max(longest, locked);
      late += locked > 0.050 ? 1 : 0;
    }
  }
  std::printf("lock within %.1f ms on %d lines\n", 1e3 * longest, lines);
  EXPECT_EQ(late, 0);
}

TEST(InertialWords, OnePercentOfWrongBitsLosesFewFrames) {
  std::int64_t frames = 0;
  std::int64_t lost = 0;
  int false_readings = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Line line = make_line(60.0, {150e-6, 1e-6, 0.01}, seed);
    WordStatus status;
    const auto readings = decode(line, &status);
    frames += status.counters.frames;
    lost += status.counters.lost;
    if (seed <= 2) {
      false_readings += wrong(line, readings);
    }
    EXPECT_GT(status.counters.bit_errors, 0);
  }
  EXPECT_GT(frames, 100000);
  std::printf("%lld of %lld frames lost, %.2e\n", static_cast<long long>(lost), static_cast<long long>(frames),
              static_cast<double>(lost) / static_cast<double>(frames));
  // Expected: 4 words · P(4 or more of 24 bits) = 3.6e-4, with a standard deviation of 0.6e-4.
  EXPECT_LE(static_cast<double>(lost), 5e-4 * static_cast<double>(frames));
  EXPECT_GT(static_cast<double>(lost), 1.5e-4 * static_cast<double>(frames));
  EXPECT_LE(false_readings, 1);
}

TEST(InertialWords, ReadsThroughNoise) {
  const Line line = make_line(20.0, {-200e-6, 2e-6, 0.0}, 3, 0.6 * kAmplitude);
  WordStatus status;
  const auto readings = decode(line, &status);
  EXPECT_EQ(wrong(line, readings), 0);
  EXPECT_LT(status.counters.lost, 6);
}

TEST(InertialWords, ExactAgainSixFramesAfterABurst) {
  Line line = make_line(3.0, {90e-6, 0.0, 0.0}, 5);
  for (std::size_t i = 140000; i < 140000 + 3000; ++i) {
    line.samples[i] = 0.5F * std::sin(0.37F * static_cast<float>(i * i % 977));
  }
  const auto readings = decode(line);
  EXPECT_EQ(wrong(line, readings), 0);
  int after = 0;
  bool lost = false;
  for (const InertialReading& reading : readings) {
    if (reading.time.value < 0.9) {
      continue;
    }
    lost = lost || !reading.valid;
    if (reading.time.value > 1.0 + 3000.0 / kRate) {
      after += reading.valid ? 0 : 1;
    }
  }
  EXPECT_TRUE(lost);
  EXPECT_LE(after, 6);
}

TEST(InertialWords, AGapLosesItsFramesAndNothingElse) {
  const Line line = make_line(4.0, {-120e-6, 0.0, 0.0}, 6);
  InertialWordDecoder decoder({}, SampleRate{kRate}, 0);
  decoder.push(line.samples.data(), 200000, 1);
  decoder.gap(SampleCount{70000});
  decoder.push(line.samples.data() + 270000, line.samples.size() - 270000, 1);
  const auto readings = decoder.take_readings();
  EXPECT_EQ(wrong(line, readings), 0);
  EXPECT_EQ(decoder.status().counters.relocks, 0);
  const double lost = static_cast<double>(decoder.status().counters.lost);
  EXPECT_NEAR(lost, 0.5 * 140.0, 3.0);
  EXPECT_TRUE(readings.back().valid);
  // Numbers go on: every frame has its own.
  EXPECT_NEAR(static_cast<double>(readings.back().number),
              140.0 * (readings.back().time.value - readings.front().time.value), 0.6);
}

TEST(InertialWords, AWireThatIsPulledIsFoundAgain) {
  Line line = make_line(4.0, {-120e-6, 0.0, 0.0}, 7);
  std::fill(line.samples.begin() + 140000, line.samples.begin() + 280000, 0.0F);
  WordStatus status;
  const auto readings = decode(line, &status);
  EXPECT_EQ(wrong(line, readings), 0);
  EXPECT_TRUE(status.locked);
  EXPECT_TRUE(readings.back().valid);
  EXPECT_NEAR(static_cast<double>(status.counters.lost), 140.0, 10.0);
}

TEST(InertialWords, BlocksDoNotMatter) {
  const Line line = make_line(2.0, {170e-6, 1e-6, 0.004}, 8, 0.01);
  const auto whole = decode(line, nullptr, line.samples.size());
  for (const std::size_t block : {std::size_t{1}, std::size_t{37}, std::size_t{1120}}) {
    const auto parts = decode(line, nullptr, block);
    ASSERT_EQ(parts.size(), whole.size()) << block;
    for (std::size_t i = 0; i < whole.size(); ++i) {
      ASSERT_EQ(parts[i].time.value, whole[i].time.value);
      ASSERT_EQ(parts[i].w_WS_S, whole[i].w_WS_S);
      ASSERT_EQ(parts[i].f_S, whole[i].f_S);
      ASSERT_EQ(parts[i].valid, whole[i].valid);
    }
  }
}

}  // namespace
}  // namespace limbwave::decode
