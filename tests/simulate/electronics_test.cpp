#include "simulate/electronics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "base/units.h"
#include "simulate/line_support.h"

namespace limbwave::simulate {
namespace {

constexpr double kRate = 48000.0;
constexpr double kSlot = 1.0 / 960.0;

double staircase(int slot, double /*time_s*/) {
  return 0.8 + 0.1 * slot;
}

// What an exact mean over a sampling period must be, from nothing but the cycles' starts and the nominal slot length.
double expected_mean(const std::vector<double>& starts, double from, double to, bool right) {
  const body::LineInSignal board;
  double sum = 0.0;
  for (const double start : starts) {
    for (int slot = 0; slot < 16; ++slot) {
      const double begin = start + slot * kSlot;
      const double overlap = std::min(begin + kSlot, to) - std::max(begin, from);
      if (overlap > 0.0) {
        const double left_volts = slot == 15 ? board.reference_volts : staircase(slot, 0.0);
        sum += overlap * (right ? (slot < 8 ? 0.0 : board.supply_volts) : left_volts);
      }
    }
  }
  return sum / (to - from);
}

TEST(LineInStream, SamplesAreExactMeansOfTheSlotsAtErrorsNone) {
  GivenVoltages voltages(staircase);
  const Stereo signal = record({}, voltages, 4800);
  ASSERT_GE(signal.cycle_starts.size(), 6U);
  for (std::size_t i = 0; i < signal.left.size(); ++i) {
    const double from = (static_cast<double>(i) - 0.5) / kRate;
    const double to = (static_cast<double>(i) + 0.5) / kRate;
    // A cycle that began before time 0 counts too.
    const double scale = 0.7 / 1.65;
    ASSERT_NEAR(signal.left[i], (expected_mean(signal.cycle_starts, from, to, false) - 1.65) * scale, 1e-6) << i;
    ASSERT_NEAR(signal.right[i], (expected_mean(signal.cycle_starts, from, to, true) - 1.65) * scale, 1e-6) << i;
  }
}

TEST(LineInStream, VoltageMovesWithinItsSlot) {
  // A parabola in time is followed exactly, so every sample is its mean over the sample's period.
  const auto moving = [](int /*slot*/, double t) { return 1.0 + 3.0 * t + 20.0 * t * t; };
  GivenVoltages voltages(moving);
  const Stereo signal = record({}, voltages, 4800);
  int checked = 0;
  for (std::size_t i = 0; i < signal.left.size(); ++i) {
    const double t = static_cast<double>(i) / kRate;
    const double from_start = std::fmod(t - signal.cycle_starts.front() + 10.0 / 60.0, 1.0 / 60.0);
    if (from_start < 15 * kSlot - 1.0 / kRate && from_start > 1.0 / kRate) {
      const double mean = moving(0, t) + 20.0 / (12.0 * kRate * kRate);
      ASSERT_NEAR(signal.left[i], (mean - 1.65) * 0.7 / 1.65, 1e-6) << i;
      ++checked;
    }
  }
  EXPECT_GT(checked, 4000);
}

TEST(LineInStream, CounterRunsAtTheClocksFrequency) {
  GivenVoltages voltages(staircase);
  for (const double offset : {0.0, 0.03, -0.05}) {
    LineInErrors errors;
    errors.clock_offset = offset;
    const Stereo signal = record(errors, voltages, 480000);
    std::vector<double> edges;
    for (std::size_t i = 1; i < signal.right.size(); ++i) {
      if (signal.right[i - 1] < 0.0 && signal.right[i] >= 0.0) {
        edges.push_back(static_cast<double>(i));
      }
    }
    const double cycles = static_cast<double>(edges.size()) - 1.0;
    EXPECT_NEAR(cycles / (edges.back() - edges.front()) * kRate, 60.0 * (1.0 + offset), 0.02);
  }
}

TEST(LineInStream, WanderAndJitterHaveTheirSizes) {
  GivenVoltages voltages(staircase);
  const auto periods = [&](const LineInErrors& errors) {
    const Stereo signal = record(errors, voltages, 48000 * 120);
    std::vector<double> lengths;
    for (std::size_t i = 1; i < signal.cycle_starts.size(); ++i) {
      lengths.push_back((signal.cycle_starts[i] - signal.cycle_starts[i - 1]) * 60.0 - 1.0);
    }
    return lengths;
  };
  const auto rms = [](const std::vector<double>& x) {
    double sum = 0.0;
    for (const double v : x) {
      sum += v * v;
    }
    return std::sqrt(sum / static_cast<double>(x.size()));
  };
  LineInErrors wander;
  wander.clock_wander = 0.003;
  const std::vector<double> slow = periods(wander);
  EXPECT_GT(rms(slow), 0.0015);
  EXPECT_LT(rms(slow), 0.006);
  std::vector<double> change;
  for (std::size_t i = 1; i < slow.size(); ++i) {
    change.push_back(slow[i] - slow[i - 1]);
  }
  // Ornstein–Uhlenbeck with 5 s: from cycle to cycle about σ √(2 / (60 · 5)), less by averaging over the cycle.
  EXPECT_NEAR(rms(change), 0.003 * std::sqrt(2.0 / 300.0) * std::sqrt(2.0 / 3.0),
              0.15 * 0.003 * std::sqrt(2.0 / 300.0));
  LineInErrors jitter;
  jitter.clock_jitter = 0.01;
  EXPECT_NEAR(rms(periods(jitter)), 0.01 / 4.0, 0.0003);  // sixteen independent slots
}

TEST(LineInStream, CouplingDecaysWithItsTimeConstant) {
  GivenVoltages voltages([](int, double) { return 1.0; });
  for (const double corner : {1.0, 5.0, 20.0}) {
    LineInErrors errors;
    errors.coupling_hz = corner;
    const Stereo signal = record(errors, voltages, 48000);
    int checked = 0;
    double mean = 0.0;
    for (std::size_t i = 1; i < signal.right.size(); ++i) {
      const double t = static_cast<double>(i) / kRate;
      const double in_cycle = std::fmod(t - signal.cycle_starts.front() + 1.0, 1.0 / 60.0);
      if (in_cycle > 8 * kSlot + 2 / kRate && in_cycle < 16 * kSlot - 2 / kRate) {
        ASSERT_NEAR(signal.right[i] / signal.right[i - 1], std::exp(-2 * kPi * corner / kRate), 2e-6);
        ++checked;
      }
      mean += signal.right[i] / static_cast<double>(signal.right.size());
    }
    EXPECT_GT(checked, 20000);
    EXPECT_NEAR(mean, 0.0, 1e-3);  // no DC passes
    const auto peak = std::max_element(signal.right.begin(), signal.right.end());
    EXPECT_NEAR(*peak, 0.7, 0.01) << "the nominal level holds for every coupling";
  }
}

TEST(LineInStream, RingingAndSettlingFollowTheirFormulas) {
  GivenVoltages voltages([](int slot, double) { return slot % 2 == 0 ? 1.0 : 2.0; });
  LineInErrors errors;
  errors.ringing = 0.2;
  errors.ringing_hz = 3000.0;
  errors.ringing_decay_s = 100e-6;
  errors.settle_s = 30e-6;
  const double rate = 192000.0;
  const Stereo signal = record(errors, voltages, 19200, {SampleRate{rate}, 2, acquire::SampleType::kFloat32});
  // The overshoot counts into the level that the gain is set for.
  const auto loudest = std::max_element(signal.right.begin(), signal.right.end());
  EXPECT_NEAR(*loudest, 0.7, 0.005);
  const double start =
      *std::find_if(signal.cycle_starts.begin(), signal.cycle_starts.end(), [](double t) { return t > 0.01; });
  const double high = signal.right.at(static_cast<std::size_t>((start + 15.9 * kSlot) * rate));
  const double scale = high / 1.65;
  // Slot 1 after slot 0: a step of one volt upwards.
  const auto first = static_cast<std::size_t>(std::ceil((start + kSlot) * rate)) + 1;
  const auto end = static_cast<std::size_t>(std::floor((start + 2 * kSlot) * rate)) - 1;
  ASSERT_GT(end, first + 150);
  for (std::size_t i = first; i < end; ++i) {
    const double t = static_cast<double>(i) / rate - start - kSlot;
    const auto exact = [](double x) {
      return 2.0 - std::exp(-x / 30e-6) + 0.2 * std::exp(-x / 100e-6) * std::sin(2 * kPi * 3000.0 * x);
    };
    const double h = 0.5 / rate;
    const double mean = (exact(t - h) + 4.0 * exact(t) + exact(t + h)) / 6.0;  // Simpson over the sample's period
    ASSERT_NEAR(signal.left[i], (mean - 1.65) * scale, 3e-4) << t;             // older slots' rests are below this
  }
}

TEST(LineInStream, AntiAliasKeepsMeansAndRingsOnBothSidesOfAnEdge) {
  GivenVoltages voltages(staircase);
  LineInErrors errors;
  const Stereo plain = record(errors, voltages, 9600);
  errors.anti_alias = true;
  const Stereo filtered = record(errors, voltages, 9600);
  ASSERT_EQ(plain.cycle_starts.size(), filtered.cycle_starts.size());
  const double high = *std::max_element(plain.right.begin(), plain.right.end());
  const double overshoot = *std::max_element(filtered.right.begin(), filtered.right.end()) / high;
  EXPECT_GT(overshoot, 1.05);  // Gibbs: 9 % of the step each side, 18 % of the amplitude
  EXPECT_LT(overshoot, 1.25);
  for (std::size_t i = 100; i + 100 < plain.right.size(); ++i) {
    const auto flat = std::minmax_element(plain.right.begin() + static_cast<std::ptrdiff_t>(i) - 60,
                                          plain.right.begin() + static_cast<std::ptrdiff_t>(i) + 60);
    if (*flat.second - *flat.first < 1e-9) {
      ASSERT_NEAR(filtered.right[i], plain.right[i], 2e-3);  // no delay, no change away from edges
    }
  }
  double rise_plain = 0.0;
  double rise_filtered = 0.0;
  for (std::size_t i = 1000; i < 1000 + 800 * 10; ++i) {
    rise_plain += plain.right[i];
    rise_filtered += filtered.right[i];
  }
  EXPECT_NEAR(rise_plain, rise_filtered, 0.5);  // edges are where they were
}

TEST(LineInStream, WiringFaults) {
  GivenVoltages voltages(staircase);
  const Stereo plain = record({}, voltages, 2000);
  LineInErrors errors;
  errors.left_inverted = true;
  const Stereo left = record(errors, voltages, 2000);
  errors = {};
  errors.right_inverted = true;
  const Stereo right = record(errors, voltages, 2000);
  errors = {};
  errors.swapped = true;
  const Stereo swapped = record(errors, voltages, 2000);
  for (std::size_t i = 0; i < 2000; ++i) {
    ASSERT_EQ(left.left[i], -plain.left[i]);
    ASSERT_EQ(left.right[i], plain.right[i]);
    ASSERT_EQ(right.right[i], -plain.right[i]);
    ASSERT_EQ(right.left[i], plain.left[i]);
    ASSERT_EQ(swapped.left[i], plain.right[i]);
    ASSERT_EQ(swapped.right[i], plain.left[i]);
  }
}

TEST(LineInStream, GainClipsAtFullScaleInEveryFormat) {
  GivenVoltages voltages(staircase);
  LineInErrors errors;
  errors.gain = 3.0;
  for (const auto type : {acquire::SampleType::kInt16, acquire::SampleType::kInt24, acquire::SampleType::kInt32,
                          acquire::SampleType::kFloat32}) {
    const Stereo signal = record(errors, voltages, 2000, {SampleRate{kRate}, 2, type});
    EXPECT_EQ(*std::min_element(signal.right.begin(), signal.right.end()), -1.0);
    EXPECT_NEAR(*std::max_element(signal.right.begin(), signal.right.end()), 1.0, 1e-4);
  }
}

TEST(LineInStream, FormatsAgreeToHalfAStep) {
  GivenVoltages voltages(staircase);
  const Stereo exact = record({}, voltages, 3000);
  const auto worst = [&](acquire::SampleType type, bool dither) {
    LineInErrors errors;
    errors.dither = dither;
    const Stereo signal = record(errors, voltages, 3000, {SampleRate{kRate}, 2, type});
    double largest = 0.0;
    for (std::size_t i = 0; i < 3000; ++i) {
      largest =
          std::max({largest, std::abs(signal.left[i] - exact.left[i]), std::abs(signal.right[i] - exact.right[i])});
    }
    return largest;
  };
  EXPECT_LE(worst(acquire::SampleType::kInt16, false), 0.5001 / 32768);
  EXPECT_GT(worst(acquire::SampleType::kInt16, false), 0.05 / 32768);
  EXPECT_LE(worst(acquire::SampleType::kInt24, false), 1.0 / 8388608);
  EXPECT_LE(worst(acquire::SampleType::kInt32, false), 1e-7);
  EXPECT_GT(worst(acquire::SampleType::kInt16, true), 0.9 / 32768);
  EXPECT_LE(worst(acquire::SampleType::kInt16, true), 1.5001 / 32768);
}

TEST(LineInStream, NoiseAndHumHaveTheirSizes) {
  GivenVoltages voltages(staircase);
  const std::size_t frames = 96000;
  const Stereo plain = record({}, voltages, frames);
  LineInErrors errors;
  errors.noise_db = -60.0;
  const Stereo noisy = record(errors, voltages, frames);
  double power = 0.0;
  double cross = 0.0;
  for (std::size_t i = 0; i < frames; ++i) {
    power += std::pow(noisy.left[i] - plain.left[i], 2) / frames;
    cross += (noisy.left[i] - plain.left[i]) * (noisy.right[i] - plain.right[i]) / frames;
  }
  EXPECT_NEAR(std::sqrt(power), 1e-3, 2e-5);
  EXPECT_NEAR(cross, 0.0, 2e-8);
  errors = {};
  errors.hum = 0.02;
  const Stereo humming = record(errors, voltages, frames);
  std::complex<double> at_50 = 0.0;
  for (std::size_t i = 0; i < frames; ++i) {
    at_50 += (humming.left[i] - plain.left[i]) * std::polar(1.0, -2 * kPi * 50.0 * static_cast<double>(i) / kRate);
  }
  EXPECT_NEAR(2.0 * std::abs(at_50) / frames, 0.02, 1e-5);
}

TEST(LineInStream, KnobSilenceAndLostFrames) {
  GivenVoltages voltages(staircase);
  const std::size_t frames = 48000;
  const Stereo plain = record({}, voltages, frames);
  LineInErrors errors;
  errors.knob_time_s = 0.5;
  errors.knob_factor = 0.6;
  const Stereo knob = record(errors, voltages, frames);
  EXPECT_EQ(knob.left[23999], plain.left[23999]);
  EXPECT_NEAR(knob.right[40000], 0.6 * plain.right[40000], 1e-6);
  errors = {};
  errors.silence_time_s = 0.25;
  errors.silence_duration_s = 0.5;
  const Stereo silent = record(errors, voltages, frames);
  EXPECT_EQ(silent.right[11999], plain.right[11999]);
  EXPECT_EQ(silent.right[12001], 0.0);
  EXPECT_EQ(silent.right[35990], 0.0);
  EXPECT_EQ(silent.right[36001], plain.right[36001]);
  errors = {};
  errors.drop_every_s = 0.2;
  errors.drop_frames = 123;
  const Stereo lossy = record(errors, voltages, frames);
  for (std::size_t i = 0; i + 123 * 4 < frames; i += 7) {
    ASSERT_EQ(lossy.left[i], plain.left[i + i / 9600 * 123]) << i;
  }
  const LineInStream stream(body::LineInSignal{}, errors, {SampleRate{kRate}, 2, acquire::SampleType::kInt16}, 1,
                            voltages);
  EXPECT_NEAR(stream.real_time(9599.0), 9599.0 / kRate, 1e-12);
  EXPECT_NEAR(stream.real_time(9600.0), 9723.0 / kRate, 1e-12);
  EXPECT_NEAR(stream.frame_at(9723.0 / kRate), 9600.0, 1e-6);
  EXPECT_LT(stream.frame_at(9650.0 / kRate), 0.0);
}

TEST(LineInStream, IsTheSameForEverySizeOfBlockAndDiffersBySeed) {
  GivenVoltages voltages([](int slot, double t) { return 1.0 + 0.05 * slot + 0.2 * std::sin(9.0 * t); });
  LineInErrors errors;
  errors.clock_offset = 0.03;
  errors.clock_wander = 0.003;
  errors.clock_jitter = 0.001;
  errors.coupling_hz = 5.0;
  errors.ringing = 0.1;
  errors.ringing_hz = 9000.0;
  errors.ringing_decay_s = 80e-6;
  errors.anti_alias = true;
  errors.noise_db = -60.0;
  errors.dither = true;
  errors.drop_every_s = 0.05;
  errors.drop_frames = 10;
  const acquire::StreamFormat format{SampleRate{44100.0}, 2, acquire::SampleType::kInt16};
  const Stereo whole = record(errors, voltages, 9000, format, 5, 9000);
  for (const std::size_t block : {std::size_t{1}, std::size_t{17}, std::size_t{480}, std::size_t{4096}}) {
    const Stereo parts = record(errors, voltages, 9000, format, 5, block);
    EXPECT_EQ(parts.bytes, whole.bytes) << block;
    EXPECT_EQ(parts.cycle_starts, whole.cycle_starts) << block;
  }
  EXPECT_NE(record(errors, voltages, 9000, format, 6).bytes, whole.bytes);
}

}  // namespace
}  // namespace limbwave::simulate
