/// The filter behind Smoothing::kAdaptive: a weighted mean of directions whose memory lengthens as trust falls.
#pragma once

#include "estimate/inclination.h"

namespace limbwave::estimate {

/// One direction of time; the offline estimate adds the sums of a forward and a backward one.
class AdaptiveFilter {
 public:
  explicit AdaptiveFilter(const InclinationParameters& parameters) : parameters_(parameters) {}

  /// A weighted sum of unit vectors up to and including a sample.
  struct Sum {
    Vector3d direction = Vector3d::Zero();  ///< Σ weight · unit vector.
    double weight = 0.0;                    ///< Σ weight, 1/rad².
  };

  /// `acceleration_sd` and `noise` in m/s² per axis for this sample; `dt` >= 0 since the one before, seconds.
  const Sum& step(const ForceSample& sample, double dt, double acceleration_sd, double noise);
  [[nodiscard]] const Sum& sum() const { return sum_; }

  /// What a sample alone contributes: unit vector times 1/variance of its direction; zero when unusable.
  static Sum alone(const ForceSample& sample, double acceleration_sd, double noise);

 private:
  InclinationParameters parameters_;
  Sum sum_;
};

}  // namespace limbwave::estimate
