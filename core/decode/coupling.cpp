#include "decode/coupling.h"

#include <algorithm>
#include <cmath>

namespace limbwave::decode {

void DecayRegression::add(double level, double slope, double step) {
  weight_ += 1.0;
  level_ += level;
  step_ += step;
  slope_ += slope;
  level_level_ += level * level;
  level_step_ += level * step;
  step_step_ += step * step;
  level_slope_ += level * slope;
  step_slope_ += step * slope;
  slope_slope_ += slope * slope;
}

void DecayRegression::fade(double factor) {
  for (double* sum : {&weight_, &level_, &step_, &slope_, &level_level_, &level_step_, &step_step_, &level_slope_,
                      &step_slope_, &slope_slope_}) {
    *sum *= factor;
  }
}

DecayRegression::Estimate DecayRegression::estimate() const {
  Estimate result;
  if (weight_ < 4.0) {
    return result;
  }
  // Centred moments; then the part that goes with the steps is taken out (Frisch and Waugh).
  double ll = level_level_ - level_ * level_ / weight_;
  double lz = level_slope_ - level_ * slope_ / weight_;
  double zz = slope_slope_ - slope_ * slope_ / weight_;
  const double ls = level_step_ - level_ * step_ / weight_;
  const double ss = step_step_ - step_ * step_ / weight_;
  const double sz = step_slope_ - step_ * slope_ / weight_;
  const bool steps = ss > 1e-12 * weight_;
  if (steps) {
    ll -= ls * ls / ss;
    lz -= ls * sz / ss;
    zz -= sz * sz / ss;
  }
  if (!(ll > 1e-12 * weight_)) {
    return result;
  }
  result.kappa = -lz / ll;
  const double rest = std::max(0.0, zz - lz * lz / ll);
  result.sd = std::sqrt(rest / (weight_ - 3.0) / ll);
  if (result.kappa > 4.0 * result.sd) {
    const double transient = steps ? (sz + result.kappa * ls) / ss : 0.0;
    // The means obey slope = −κ (level − c) + a · step as well.
    result.offset = (level_ + (slope_ - transient * step_) / result.kappa) / weight_;
  }
  return result;
}

void CouplingEstimator::add(const CycleMeasurement& cycle, const std::array<double, kMaxSlots>& levels, int slots) {
  if (!cycle.linked) {
    unlink();
  }
  const double keep = std::exp(-1.0 / memory_cycles_);
  if (!cycle.counter_clipped) {
    counter_.fade(keep);
    counter_.add(cycle.low.mean, cycle.low.slope, 0.0);
    counter_.add(cycle.high.mean, cycle.high.slope, 0.0);
  }
  if (waiting_ == kWindow) {
    std::move(window_.begin() + 1, window_.end(), window_.begin());
    --waiting_;
  }
  window_[waiting_++] = {cycle, levels};
  if (waiting_ < kWindow) {
    estimate();
    return;
  }
  // Slope = −κ (level − c) + motion: the levels two cycles before and after tell the motion, to fourth order.
  const CycleMeasurement& middle = window_[2].cycle;
  const auto last = static_cast<std::size_t>(slots - 1);
  std::uint32_t broken = 0;
  for (const Waiting& waiting : window_) {
    broken |= waiting.cycle.broken;
  }
  data_.fade(keep);
  for (std::size_t j = 0; j <= last; ++j) {
    if ((broken >> j & 1U) != 0) {
      continue;
    }
    const double near = window_[3].levels[j] - window_[1].levels[j];
    const double far = window_[4].levels[j] - window_[0].levels[j];
    const double distance = window_[4].cycle.slots[j].centre - window_[0].cycle.slots[j].centre;
    const double motion = (8.0 * near - far) / (3.0 * distance);
    const double step = window_[2].levels[j] - window_[2].levels[j == 0 ? last : j - 1];
    data_.add(middle.slots[j].mean, middle.slots[j].slope - motion, step);
  }
  estimate();
}

void CouplingEstimator::estimate() {
  // Two channels of a card are built alike, with capacitors of 10 % or so.
  counter_estimate_ = counter_.estimate();
  const DecayRegression::Estimate& prior = counter_estimate_;
  const DecayRegression::Estimate own = data_.estimate();
  const double prior_sd = std::hypot(0.15 * prior.kappa, prior.sd) + 1e-6;
  const double own_weight = 1.0 / (own.sd * own.sd + 1e-24);
  const double prior_weight = 1.0 / (prior_sd * prior_sd);
  data_estimate_.kappa =
      std::max(0.0, (own.kappa * own_weight + prior.kappa * prior_weight) / (own_weight + prior_weight));
  data_estimate_.sd = std::sqrt(1.0 / (own_weight + prior_weight));
  data_estimate_.offset = own.offset;
}

}  // namespace limbwave::decode
