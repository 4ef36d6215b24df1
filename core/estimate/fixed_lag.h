/// Fixed-lag smoothing of a running body filter: poses a little late, from both sides. What comes out for an instant is
/// what the fixed-interval smoother gives for it when the recording ends `lag_s` later (Bryson and Frazier's adjoint
/// over the updates of the lag).
#pragma once

#include <deque>
#include <optional>

#include "estimate/body_filter.h"

namespace limbwave::estimate {

class FixedLag {
 public:
  explicit FixedLag(double lag_s) : lag_s_(lag_s) {}

  /// Takes over the record of a step that the filter has just made; `wanted`: a pose shall come out for it.
  void push(const BodyFilter& filter, StepRecord record, bool wanted);
  /// The smoothed state of the oldest wanted instant that is at least the lag ago, or, when `all`, of the oldest at
  /// all. Its joint positions are smoothed; velocities and constants are the filter's.
  std::optional<BodyState> next(const BodyFilter& filter, bool all = false);

 private:
  struct Kept {
    StepRecord record;
    double time_s = 0.0;
    bool wanted = false;
    BodyState state;
    Eigen::MatrixXd P_theta;  // columns: joint degrees of freedom
  };
  void drop_old();

  double lag_s_;
  std::deque<Kept> steps_;
};

}  // namespace limbwave::estimate
