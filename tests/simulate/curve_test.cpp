#include "simulate/curve.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/units.h"

namespace limbwave::simulate {
namespace {

// Value, slope and curvature against central differences of the value.
template <typename F>
void expect_derivatives(const F& f, double t, double tolerance) {
  const double h = 1e-3;
  const Jet at = f(t);
  EXPECT_NEAR(at.d, (f(t + h).v - f(t - h).v) / (2 * h), tolerance) << "at " << t;
  EXPECT_NEAR(at.dd, (f(t + h).v - 2 * at.v + f(t - h).v) / (h * h), 10 * tolerance) << "at " << t;
}

TEST(Curve, PassesThroughItsKeysAtRest) {
  Curve curve;
  curve.key(1.0, 2.0).key(3.0, -1.0).key(4.0, -1.0).key(5.0, 0.5);
  for (const auto& [t, value] : {std::pair{0.0, 2.0}, {1.0, 2.0}, {3.0, -1.0}, {3.5, -1.0}, {5.0, 0.5}, {9.0, 0.5}}) {
    const Jet at = curve.at(t);
    EXPECT_NEAR(at.v, value, 1e-12);
    EXPECT_NEAR(at.d, 0.0, 1e-12);
    EXPECT_NEAR(at.dd, 0.0, 1e-12);
  }
  EXPECT_DOUBLE_EQ(curve.end(), 5.0);
}

TEST(Curve, DerivativesAreThoseOfTheValue) {
  Curve curve;
  curve.key(0.0, 0.0).key(1.0, 1.0).key(2.5, -0.5).oscillate(0.2, 2.2, 0.5, 1.5, 0.3, 0.7);
  for (double t = 0.03; t < 2.6; t += 0.061) {
    expect_derivatives([&](double x) { return curve.at(x); }, t, 2e-3);
  }
}

TEST(Curve, HasAContinuousJerk) {
  Curve curve;
  curve.key(0.0, 0.0).key(1.0, 1.0).key(2.0, 0.0).oscillate(0.5, 1.7, 0.3, 2.0, 0.2);
  // The largest change of the jerk over a step shrinks with the step; at a jump of the jerk it would not.
  const auto largest_change = [&](double h) {
    double largest = 0.0;
    for (double t = -0.1; t < 2.2; t += h) {
      const double jerk = (curve.at(t + h).dd - curve.at(t).dd) / h;
      const double next = (curve.at(t + 2 * h).dd - curve.at(t + h).dd) / h;
      largest = std::max(largest, std::abs(next - jerk));
    }
    return largest;
  };
  EXPECT_LT(largest_change(2e-5), 0.15 * largest_change(2e-4));
}

TEST(SampledCurve, GoesThroughSmoothSamplesExactly) {
  const double rate = 120.0;
  const auto f = [](double t) { return std::sin(2 * kPi * 2.0 * t) + 0.5 * std::cos(2 * kPi * 5.0 * t); };
  std::vector<double> samples;
  samples.reserve(600);
  for (int i = 0; i < 600; ++i) {
    samples.push_back(f(i / rate));
  }
  const SampledCurve curve(samples, rate, 10.0);
  for (double t = 1.0; t < 4.0; t += 0.00713) {
    const double w1 = 2 * kPi * 2.0;
    const double w2 = 2 * kPi * 5.0;
    EXPECT_NEAR(curve.at(t).v, f(t), 1e-4);
    EXPECT_NEAR(curve.at(t).dd, -w1 * w1 * std::sin(w1 * t) - 0.5 * w2 * w2 * std::cos(w2 * t), 0.3);
  }
}

TEST(SampledCurve, DerivativesAreThoseOfTheValueAlsoBeyondTheEnds) {
  std::vector<double> samples;
  samples.reserve(200);
  for (int i = 0; i < 200; ++i) {
    samples.push_back(std::sin(0.11 * i) + 0.01 * i);
  }
  const SampledCurve curve(samples, 100.0, 10.0);
  for (double t = -0.3; t < 2.3; t += 0.0371) {
    expect_derivatives([&](double x) { return curve.at(x); }, t, 1e-2);
  }
}

TEST(SampledCurve, TakesAwayNoiseAboveItsBand) {
  std::vector<double> samples;
  samples.reserve(400);
  for (int i = 0; i < 400; ++i) {
    samples.push_back(i % 2 == 0 ? 1.0 : -1.0);  // 60 Hz at a rate of 120 Hz
  }
  const SampledCurve curve(samples, 120.0, 10.0);
  for (double t = 1.0; t < 2.0; t += 0.013) {
    EXPECT_NEAR(curve.at(t).v, 0.0, 1e-3);
  }
}

}  // namespace
}  // namespace limbwave::simulate
