/// Several bridging filters that differ in one constant which only the data can tell, and their likelihoods.
///
/// How strongly a limb turns while it accelerates depends on what is done: shaking something turns nothing, rolling a
/// sensor in the hand turns it fast and hardly accelerates it. The ratio is a length: the lever of a sensor about the
/// joint that moves it is 0.05 to 0.4 m, translation is a longer one. Filters for lengths that double from one to the
/// next run side by side; each is believed as far as it predicted the readings of the last seconds.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace limbwave::estimate {

/// Limb acceleration by angular acceleration, metres.
inline constexpr std::array<double, 6> kLevers = {0.05, 0.1, 0.2, 0.4, 0.8, 1.6};

/// For how long readings speak for or against a lever, seconds.
inline constexpr double kEvidenceMemory = 5.0;

using Logs = std::array<double, kLevers.size()>;

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
