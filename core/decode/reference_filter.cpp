#include "decode/reference_filter.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace limbwave::decode {
namespace {

constexpr double kDriftChange = 1e-6;     // RMS change of the drift per cycle, fraction of full scale per cycle
constexpr double kInnovationGain = 0.03;  // memory of about half a second
constexpr double kJump = 10.0;            // standard deviations
constexpr double kJumpMemory = 0.95;      // per cycle
constexpr double kJumpsOfHum = 3.0;
constexpr double kSmallestVariance = 1e-18;

}  // namespace

ReferenceFilter::Line ReferenceFilter::step(const CycleMeasurement& cycle, int slots,
                                            const DecayRegression::Estimate& coupling, double noise, double tolerated) {
  const double kappa = coupling.kappa;
  const LevelReading& reference = cycle.slots[static_cast<std::size_t>(slots - 1)];
  const double measured_variance = noise * noise * cycle.data_noise_gain + kSmallestVariance;
  if (!cycle.linked || !known_ || cycle.broken != 0) {
    if (!drift_known_) {
      // The flattened level runs away by κ c per sample.
      drift_ = kappa * coupling.offset * cycle.period();
      drift_known_ = true;
    }
    Line line;
    line.level = reference.mean + kappa * reference.integral;
    line.instant = reference.centre;
    line.slope = drift_ / cycle.period();
    if (cycle.broken != 0) {
      int first = 0;
      if (cycle.linked && known_) {
        first = std::countr_zero(cycle.broken);
        line.break_at = cycle.slots[static_cast<std::size_t>(first)].centre;
        line.level_before = level_;
        line.instant_before = cycle.previous_reference.centre;
      }
      const std::uint32_t up_to_last = ~std::uint32_t{0} >> std::countl_zero(cycle.broken);
      line.uncertain = up_to_last & ~((std::uint32_t{1} << first) - 1U) & ~cycle.broken;
    }
    known_ = (cycle.broken >> static_cast<unsigned>(slots - 1) & 1U) == 0;
    level_ = reference.mean;
    p00_ = measured_variance;
    p01_ = 0.0;
    return line;
  }
  // Predict: level⁻ = level − κ ∫ + drift.
  const double wander = kappa * noise;
  const double doubt = coupling.sd * reference.integral;
  const double level = level_ - kappa * reference.integral + drift_;
  double q00 = p00_ + 2.0 * p01_ + p11_ + wander * wander * cycle.period() + doubt * doubt + kSmallestVariance;
  const double q01 = p01_ + p11_;
  const double q11 = p11_ + kDriftChange * kDriftChange;
  // What innovations show beyond the model (hum, a second coupling stage) is taken for movement of the level.
  const double innovation = reference.mean - level;
  q00 += std::max(0.0, innovation_ - q00 - measured_variance);
  jumps_ *= kJumpMemory;
  if (std::fabs(innovation) > std::max(tolerated, kJump * std::sqrt(q00 + measured_variance))) {
    // What keeps jumping is not a jump but hum: then it is followed.
    if (++jumps_ < kJumpsOfHum) {
      known_ = false;
      Line line = step(cycle, slots, coupling, noise, tolerated);
      line.jumped = true;
      return line;
    }
    innovation_ = std::max(innovation_, innovation * innovation);
    q00 += innovation_;
  }
  innovation_ += kInnovationGain * (innovation * innovation - innovation_);

  // Update.
  const double total = q00 + measured_variance;
  const double gain0 = q00 / total;
  const double gain1 = q01 / total;
  const double new_level = level + gain0 * innovation;
  const double new_drift = drift_ + gain1 * innovation;

  // What this reference tells of the previous one (Rauch-Tung-Striebel, one step): C = P Fᵀ Q⁻¹, first row.
  const double determinant = q00 * q11 - q01 * q01;
  const double f0 = p00_ + p01_;
  const double f1 = p01_;
  double previous = level_;
  if (determinant > 0.0) {
    previous += ((f0 * q11 - f1 * q01) * gain0 + (f1 * q00 - f0 * q01) * gain1) / determinant * innovation;
  }

  level_ = new_level;
  drift_ = new_drift;
  p00_ = (1.0 - gain0) * q00;
  p01_ = (1.0 - gain0) * q01;
  p11_ = q11 - gain1 * q01;

  Line line;
  line.level = level_ + kappa * reference.integral;
  line.instant = reference.centre;
  line.slope = (line.level - previous) / (reference.centre - cycle.previous_reference.centre);
  return line;
}

std::array<double, kMaxSlots> relative_levels(const CycleMeasurement& cycle, const ReferenceFilter::Line& reference,
                                              double kappa, int slots) {
  std::array<double, kMaxSlots> levels{};
  for (std::size_t j = 0; j < static_cast<std::size_t>(slots); ++j) {
    const LevelReading& slot = cycle.slots[j];
    levels[j] = slot.mean + kappa * slot.integral - reference.at(slot.centre);
  }
  return levels;
}

}  // namespace limbwave::decode
