/// Clicks, and samples that were lost or repeated in the middle of a slot.
#pragma once

#include <cstdint>

#include "decode/cycle_measurement.h"

namespace limbwave::decode {

/// Tells slots within which something happened that neither noise nor the board makes. What is left around a slot's
/// straight line has the variance n² + r² s²: noise, and what still rings of the step s before it. Both are learnt from
/// the line of the last second.
class ClickGuard {
 public:
  /// `noise`: RMS of a sample within settled slots, to begin with.
  explicit ClickGuard(double noise) : first_square_(noise * noise) {}
  /// Bit per slot, the reference slot left out; `swing` of the counter, fraction of full scale.
  std::uint32_t step(const CycleMeasurement& cycle, int slots, double swing);

 private:
  [[nodiscard]] double expected(double step_square) const;

  double first_square_;
  // Fading sums over slots of 1, s², s⁴, variance and variance · s².
  double weight_ = 0.0, step_ = 0.0, step_step_ = 0.0, variance_ = 0.0, step_variance_ = 0.0;
};

}  // namespace limbwave::decode
