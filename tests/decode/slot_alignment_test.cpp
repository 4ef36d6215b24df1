#include "decode/slot_alignment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace limbwave::decode {
namespace {

constexpr double kRate = 48000.0;
constexpr double kPeriod = 800.0;
using Signal = std::function<double(double)>;  // volts of a time in seconds; axes are phases of it

double value(const Signal& signal, int slot, double sample) {
  return signal(sample / kRate) + 0.01 * slot;
}

std::vector<LineInCycle> cycles_of(const Signal& signal, std::size_t count) {
  std::vector<LineInCycle> cycles;
  double start = 123.4;
  for (std::size_t i = 0; i < count; ++i) {
    LineInCycle cycle;
    cycle.number = static_cast<std::int64_t>(i);
    cycle.start_sample = start;
    cycle.period_samples = kPeriod * (1.0 + 0.003 * std::sin(0.05 * static_cast<double>(i)));
    cycle.valid = true;
    for (int slot = 0; slot < 16; ++slot) {
      // Windows start on whole samples.
      const auto index = static_cast<std::size_t>(slot);
      cycle.sample[index] = std::ceil(start + (slot + 0.5) / 16.0 * cycle.period_samples);
      cycle.volts[index] = value(signal, slot, cycle.sample[index]);
    }
    start += cycle.period_samples;
    cycles.push_back(cycle);
  }
  return cycles;
}

std::vector<AccelerationFrame> align(const std::vector<LineInCycle>& cycles) {
  SlotAligner aligner(5, SampleRate{kRate});
  for (const LineInCycle& cycle : cycles) {
    aligner.push(cycle);
  }
  aligner.finish();
  return aligner.take_frames();
}

double worst(const std::vector<AccelerationFrame>& frames, const Signal& signal, std::size_t from, std::size_t to) {
  double error = 0.0;
  for (std::size_t i = from; i < to; ++i) {
    for (int slot = 0; slot < 15; ++slot) {
      error = std::max(error, std::fabs(frames[i].volts[static_cast<std::size_t>(slot / 3)][slot % 3] -
                                        value(signal, slot, frames[i].time_s * kRate)));
    }
  }
  return error;
}

Signal sine(double hz) {
  return [hz](double t) { return std::sin(2.0 * std::numbers::pi * hz * t); };
}

TEST(SlotAlignment, BringsAllAxesToTheMiddleOfTheCycle) {
  const auto cycles = cycles_of(sine(2.0), 60);
  const auto frames = align(cycles);
  // The first and the last cycle have nothing on their other side.
  ASSERT_EQ(frames.size() + 2, cycles.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const LineInCycle& cycle = cycles[i + 1];
    EXPECT_DOUBLE_EQ(frames[i].time_s * kRate, cycle.start_sample + 0.5 * cycle.period_samples);
    EXPECT_EQ(frames[i].usable, 0x1fU);
    EXPECT_FALSE(frames[i].gap_before);
  }
}

TEST(SlotAlignment, IsExactEnoughForHumanMotion) {
  // Of an amplitude of 1: what still holds, and what slow and quick movements lose.
  EXPECT_LT(worst(
                align(cycles_of([](double) { return 1.3; }, 60)), [](double) { return 1.3; }, 0, 58),
            1e-12);
  for (const auto& [hz, bound] : {std::pair{0.5, 3e-5}, {2.0, 3e-5}, {5.0, 1e-4}, {8.0, 0.01}, {10.0, 0.03}}) {
    const auto frames = align(cycles_of(sine(hz), 200));
    EXPECT_LT(worst(frames, sine(hz), 7, 197), bound) << hz;
    // The first and the last ones have fewer neighbours.
    EXPECT_LT(worst(frames, sine(hz), 0, 198), hz < 3.0 ? 1e-4 : 0.1) << hz;
  }
}

TEST(SlotAlignment, LooksTwoCyclesAhead) {
  const auto cycles = cycles_of(sine(1.0), 20);
  SlotAligner aligner(5, SampleRate{kRate});
  std::size_t frames = 0;
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    aligner.push(cycles[i]);
    frames += aligner.take_frames().size();
    EXPECT_EQ(frames, i < 3 ? 0 : i - 2);
  }
}

