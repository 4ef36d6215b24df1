/// Several trackers of one microphone, from one that hardly moves to one that is flung about, and how well each
/// explains what is heard.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "decode/range_tracker.h"

namespace limbwave::decode {

/// A bank of filters with weights that follow the likelihood of the ranges (a generalised pseudo-Bayesian estimator of
/// first order without merging; Bar-Shalom, Li & Kirubarajan 2001, §11.6).
class RangeTrackers {
 public:
  RangeTrackers(const RangingFormat& format, const RangingParameters& parameters);

  void advance(double time_s);
  /// Mean and variance of the mixture; the direction of the likeliest.
  [[nodiscard]] std::optional<RangeTracker::Expectation> expect(int source) const;
  /// Density of a range, per metre but for a factor; 1 where nothing is known.
  [[nodiscard]] double likelihood(int source, double range, double variance) const;
  void update(int source, double range, double variance);
  void contradict();
  void doubt(int source);
  void collect(int source, double time_s, double range, double variance);

 private:
  static constexpr std::size_t kModels = 3;
  std::vector<RangeTracker> trackers_;
  std::array<double, kModels> weights_{};
};

}  // namespace limbwave::decode
