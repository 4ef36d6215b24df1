// What the electronics of signals.md §4 cost: inclination error of still sensors in many directions.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <utility>
#include <vector>

#include "decode/line_in.h"
#include "support/decode_signal.h"
#include "support/line_in_signal.h"

namespace limbwave::decode {
namespace {

using test::Decoded;
using test::LineInSignalSpec;

/// Five sensors at rest, each another way up; every sensor turns slowly through many directions.
Eigen::Vector3d direction(int sensor, double t, double speed) {
  const double a = 0.9 * sensor + speed * (0.7 + 0.13 * sensor) * t;
  const double b = 1.7 * sensor + speed * (0.5 - 0.07 * sensor) * t;
  return {std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)};
}

struct Inclination {
  double mean_deg = 0.0, max_deg = 0.0, beyond_all_but_thousandth_deg = 0.0, volts_rms = 0.0;
};

Inclination inclination_error(const LineInSignalSpec& spec, const std::vector<LineInCycle>& cycles,
                              std::size_t skip = 0) {
  Inclination error;
  std::vector<double> angles;
  double squares = 0.0;
  for (std::size_t i = skip; i < cycles.size(); ++i) {
    const LineInCycle& cycle = cycles[i];
    for (int sensor = 0; sensor < 5; ++sensor) {
      Eigen::Vector3d measured;
      Eigen::Vector3d truth;
      for (int axis = 0; axis < 3; ++axis) {
        const auto slot = static_cast<std::size_t>(3 * sensor + axis);
        // Both relative to zero g, in g.
        truth[axis] = (test::true_volts(spec, 3 * sensor + axis, cycle.sample[slot]) - (1.65 - 0.33)) / 0.33;
        measured[axis] = (cycle.volts[slot] - (1.65 - 0.33)) / 0.33;
      }
      squares += (measured - truth).squaredNorm() * 0.33 * 0.33;
      const double angle = std::atan2(measured.cross(truth).norm(), measured.dot(truth)) * 180.0 / M_PI;
      error.mean_deg += angle;
      error.max_deg = std::max(error.max_deg, angle);
      angles.push_back(angle);
    }
  }
  const auto count = static_cast<double>(angles.size());
  error.mean_deg /= count;
  error.volts_rms = std::sqrt(squares / count / 3.0);
  std::sort(angles.begin(), angles.end());
  error.beyond_all_but_thousandth_deg = angles[angles.size() * 999 / 1000];
  return error;
}

LineInSignalSpec still_spec(double rate, double coupling_hz, double speed) {
  LineInSignalSpec spec = test::paper_electronics(rate, coupling_hz);
  spec.seconds = 6.0;
  spec.full_scale_volts =
      3.3 / (coupling_hz > 10.0 ? 1.15 : 1.4);  // so that nothing clips where the coupling makes the counter peak
  spec.volts = [speed](int axis, double t) { return 1.65 + 0.33 * direction(axis / 3, t, speed)[axis % 3]; };
  return spec;
}

class Electronics : public testing::TestWithParam<std::tuple<double, double>> {};

TEST_P(Electronics, KeepTheInclination) {
  const auto [rate, coupling] = GetParam();
  for (const double speed : {0.0, 1.0}) {
    const LineInSignalSpec spec = still_spec(rate, coupling, speed);
    const auto signal = test::make_line_in_signal(spec);
    const Decoded decoded = test::decode_signal(signal.interleaved, rate);
    EXPECT_TRUE(decoded.findings.empty()) << decoded.texts();
    ASSERT_EQ(decoded.cycles.size() + 1, signal.cycle_starts.size());
    const Inclination error = inclination_error(spec, decoded.cycles);
    LineInParameters off;
    off.coupling_hz = 0.0;
    const Inclination without = inclination_error(spec, test::decode_signal(signal.interleaved, rate, off).cycles);
    LineInParameters known;
    known.coupling_hz = coupling;
    const Inclination given = inclination_error(spec, test::decode_signal(signal.interleaved, rate, known).cycles);
    fmt::print(
        "{:6.0f} Hz, coupling {:2.0f} Hz, speed {}: {:.3f}° mean {:.3f}° max ({:.2f} mV); not corrected {:.2f}° mean "
        "{:.2f}° max; "
        "corner known {:.3f}° {:.3f}°; corner {:.3f} ± {:.3f} Hz (right {:.3f}), noise {:.2e}\n",
        rate, coupling, speed, error.mean_deg, error.max_deg, 1e3 * error.volts_rms, without.mean_deg, without.max_deg,
        given.mean_deg, given.max_deg, decoded.status.left_coupling_hz, decoded.status.coupling_sd_hz,
        decoded.status.right_coupling_hz, decoded.status.noise);
    EXPECT_LT(error.mean_deg, 0.15);
    // At 20 Hz the counter's peaks leave room for less level, and the noise that is integrated with the signal adds to
    // that of the slots: 0.13° is then what −60 dB of noise makes of 38 samples, and one value in thousands is beyond
    // five times that.
    EXPECT_LT(coupling > 10.0 ? error.beyond_all_but_thousandth_deg : error.max_deg, 0.5);
  }
}
INSTANTIATE_TEST_SUITE_P(RatesAndCorners, Electronics,
                         testing::Combine(testing::Values(44100.0, 48000.0, 96000.0, 192000.0),
                                          testing::Values(1.0, 5.0, 20.0)));

/// Lines that no table asks for but that somebody will have: no reading is off by more than 6 mg, and nothing is said
/// that is not true.
TEST(OddLines, AreDecodedAllTheSame) {
  const auto worst_mg = [](const LineInSignalSpec& spec, const Decoded& decoded) {
    double worst = 0.0;
    for (const LineInCycle& cycle : decoded.cycles) {
      for (int j = 0; j < 15; ++j) {
        const auto slot = static_cast<std::size_t>(j);
        worst = std::max(worst, std::fabs(cycle.volts[slot] - test::true_volts(spec, j, cycle.sample[slot])));
      }
    }
    return 1e3 * worst / 0.33;
  };
  const auto plain = [] {
    LineInSignalSpec spec = test::paper_electronics(48000.0, 5.0);
    spec.noise = 2e-4;
    spec.seconds = 3.0;
    spec.volts = [](int axis, double t) { return 1.65 + 0.3 * std::sin((1.0 + 0.4 * axis) * t + 1.7 * axis); };
    return spec;
  };
  std::vector<std::pair<const char*, LineInSignalSpec>> lines;
  const auto add = [&](const char* name, const std::function<void(LineInSignalSpec&)>& change) {
    lines.emplace_back(name, plain());
    change(lines.back().second);
  };
  add("64 kHz", [](auto& spec) { spec.rate = 64000.0; });
  add("88.2 kHz", [](auto& spec) { spec.rate = 88200.0; });
  add("176.4 kHz", [](auto& spec) { spec.rate = 176400.0; });
  add("clock -3 % that wanders by 2 %", [](auto& spec) {
    spec.clock_offset = -0.03;
    spec.clock_wander = 0.02;
  });
  add("both channels inverted", [](auto& spec) { spec.left_inverted = spec.right_inverted = true; });
  add("volume 5 %", [](auto& spec) {
    spec.full_scale_volts /= 0.05;
    spec.noise = 3e-5;
  });
  add("coupling 0.5 Hz", [](auto& spec) { spec.coupling_hz = spec.right_coupling_hz = 0.5; });
  add("coupling 30 Hz, capacitors unlike", [](auto& spec) {
    spec.coupling_hz = 30.0;
    spec.right_coupling_hz = 21.0;
    spec.full_scale_volts = 3.3;
  });
  add("offset of the card", [](auto& spec) { spec.dc_offset = -0.2; });
  add("no coupling, offset", [](auto& spec) {
    spec.coupling_hz = spec.right_coupling_hz = 0.0;
    spec.dc_offset = 0.1;
  });
  for (const auto& [name, spec] : lines) {
    const Decoded decoded = test::decode_signal(test::make_line_in_signal(spec).interleaved, spec.rate);
    EXPECT_GT(decoded.cycles.size(), 160U) << name;
    EXPECT_EQ(decoded.findings.size(), spec.left_inverted ? 2U : 0U) << name << "\n" << decoded.texts();
    EXPECT_LT(worst_mg(spec, decoded), 6.0) << name;
  }
}

}  // namespace
}  // namespace limbwave::decode
