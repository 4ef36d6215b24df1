#include "decode/swing_tracker.h"

#include <algorithm>
#include <cmath>

namespace limbwave::decode {
namespace {

constexpr int kMemory = 60;           // cycles
constexpr double kSteady = 0.002;     // relative; smaller changes are averaged
constexpr double kDisturbance = 5.0;  // times the usual scatter within a half
constexpr double kTolerable = 0.003;  // relative change from cycle to cycle: one per cent is a degree of inclination

}  // namespace

SwingTracker::Reading SwingTracker::step(const CycleMeasurement& cycle, const DecayRegression::Estimate& coupling) {
  Reading reading;
  if (cycle.counter_clipped) {
    reading.fallback = true;
    reading.swing = mean_;
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
  const bool disturbed = !(swing > 0.0) || residual > std::max(kDisturbance * residual_, kTolerable * swing);
  // What noise alone makes of a swing: two means of about 0.36 periods.
  const double noise = residual_ * std::sqrt(2.0 / (0.36 * cycle.period())) / std::max(swing, 1e-12);
  const double spread = 8.0 * std::max(noise, std::sqrt(scatter_));
  const bool steady = last_ <= 0.0 || std::fabs(swing / last_ - 1.0) < std::max(spread, kTolerable);
  // Second differences tell noise and hum from a knob that is being turned.
  if (before_last_ > 0.0 && swing > 0.0) {
    const double bend = std::clamp((swing - 2.0 * last_ + before_last_) / swing, -0.01, 0.01);
    scatter_ += (bend * bend / 6.0 - scatter_) / kMemory;
  }
  before_last_ = last_;
  last_ = swing;
  // What disturbs every half is no click but hum or a bad line: within half a second that is usual.
  residual_ += (std::min(residual, kDisturbance * residual_) - residual_) / kMemory;
  if (disturbed) {
    // Something moved within a half: a knob, a click, a lost sample.
    reading.usable = false;
    reading.swing = mean_;
    return reading;
  }
  reading.usable = steady;
  if (known_ && std::fabs(swing / mean_ - 1.0) < std::max(spread, kSteady)) {
    count_ = std::min(count_ + 1, kMemory);
    mean_ += (swing - mean_) / count_;
  } else {
    reading.moved = known_;
    mean_ = swing;
    count_ = 0;  // this cycle may hold both gains: the next one starts the mean
  }
  known_ = true;
  reading.swing = mean_;
  return reading;
}

}  // namespace limbwave::decode
