/// The counter bit swings by the supply voltage, so its height measures the gain of the line.
#pragma once

#include <cstdint>

#include "decode/coupling.h"
#include "decode/cycle_measurement.h"

namespace limbwave::decode {

/// Averages the swing while it stands and follows it at once when it moves.
class SwingTracker {
 public:
  struct Reading {
    double swing = 0.0;     ///< To scale this cycle with, fraction of full scale.
    bool usable = true;     ///< False where the gain changed within this cycle, or the counter was disturbed.
    bool fallback = false;  ///< The counter is clipped: an older swing is used, or a clipped one if there is no older.
    bool moved = false;     ///< The gain is not what it was.
  };
  /// `inverted`: the counter is high in the first half. `first_swing` serves while nothing better is measured.
  SwingTracker(double first_swing, bool inverted) : mean_(first_swing), sign_(inverted ? -1.0 : 1.0) {}
  Reading step(const CycleMeasurement& cycle, const DecayRegression::Estimate& coupling);
  [[nodiscard]] double swing() const { return mean_; }

 private:
  double mean_;
  double sign_;
  int count_ = 0;      // cycles in the mean
  double last_ = 0.0;  // the last cycle's own swing
  double before_last_ = 0.0;
  double scatter_ = 0.0;   // running variance of the swings, relative
  double residual_ = 0.0;  // running RMS within the halves
  bool known_ = false;     // an unclipped swing was seen
};

}  // namespace limbwave::decode
