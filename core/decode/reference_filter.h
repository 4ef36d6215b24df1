/// Where the reference level lies: a Kalman filter over the reference slots.
#pragma once

#include <cmath>
#include <cstdint>

#include "decode/coupling.h"
#include "decode/cycle_measurement.h"

namespace limbwave::decode {

/// The reference voltage does not change. What moves its level is the coupling, which is undone but for the noise that
/// is integrated with it, the uncertainty of κ, and a steady drift from the card's own offset. So every reference slot
/// may help all others. State: level at the last reference slot (as the card gave it) and drift per cycle.
class ReferenceFilter {
 public:
  /// Flattened level (mean + κ · integral) of the reference within a cycle: `level` at `instant`, changing by `slope`
  /// per sample.
  struct Line {
    double level = 0.0;
    double instant = 0.0;
    double slope = 0.0;
    bool jumped = false;  ///< The level is not where it must be: something happened to the line since the last one.
    /// A clipped slot or a click breaks the integral: slots before `break_at` (samples) go by the previous reference.
    double break_at = -1e300;
    double level_before = 0.0;
    double instant_before = 0.0;
    /// Bit per slot: neither reference reaches it, because the integral is broken on both sides.
    std::uint32_t uncertain = 0;
    [[nodiscard]] double at(double sample) const {
      return sample < break_at ? level_before + slope * (sample - instant_before) : level + slope * (sample - instant);
    }
  };
  /// The level before the next cycle is not known; the drift still is.
  void restart() { known_ = false; }
  /// `slots` of the board, the last is the reference. `noise` is the RMS of a sample. A surprise below `tolerated`
  /// (fraction of full scale) is never taken for a jump.
  Line step(const CycleMeasurement& cycle, int slots, const DecayRegression::Estimate& coupling, double noise,
            double tolerated);

  /// How far the reference level is from where it is expected, RMS of about half a second: noise, or hum.
  [[nodiscard]] double unrest() const { return std::sqrt(innovation_); }

 private:
  bool known_ = false, drift_known_ = false;
  double level_ = 0.0;
  double drift_ = 0.0;
  double p00_ = 0.0, p01_ = 0.0, p11_ = 1e-6;
  double innovation_ = 0.0;  // running mean of squared innovations
  double jumps_ = 0.0;       // jumps of late
};

/// Flattened levels of all slots relative to the reference at the same instant, fractions of full scale.
std::array<double, kMaxSlots> relative_levels(const CycleMeasurement& cycle, const ReferenceFilter::Line& reference,
                                              double kappa, int slots);

}  // namespace limbwave::decode
