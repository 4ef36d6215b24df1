/// How fast a capacitor-coupled channel forgets, estimated from the signal itself.
#pragma once

#include <array>

#include "decode/cycle_measurement.h"

namespace limbwave::decode {

/// Regression slope = −κ (level − c) + a · step + noise, with fading memory. κ is per sample: 2π · corner / rate.
/// What is left of the transient after an edge is proportional to the edge's height, whatever the filter that rings:
/// the second term keeps it out of κ.
class DecayRegression {
 public:
  /// A level, its slope (value per sample), and the height of the edge before it.
  void add(double level, double slope, double step);
  /// Multiplies the weight of everything so far.
  void fade(double factor);
  struct Estimate {
    double kappa = 0.0;
    double sd = 1e9;      ///< Standard deviation of kappa; huge when nothing can be told.
    double offset = 0.0;  ///< c: what the level decays to.
  };
  [[nodiscard]] Estimate estimate() const;

 private:
  // Sums of 1, level, step, slope and of their products.
  double weight_ = 0.0, level_ = 0.0, step_ = 0.0, slope_ = 0.0;
  double level_level_ = 0.0, level_step_ = 0.0, step_step_ = 0.0;
  double level_slope_ = 0.0, step_slope_ = 0.0, slope_slope_ = 0.0;
};

/// Both channels' coupling. The counter's is known precisely after a few cycles; it is the prior for the data channel,
/// whose slopes are corrected for the motion seen from cycle to cycle, so that moving signals do not bias it.
class CouplingEstimator {
 public:
  /// `memory_cycles`: after so many cycles a reading's weight has fallen to 1/e.
  explicit CouplingEstimator(double memory_cycles) : memory_cycles_(memory_cycles) {}
  /// The next cycle's readings and its slot levels relative to the reference slot, corrected with the estimate so far,
  /// in fractions of full scale.
  void add(const CycleMeasurement& cycle, const std::array<double, kMaxSlots>& levels, int slots);
  /// The next cycle does not follow the last one.
  void unlink() { waiting_ = 0; }
  [[nodiscard]] DecayRegression::Estimate counter() const { return counter_estimate_; }
  /// Data channel, prior included; kappa is not negative.
  [[nodiscard]] DecayRegression::Estimate data() const { return data_estimate_; }

 private:
  struct Waiting {
    CycleMeasurement cycle;
    std::array<double, kMaxSlots> levels{};
  };
  void estimate();

  double memory_cycles_;
  DecayRegression counter_, data_;
  DecayRegression::Estimate counter_estimate_, data_estimate_;  // asked for several times a cycle
  static constexpr std::size_t kWindow = 5;
  std::array<Waiting, kWindow> window_;  // the newest cycles in a row, newest last
  std::size_t waiting_ = 0;
};

}  // namespace limbwave::decode
