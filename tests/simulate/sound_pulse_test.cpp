#include "simulate/sound_pulse.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace limbwave::simulate {
namespace {

constexpr double kRate = 140000.0;

// The same two poles by small steps, driven for ten cycles.
TEST(SoundPulse, EnvelopeIsThatOfTwoPoles) {
  const body::DriverBoxSignal box;
  const SoundPulse pulse(box);
  const double a = std::numbers::pi * box.pulse_hz / box.transducer_q;
  const double b = 2.0 * std::numbers::pi * box.microphone_bandwidth_hz;
  constexpr double kStep = 1e-8;
  double transducer = 0.0;
  double microphone = 0.0;
  std::vector<double> heard;
  for (double t = 0.0; t < 1e-3; t += kStep) {
    const double drive = t < box.pulse_cycles / box.pulse_hz ? 1.0 : 0.0;
    transducer += kStep * a * (drive - transducer);
    microphone += kStep * b * (transducer - microphone);
    heard.push_back(microphone);
  }
  const double peak = *std::max_element(heard.begin(), heard.end());
  for (std::size_t i = 0; i < heard.size(); i += 1000) {
    EXPECT_NEAR(pulse.envelope((static_cast<double>(i) + 1.0) * kStep), heard[i] / peak, 2e-4) << i;
  }
  EXPECT_EQ(pulse.envelope(-1e-6), 0.0);
  EXPECT_LT(pulse.envelope(pulse.length()), 1e-6);
}

TEST(SoundPulse, ADullerTransducerRingsLonger) {
  body::DriverBoxSignal box;
  box.transducer_q = 10.0;
  const SoundPulse quick(box);
  box.transducer_q = 40.0;
  const SoundPulse slow(box);
  EXPECT_GT(slow.length(), 2.0 * quick.length());
}

// Beginning between two samples, turned, and stretched by movement: samples are those of the formula.
TEST(SoundPulse, SamplesAreTheContinuousPulse) {
  const body::DriverBoxSignal box;
  const SoundPulse pulse(box);
  for (const double stretch : {1.0, 1.0 + 3.0 / 344.0, 1.0 - 3.0 / 344.0}) {
    const double start = -3.37 / kRate;
    std::vector<float> samples(400);
    pulse.add(samples.data(), 400, start, 1.0 / kRate, stretch, 0.7, 0.4);
    for (int n = 0; n < 400; ++n) {
      const double t = (start + n / kRate) * stretch;
      const double expected =
          t < 0.0 ? 0.0 : 0.7 * pulse.envelope(t) * std::cos(2.0 * std::numbers::pi * box.pulse_hz * t + 0.4);
      EXPECT_NEAR(samples[static_cast<std::size_t>(n)], expected, 2e-6) << n;
    }
  }
}

}  // namespace
}  // namespace limbwave::simulate
