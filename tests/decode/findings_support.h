/// What the tests of findings share: a line with moving sensors, and what is expected of a decoded one.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "decode/line_in.h"
#include "support/decode_signal.h"
#include "support/line_in_signal.h"

namespace limbwave::decode {

using test::Decoded;
using test::LineInSignalSpec;

inline constexpr double kRate = 48000.0;

inline LineInSignalSpec moving() {
  LineInSignalSpec spec;
  spec.rate = kRate;
  spec.coupling_hz = 5.0;
  spec.noise = 3e-4;
  spec.seconds = 4.0;
  spec.volts = [](int axis, double t) { return 1.65 + 0.02 * axis + 0.3 * std::sin(4.0 * t + axis); };
  return spec;
}

inline Decoded decode(const LineInSignalSpec& spec, const LineInParameters& parameters = {}) {
  return test::decode_signal(test::make_line_in_signal(spec).interleaved, spec.rate, parameters);
}

/// Largest error of valid cycles that lie in [from, to) seconds.
inline double worst_error(const LineInSignalSpec& spec, const Decoded& decoded, double from = 0.0, double to = 1e9) {
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

inline std::vector<float> stereo(double seconds, const std::function<std::pair<double, double>(double)>& value) {
  std::vector<float> samples;
  for (std::size_t n = 0; n < static_cast<std::size_t>(seconds * kRate); ++n) {
    const auto [left, right] = value(static_cast<double>(n) / kRate);
    samples.push_back(static_cast<float>(left));
    samples.push_back(static_cast<float>(right));
  }
  return samples;
}

inline void expect_only(const Decoded& decoded, const std::string& code) {
  EXPECT_TRUE(decoded.has(code)) << decoded.texts();
  for (const Diagnostic& finding : decoded.findings) {
    EXPECT_EQ(finding.code, code) << finding.text();
    EXPECT_FALSE(finding.message.empty());
    EXPECT_FALSE(finding.remedy.empty());
  }
}

inline constexpr double kNoiseBound = 2.5e-3;  // volts: more than noise ever makes of a value here

}  // namespace limbwave::decode
