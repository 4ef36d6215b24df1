#include "decode/cycle_tracker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace limbwave::decode {
namespace {

constexpr double kWavelength = 8.6e-3;

struct Outcome {
  int pulses = 0, accepted = 0, wrong = 0;
  double first = 0.0;  // mean number of pulses until the first that is accepted
};

// A source that is dead-reckoned with a wrong rate and a wrong acceleration, heard every 64 ms.
Outcome followed(double envelope_sd, double rate_sd, double acceleration_sd, int trials) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  Outcome outcome;
  int begun = 0;
  for (int trial = 0; trial < trials; ++trial) {
    CycleTracker cycles(kWavelength, 1e-3, 4e-3);
    Eigen::Matrix3d P = Eigen::Vector3d(4e-4, rate_sd * rate_sd, acceleration_sd * acceleration_sd).asDiagonal();
    cycles.start(P);
    double r = 0.02 * normal(random);
    double rate = rate_sd * normal(random);
    const double acceleration = acceleration_sd * normal(random);
    bool any = false;
    for (int pulse = 0; pulse < 30; ++pulse) {
      if (pulse > 0) {
        constexpr double dt = 0.064;
        cycles.advance(dt, 10.0, 0.1, 0.005, 0.0);
        r += dt * rate + 0.5 * dt * dt * acceleration;
        rate += dt * acceleration;
      }
      const double true_range = 0.7 + r;
      CycleReading reading;
      reading.nominal = 0.7;
      reading.envelope = true_range + envelope_sd * normal(random);
      reading.envelope_variance = envelope_sd * envelope_sd;
      const double phase = true_range + 0.1e-3 * normal(random);
      reading.phase = phase - kWavelength * std::floor(phase / kWavelength);
      reading.phase_variance = 1e-8;
      const CycleResult result = cycles.take(reading);
      ++outcome.pulses;
      if (result.failure <= 1e-3) {
        ++outcome.accepted;
        outcome.wrong += std::abs(result.range - true_range) > 0.5 * kWavelength ? 1 : 0;
        outcome.first += any ? 0.0 : pulse;
        begun += any ? 0 : 1;
        any = true;
      }
    }
  }
  outcome.first /= std::max(1, begun);
  return outcome;
}

// One envelope of 4 mm cannot tell cycles of 8.6 mm; a dozen that are followed can, and say how surely.
TEST(CycleTracker, ResolvesWhatOnePulseCannot) {
  const Outcome outcome = followed(4e-3, 0.3, 0.5, 400);
  std::printf("4 mm: %.1f pulses until the first, %d of %d accepted, %d wrong\n", outcome.first, outcome.accepted,
              outcome.pulses, outcome.wrong);
  EXPECT_GT(outcome.accepted, outcome.pulses / 2);
  EXPECT_LT(outcome.first, 14.0);
  EXPECT_LE(outcome.wrong, outcome.accepted / 500);
}

TEST(CycleTracker, FinerEnvelopesResolveSooner) {
  const Outcome fine = followed(1.5e-3, 0.3, 0.5, 200);
  const Outcome coarse = followed(4e-3, 0.3, 0.5, 200);
  EXPECT_LT(fine.first, coarse.first);
  EXPECT_GT(fine.accepted, fine.pulses * 9 / 10);
  EXPECT_LE(fine.wrong, fine.accepted / 500);
}

// Backward in time is the same.
TEST(CycleTracker, GoesBackward) {
  CycleTracker cycles(kWavelength, 1e-3, 4e-3);
  cycles.start(Eigen::Vector3d(4e-6, 1e-4, 1e-4).asDiagonal());
  double failure = 1.0;
  for (int pulse = 0; pulse < 10; ++pulse) {
    const double true_range = 0.7 - 0.064 * 0.02 * pulse;
    const double phase = true_range - kWavelength * std::floor(true_range / kWavelength);
    const CycleResult result = cycles.take({0.7, true_range, 4e-6, phase, 1e-8});
    failure = result.failure;
    EXPECT_NEAR(result.range, true_range, 1e-9) << pulse;
    cycles.advance(-0.064, 10.0, 0.1, 0.005, 0.0);
  }
  EXPECT_LT(failure, 1e-3);
}

// What is counted from is corrected: nothing about the range changes.
TEST(CycleTracker, ACorrectionOfTheNominalMovesTheResidual) {
  CycleTracker cycles(kWavelength, 1e-3, 4e-3);
  cycles.start(Eigen::Vector3d(4e-6, 1e-6, 1e-6).asDiagonal());
  double nominal = 0.7;
  for (int pulse = 0; pulse < 6; ++pulse) {
    const CycleResult result = cycles.take({nominal, 0.701, 4e-6, 0.701 - kWavelength * 81.0, 1e-8});
    EXPECT_NEAR(result.range, 0.701, 1e-9);
    cycles.shift(Eigen::Vector3d(-0.02, 0.0, 0.0));
    nominal += 0.02;
    cycles.advance(0.064, 10.0, 0.1, 0.005, 0.0);
  }
}

}  // namespace
}  // namespace limbwave::decode
