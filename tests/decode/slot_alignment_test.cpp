#include "decode/slot_alignment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "decode/alignment_kernel.h"

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
  ASSERT_EQ(frames.size(), cycles.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_DOUBLE_EQ(frames[i].time_s * kRate, cycles[i].start_sample + 0.5 * cycles[i].period_samples);
    EXPECT_EQ(frames[i].usable, 0x1fU);
    EXPECT_FALSE(frames[i].gap_before);
  }
}

TEST(SlotAlignment, IsExactEnoughForHumanMotion) {
  // Of an amplitude of 1: what still holds, and what slow and quick movements lose.
  EXPECT_LT(worst(
                align(cycles_of([](double) { return 1.3; }, 60)), [](double) { return 1.3; }, 0, 60),
            1e-12);
  for (const auto& [hz, bound] : {std::pair{0.5, 3e-5}, {2.0, 3e-5}, {5.0, 1e-4}, {8.0, 0.01}, {10.0, 0.03}}) {
    const auto frames = align(cycles_of(sine(hz), 200));
    EXPECT_LT(worst(frames, sine(hz), 8, 198), bound) << hz;
    // The first and the last ones are one-sided.
    EXPECT_LT(worst(frames, sine(hz), 0, 200), hz < 3.0 ? 3e-3 : 0.5) << hz;
  }
}

TEST(SlotAlignment, LooksTwoCyclesAhead) {
  const auto cycles = cycles_of(sine(1.0), 20);
  SlotAligner aligner(5, SampleRate{kRate});
  std::size_t frames = 0;
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    aligner.push(cycles[i]);
    frames += aligner.take_frames().size();
    EXPECT_EQ(frames, i < 2 ? 0 : i - 1);
  }
}

TEST(SlotAlignment, TakesNothingAcrossGaps) {
  auto cycles = cycles_of(sine(2.0), 60);
  auto after = cycles_of([](double t) { return 5.0 + std::sin(12.0 * t); }, 60);
  cycles.resize(30);
  cycles.insert(cycles.end(), after.begin() + 40, after.end());
  cycles[30].gap_before = true;
  const auto frames = align(cycles);
  ASSERT_EQ(frames.size(), 50U);
  EXPECT_TRUE(frames[30].gap_before);
  EXPECT_LT(worst(frames, sine(2.0), 0, 30), 3e-3);
  EXPECT_LT(worst(
                frames, [](double t) { return 5.0 + std::sin(12.0 * t); }, 30, 50),
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
    EXPECT_EQ(frames[i].usable, i == 20 ? 0U : i == 40 ? 0x1dU : 0x1fU) << i;
  }
  EXPECT_LT(worst(frames, sine(2.0), 0, 60), 3e-3);
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

TEST(SlotAlignment, GivesAFirstVersionOfTheCyclesThatStillWait) {
  const Signal signal = sine(2.0);
  const auto cycles = cycles_of(signal, 60);
  SlotAligner aligner(5, SampleRate{kRate});
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    aligner.push(cycles[i]);
    const auto ahead = aligner.ahead();
    ASSERT_EQ(ahead.size(), std::min<std::size_t>(i + 1, 2)) << "no lookahead at all is left";
    EXPECT_DOUBLE_EQ(ahead.back().time_s * kRate, cycles[i].start_sample + 0.5 * cycles[i].period_samples);
    if (i < AlignmentKernel::kBefore + 1) {
      continue;
    }
    for (const AccelerationFrame& frame : ahead) {
      EXPECT_EQ(frame.usable, 0x1fU);
      for (int slot = 0; slot < 15; ++slot) {
        EXPECT_NEAR(frame.volts[static_cast<std::size_t>(slot / 3)][slot % 3],
                    value(signal, slot, frame.time_s * kRate), 0.005)
            << "cycle " << i << ", slot " << slot;
      }
    }
  }
  // What comes out at last is not touched by having looked.
  const auto looked = aligner.take_frames();
  const auto plain = align(cycles);
  ASSERT_EQ(looked.size() + 2, plain.size());
  for (std::size_t i = 0; i < looked.size(); ++i) {
    for (std::size_t sensor = 0; sensor < 5; ++sensor) {
      EXPECT_EQ(looked[i].volts[sensor], plain[i].volts[sensor]);
    }
  }
}

TEST(SlotAlignment, AFirstVersionNeedsWholeSupport) {
  auto cycles = cycles_of(sine(2.0), 20);
  cycles[17].clipped = 1U << 4U;  // sensor 1
  SlotAligner aligner(5, SampleRate{kRate});
  for (const LineInCycle& cycle : cycles) {
    aligner.push(cycle);
  }
  for (const AccelerationFrame& frame : aligner.ahead()) {
    EXPECT_EQ(frame.usable, 0x1fU & ~(1U << 1U));
  }
  cycles = cycles_of(sine(2.0), 4);
  SlotAligner young(5, SampleRate{kRate});
  for (const LineInCycle& cycle : cycles) {
    young.push(cycle);
  }
  for (const AccelerationFrame& frame : young.ahead()) {
    EXPECT_EQ(frame.usable, 0U);
  }
}

TEST(SlotAlignment, AFirstVersionIsHardlyNoisier) {
  // White noise of unit variance on every slot, through the kernels' weights.
  for (std::size_t after = 0; after <= AlignmentKernel::kAfter; ++after) {
    const AlignmentKernel kernel(after);
    double largest = 0.0;
    for (const double offset : {-0.5, -0.25, 0.0, 0.25, 0.5}) {
      AlignmentKernel::Values instants{};
      for (std::size_t k = 0; k < instants.size(); ++k) {
        instants[k] = static_cast<double>(k) - static_cast<double>(AlignmentKernel::kBefore) + offset;
      }
      double variance = 0.0;
      for (std::size_t k = 0; k <= AlignmentKernel::kBefore + after; ++k) {
        AlignmentKernel::Values one{};
        one[k] = 1.0;
        variance += std::pow(kernel.at_zero(instants, one), 2);
      }
      largest = std::max(largest, variance);
    }
    EXPECT_LT(largest, after == 0 ? 6.6 : after == 1 ? 0.8 : 0.7) << after;
  }
}

}  // namespace
}  // namespace limbwave::decode
