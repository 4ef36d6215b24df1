#include "decode/swing_tracker.h"

#include <algorithm>
#include <cmath>

namespace limbwave::decode {
namespace {

constexpr int kMemory = 60;          // cycles
constexpr double kSteady = 0.002;    // relative; smaller changes are averaged
constexpr double kTolerable = 0.02;  // relative change from cycle to cycle that may lie within one

}  // namespace

SwingTracker::Reading SwingTracker::step(const CycleMeasurement& cycle, const DecayRegression::Estimate& coupling) {
  Reading reading;
  if (cycle.counter_clipped) {
    reading.fallback = true;
    reading.swing = mean_;
    unsettled_ = true;
    return reading;
  }
  // Flattened levels: x = y + κ ∫ (y − c).
  const double swing = sign_ * (cycle.high.mean - cycle.low.mean +
                                coupling.kappa * (cycle.high.integral - cycle.low.integral -
                                                  coupling.offset * (cycle.high.centre - cycle.low.centre)));
  const double residual = std::sqrt(std::max(cycle.low.variance, cycle.high.variance));
  if (residual_ == 0.0) {
    residual_ = residual;
  }
  if (!(swing > 0.0) || residual > std::max(5.0 * residual_, 0.003 * swing)) {
    // Something moved within a half: a knob, a click, a lost sample.
    reading.usable = false;
    reading.swing = mean_;
    unsettled_ = true;
    return reading;
  }
  residual_ += (residual - residual_) / kMemory;

  // What noise alone makes of a swing: two means of about 0.36 periods.
  const double noise = residual_ * std::sqrt(2.0 / (0.36 * cycle.period())) / swing;
  const double change = mean_ > 0.0 ? std::fabs(swing / mean_ - 1.0) : 1.0;
  const double relative = last_ > 0.0 ? std::clamp(swing / last_ - 1.0, -kTolerable, kTolerable) : 0.0;
  if (!known_ || change > std::max({8.0 * std::sqrt(scatter_), 8.0 * noise, kSteady})) {
    reading.moved = known_;
    // Seen here for the first time it may have happened between the halves of this cycle.
    reading.usable = !known_ || unsettled_ || change < kTolerable;
    mean_ = swing;
    count_ = 1;
    unsettled_ = true;
  } else {
    count_ = std::min(count_ + 1, kMemory);
    mean_ += (swing - mean_) / count_;
    unsettled_ = false;
  }
  scatter_ += (0.5 * relative * relative - scatter_) / kMemory;
  known_ = true;
  last_ = swing;
  reading.swing = mean_;
  return reading;
}

}  // namespace limbwave::decode
