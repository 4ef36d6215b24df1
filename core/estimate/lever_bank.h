/// Several bridging filters that differ in two constants which only the data can tell, and their likelihoods.
///
/// How strongly a limb turns while it accelerates depends on what is done: shaking something turns nothing, rolling a
/// sensor in the hand turns it fast and hardly accelerates it. The ratio is a length: the lever of a sensor about the
/// joint that moves it is 0.05 to 0.4 m, translation is a longer one. How much of the acceleration is across gravity,
/// where | |f| − g | does not show it, depends on it too. Filters for all of these run side by side; each is believed
/// as far as it predicted the readings of the last seconds.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace limbwave::estimate {

/// One model of a limb's movement.
struct Hypothesis {
  double lever;   ///< Limb acceleration by angular acceleration, metres.
  double across;  ///< Limb acceleration across gravity by what shows along it.
};

inline constexpr std::array<double, 6> kLevers = {0.05, 0.1, 0.2, 0.4, 0.8, 1.6};
inline constexpr std::array<double, 3> kAcross = {1.0, 2.0, 4.0};
inline constexpr std::size_t kHypotheses = kLevers.size() * kAcross.size();

constexpr Hypothesis hypothesis(std::size_t index) {
  return {kLevers[index / kAcross.size()], kAcross[index % kAcross.size()]};
}

/// For how long readings speak for or against a hypothesis, seconds.
inline constexpr double kEvidenceMemory = 5.0;

using Logs = std::array<double, kHypotheses>;

/// Likelihoods, relative to each other and adding up to 1, from summed logarithms.
inline Logs weights_of(const Logs& logs) {
  const double highest = *std::max_element(logs.begin(), logs.end());
  Logs weights{};
  double sum = 0.0;
  for (std::size_t i = 0; i < logs.size(); ++i) {
    weights[i] = std::exp(logs[i] - highest);
    sum += weights[i];
  }
  for (double& weight : weights) {
    weight /= sum;
  }
  return weights;
}

/// Adds a reading's logarithms to the fading sum of those before it.
inline void add_faded(Logs& sum, const Logs& logs, double dt) {
  const double kept = std::exp(-dt / kEvidenceMemory);
  for (std::size_t i = 0; i < sum.size(); ++i) {
    sum[i] = kept * sum[i] + logs[i];
  }
}

}  // namespace limbwave::estimate
