// Live equals offline: results are the same, bit for bit, however the samples are cut into blocks.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "decode/line_in.h"
#include "support/decode_signal.h"
#include "support/line_in_signal.h"

namespace limbwave::decode {
namespace {

void expect_same(const test::Decoded& a, const test::Decoded& b) {
  ASSERT_EQ(a.cycles.size(), b.cycles.size());
  for (std::size_t i = 0; i < a.cycles.size(); ++i) {
    const LineInCycle& x = a.cycles[i];
    const LineInCycle& y = b.cycles[i];
    ASSERT_EQ(x.number, y.number) << i;
    ASSERT_EQ(x.start_sample, y.start_sample) << i;
    ASSERT_EQ(x.period_samples, y.period_samples) << i;
    ASSERT_EQ(x.sample, y.sample) << i;
    ASSERT_EQ(x.volts, y.volts) << i;
    ASSERT_EQ(x.clipped, y.clipped) << i;
    ASSERT_EQ(x.valid, y.valid) << i;
    ASSERT_EQ(x.gap_before, y.gap_before) << i;
  }
  EXPECT_EQ(a.texts(), b.texts());
  EXPECT_EQ(a.status.left_coupling_hz, b.status.left_coupling_hz);
  EXPECT_EQ(a.status.noise, b.status.noise);
  EXPECT_EQ(a.status.left_peak, b.status.left_peak);
  EXPECT_EQ(a.status.lost_cycles, b.status.lost_cycles);
}

void expect_same_in_all_blocks(const std::vector<float>& samples, double rate) {
  const test::Decoded whole = test::decode_signal(samples, rate);
  for (const std::size_t block : {1UL, 17UL, 480UL, 4096UL, 5000UL}) {
    SCOPED_TRACE(block);
    expect_same(whole, test::decode_signal(samples, rate, {}, block));
  }
}

TEST(LineInBlocks, CleanSignal) {
  test::LineInSignalSpec spec = test::paper_electronics(48000.0, 5.0);
  spec.anti_alias = false;
  spec.volts = [](int axis, double t) { return 1.65 + 0.3 * std::sin(7.0 * t + axis); };
  expect_same_in_all_blocks(test::make_line_in_signal(spec).interleaved, spec.rate);
}

TEST(LineInBlocks, SignalWithEveryFault) {
  test::LineInSignalSpec spec;
  spec.rate = 44100.0;
  spec.seconds = 11.0;
  spec.coupling_hz = 10.0;
  spec.noise = 1e-3;
  spec.bits = 16;
  spec.left_inverted = true;
  spec.volts = [](int axis, double t) {
    return 1.65 + 0.3 * std::sin(7.0 * t + axis) + (t > 2.0 && t < 2.1 ? 3.0 : 0.0);
  };
  spec.gain = [](double t) { return t < 0.7 ? 0.0 : t < 3.0 ? 1.0 : t > 5.0 && t < 7.2 ? 0.0 : 0.8; };
  auto samples = test::make_line_in_signal(spec).interleaved;
  samples[2 * 160000 + 1] = std::numeric_limits<float>::quiet_NaN();
  samples[2 * 160500] = std::numeric_limits<float>::infinity();
  samples.erase(samples.begin() + 2 * 180000, samples.begin() + 2 * 180777);
  const test::Decoded decoded = test::decode_signal(samples, spec.rate);
  for (const char* code : {"line-in.sync-lost", "line-in.clipped", "line-in.level-changed", "line-in.not-finite",
                           "line-in.left-inverted", "line-in.silent"}) {
    EXPECT_TRUE(decoded.has(code)) << code << "\n" << decoded.texts();
  }
  EXPECT_GT(decoded.cycles.size(), 350U);
  expect_same_in_all_blocks(samples, spec.rate);
}

}  // namespace
}  // namespace limbwave::decode
