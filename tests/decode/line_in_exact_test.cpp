#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "decode/line_in.h"
#include "support/decode_signal.h"
#include "support/line_in_signal.h"

namespace limbwave::decode {
namespace {

using test::Decoded;
using test::LineInSignalSpec;

class EveryRate : public testing::TestWithParam<double> {};

TEST_P(EveryRate, GivesStillVoltagesBack) {
  LineInSignalSpec spec;
  spec.rate = GetParam();
  for (const double coupling : {0.0, 1.0, 5.0, 20.0}) {
    spec.coupling_hz = coupling;
    const auto signal = test::make_line_in_signal(spec);
    const Decoded decoded = test::decode_signal(signal.interleaved, spec.rate);
    EXPECT_TRUE(decoded.findings.empty()) << decoded.texts();
    ASSERT_EQ(decoded.cycles.size() + 1, signal.cycle_starts.size());
    double worst = 0.0;
    double worst_start = 0.0;
    for (std::size_t i = 0; i < decoded.cycles.size(); ++i) {
      const LineInCycle& cycle = decoded.cycles[i];
      ASSERT_TRUE(cycle.valid);
      EXPECT_EQ(cycle.number, static_cast<std::int64_t>(i));
      worst_start = std::max(worst_start, std::fabs(cycle.start_sample - signal.cycle_starts[i]));
      for (int j = 0; j < 16; ++j) {
        const auto slot = static_cast<std::size_t>(j);
        worst = std::max(worst, std::fabs(cycle.volts[slot] - test::true_volts(spec, j, cycle.sample[slot])));
      }
    }
    std::printf("%.0f Hz, coupling %.0f Hz: worst %.2e V, start %.4f samples, estimated %.4f ± %.4f Hz (right %.4f)\n",
                spec.rate, coupling, worst, worst_start, decoded.status.left_coupling_hz, decoded.status.coupling_sd_hz,
                decoded.status.right_coupling_hz);
    EXPECT_LT(worst, 1e-5);
    EXPECT_LT(worst_start, 0.02);
  }
}
INSTANTIATE_TEST_SUITE_P(Rates, EveryRate, testing::Values(44100.0, 48000.0, 96000.0, 192000.0));

}  // namespace
}  // namespace limbwave::decode
