#include "decode/coupling.h"

#include <algorithm>
#include <cmath>

namespace limbwave::decode {

void DecayRegression::add(double level, double slope) {
  weight_ += 1.0;
  level_ += level;
  slope_ += slope;
  level_level_ += level * level;
  level_slope_ += level * slope;
  slope_slope_ += slope * slope;
}

void DecayRegression::fade(double factor) {
  for (double* sum : {&weight_, &level_, &slope_, &level_level_, &level_slope_, &slope_slope_}) {
    *sum *= factor;
  }
}

DecayRegression::Estimate DecayRegression::estimate() const {
  Estimate result;
  if (weight_ < 3.0) {
    return result;
  }
  const double spread = level_level_ - level_ * level_ / weight_;
  if (!(spread > 1e-12 * weight_)) {
    return result;
  }
  const double common = level_slope_ - level_ * slope_ / weight_;
  result.kappa = -common / spread;
  const double rest = std::max(0.0, slope_slope_ - slope_ * slope_ / weight_ - common * common / spread);
  result.sd = std::sqrt(rest / (weight_ - 2.0) / spread);
  // slope mean = −κ (level mean − c)
  result.offset = result.kappa > 4.0 * result.sd ? (level_ + slope_ / result.kappa) / weight_ : 0.0;
  return result;
}

void CouplingEstimator::add(const CycleMeasurement& cycle, const std::array<double, kMaxSlots>& levels, int slots) {
  if (!cycle.linked) {
    unlink();
  }
  const double keep = std::exp(-1.0 / memory_cycles_);
  if (!cycle.counter_clipped) {
    counter_.fade(keep);
    counter_.add(cycle.low.mean, cycle.low.slope);
    counter_.add(cycle.high.mean, cycle.high.slope);
  }
  if (waiting_ == 2) {
    // Slope = −κ (level − c) + motion: the levels before and after tell the motion.
    const auto& [before, middle] = window_;
    data_.fade(keep);
    for (int j = 0; j < slots; ++j) {
      const auto index = static_cast<std::size_t>(j);
      const std::uint32_t bit = 1U << index;
      if (((before.cycle.clipped | middle.cycle.clipped | cycle.clipped) & bit) != 0) {
        continue;
      }
      const double motion =
          (levels[index] - before.levels[index]) / (cycle.slots[index].centre - before.cycle.slots[index].centre);
      data_.add(middle.cycle.slots[index].mean, middle.cycle.slots[index].slope - motion);
    }
    window_[0] = window_[1];
    waiting_ = 1;
  }
  window_[static_cast<std::size_t>(waiting_)] = {cycle, levels};
  ++waiting_;
}

DecayRegression::Estimate CouplingEstimator::data() const {
  // Two channels of a card are built alike, with capacitors of 10 % or so.
  const DecayRegression::Estimate prior = counter_.estimate();
  DecayRegression::Estimate own = data_.estimate();
  const double prior_sd = std::hypot(0.15 * prior.kappa, prior.sd) + 1e-6;
  const double own_weight = 1.0 / (own.sd * own.sd + 1e-24);
  const double prior_weight = 1.0 / (prior_sd * prior_sd);
  DecayRegression::Estimate result;
  result.kappa = std::max(0.0, (own.kappa * own_weight + prior.kappa * prior_weight) / (own_weight + prior_weight));
  result.sd = std::sqrt(1.0 / (own_weight + prior_weight));
  result.offset = own.offset;
  return result;
}

}  // namespace limbwave::decode