TEST(SlotAlignment, TakesNothingAcrossGaps) {
  auto cycles = cycles_of(sine(2.0), 60);
  auto after = cycles_of([](double t) { return 5.0 + std::sin(12.0 * t); }, 60);
  cycles.resize(30);
  cycles.insert(cycles.end(), after.begin() + 40, after.end());
  cycles[30].gap_before = true;
  const auto frames = align(cycles);
  ASSERT_EQ(frames.size(), 46U);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i].gap_before, i == 28) << i;
  }
  EXPECT_LT(worst(frames, sine(2.0), 0, 28), 3e-3);
  EXPECT_LT(worst(
                frames, [](double t) { return 5.0 + std::sin(12.0 * t); }, 28, 46),
            3e-3);
}

TEST(SlotAlignment, LeavesBadValuesOutAndSaysSo) {
  auto cycles = cycles_of(sine(2.0), 60);
  cycles[20].valid = false;
  cycles[20].volts.fill(100.0);
  cycles[40].clipped = 1U << 4U;  // sensor 1, axis y
  cycles[40].volts[4] = 100.0;
  const auto frames = align(cycles);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    // Beside a bad cycle an axis that is read on its side of the middle has no reading on the other one.
    const std::size_t cycle = i + 1;
    const unsigned missing = cycle == 20 || cycle == 21 ? 0x1fU : cycle == 19 ? 0x07U : 0U;
    EXPECT_EQ(frames[i].usable, 0x1fU & ~missing & ~(cycle >= 39 && cycle <= 41 ? 0x02U : 0U)) << cycle;
  }
  EXPECT_LT(worst(frames, sine(2.0), 0, 58), 3e-3);
}

TEST(SlotAlignment, UsableNextToClippedIsRightInFastMotion) {
  // Each axis swings by 1 at 6 Hz, out of step with the others, and is lost wherever it is above 0.8.
  const auto at = [](int slot, double sample) {
    return std::sin(2.0 * std::numbers::pi * 6.0 * sample / kRate + 0.7 * slot);
  };
  auto cycles = cycles_of(sine(6.0), 600);
  for (LineInCycle& cycle : cycles) {
    for (int slot = 0; slot < 15; ++slot) {
      const auto index = static_cast<std::size_t>(slot);
      const double volts = at(slot, cycle.sample[index]);
      cycle.clipped |= volts > 0.8 ? 1U << index : 0U;
      cycle.volts[index] = std::min(volts, 0.8);
    }
  }
  int usable = 0;
  double error = 0.0;
  for (const AccelerationFrame& frame : align(cycles)) {
    for (int sensor = 0; sensor < 5; ++sensor) {
      if ((frame.usable >> static_cast<unsigned>(sensor) & 1U) == 0) {
        continue;
      }
      ++usable;
      for (int axis = 0; axis < 3; ++axis) {
        error = std::max(error, std::fabs(frame.volts[static_cast<std::size_t>(sensor)][axis] -
                                          at(3 * sensor + axis, frame.time_s * kRate)));
      }
    }
  }
  EXPECT_GT(usable, 300);
  EXPECT_LT(error, 0.02);  // with extrapolated ones 0.033
}

TEST(SlotAlignment, UncertainValuesAreLeftOut) {
  auto cycles = cycles_of(sine(2.0), 60);
  cycles[30].uncertain = 1U << 7U;  // sensor 2, axis y
  cycles[30].volts[7] = 100.0;
  const auto frames = align(cycles);
  EXPECT_EQ(frames[29].usable, 0x1bU);
  EXPECT_LT(worst(frames, sine(2.0), 0, 58), 3e-3);
}

TEST(SlotAlignment, SurvivesOnlyBadCycles) {
  auto cycles = cycles_of(sine(2.0), 5);
  for (LineInCycle& cycle : cycles) {
    cycle.valid = false;
  }
  for (const AccelerationFrame& frame : align(cycles)) {
    EXPECT_EQ(frame.usable, 0U);
    EXPECT_TRUE(frame.volts[0].allFinite());
  }
}

}  // namespace
}  // namespace limbwave::decode
