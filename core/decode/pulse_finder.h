/// Finds the first arrival of a pulse in one slot.
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "decode/pulse_shape.h"

namespace limbwave::decode {

/// A pulse as it arrived.
struct Arrival {
  double delay_s = 0.0;           ///< Since the slot's start, by the envelope.
  double delay_variance = 0.0;    ///< s², Cramér–Rao bound at the arrival's strength, beside those it overlaps.
  double phase = 0.0;             ///< Of the carrier: -2 pi f delay + the source's own, radians, -pi..pi.
  double phase_variance = 0.0;    ///< Radians².
  double amplitude = 0.0;         ///< Fraction of full scale.
  double energy_ratio = 0.0;      ///< After the matched filter, over the noise.
  double doppler = 0.0;           ///< Turn of the carrier, radians a second; below 0: away from each other.
  double doppler_variance = 0.0;  ///< Of that.
  /// Energy that no single pulse explains, over the noise's and beyond what noise makes; 0: none. An echo a few
  /// centimetres behind is not told apart, but shifts envelope and phase, and leaves this.
  double misfit = 0.0;
};

struct FoundPulse {
  std::vector<Arrival> arrivals;  ///< At most a few, the first one first; empty: nothing stands out of the noise.
  double noise = 0.0;             ///< Power of a complex value that was assumed.
};

class PulseFinder {
 public:
  PulseFinder(const PulseShape& shape, const BasebandPlan& plan);

  /// `values` go from a little before the slot's first sample (so that a pulse that begins at once is whole) to its
  /// end; the first one lies `first_value_s` after the instant that delays are counted from. Arrivals within
  /// 0..longest_s are sought whose energy is `detection` times the noise's.
  FoundPulse find(std::span<const std::complex<float>> values, double first_value_s, double longest_s, double noise,
                  double detection);

 private:
  struct Fit {
    double place = 0.0;  // of the pulse's beginning, in values
    std::complex<double> a;
    double turn = 0.0;                                // of the carrier, radians per value
    double measured_turn = 0.0, turn_variance = 0.0;  // before it was shrunk by what limbs usually do
  };
  void correlate(std::size_t first, std::size_t last);
  [[nodiscard]] Fit fit(std::size_t lag, double noise) const;
  void subtract(const Fit& fit, double sign);
  [[nodiscard]] double misfit(const Fit& fit, double noise) const;
  /// How much more uncertain delay and phase are for other arrivals that overlap: factors of their variances.
  [[nodiscard]] std::pair<double, double> crowding(const Fit& fit, const std::vector<Fit>& fits) const;
  [[nodiscard]] std::pair<int, std::size_t> phase_of(double place) const;

  const PulseShape& shape_;
  double rate_hz_;
  std::vector<std::complex<float>> rest_;  // of the slot, without what was explained
  std::vector<float> re_, im_;
  std::vector<float> power_;
};

}  // namespace limbwave::decode
