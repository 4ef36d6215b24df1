/// Mains hum on the sensor channel, found in the reference slot and taken out of all slots.
#pragma once

#include <Eigen/Core>
#include <array>

#include "base/time.h"
#include "decode/cycle_measurement.h"

namespace limbwave::decode {

/// The reference voltage stands still, so what its level does from cycle to cycle beyond the coupling is hum, and no
/// motion can be mistaken for it. Sampled once a cycle it does not tell 50 Hz from 10 Hz, but there are only two mains
/// frequencies: sines of each and of its second and third harmonic are fitted to the level's steps from one reference
/// to the next, by least squares over the last second. The mains that explains more is believed, where its sines stand
/// out of what noise makes of them; a mains that is a little off shows as a phase that drifts, and the sines are tuned
/// to it. Hum that keeps the same phase in every cycle (60 Hz on a clock of 60.0 Hz) moves nothing and is not seen;
/// each slot then has a constant offset.
class HumTracker {
 public:
  explicit HumTracker(SampleRate rate) : rate_(rate) {}
  /// Learns from a cycle, then takes what hum is known out of the means of its slots. `kappa` of the data channel;
  /// `usable`: the gain did not move. Flattened levels are then free of hum; integrals still hold it.
  void step(CycleMeasurement& cycle, int slots, double kappa, bool usable);
  /// The next cycle's reference is not comparable with the last one's.
  void unlink() { linked_ = false; }
  /// Amplitude of the sines that are taken out, all together, fraction of full scale; 0 when there is none.
  [[nodiscard]] double amplitude() const;
  /// 50 or 60; 0 when there is no hum.
  [[nodiscard]] double mains_hz() const;

 private:
  static constexpr int kHarmonics = 3;
  static constexpr int kUnknowns = 1 + 2 * kHarmonics;  // a steady drift; cosine and sine of each harmonic
  using Vector = Eigen::Matrix<double, kUnknowns, 1>;
  using Matrix = Eigen::Matrix<double, kUnknowns, kUnknowns>;
  struct Mains {
    double nominal_hz = 50.0;
    double hz = nominal_hz;                // tuned
    double turns = 0.0;                    // phase of the first harmonic at the newest reference, less whole turns
    Vector at_reference = Vector::Zero();  // the waves there
    Matrix normal = Matrix::Zero();
    Vector right = Vector::Zero();
    Vector found = Vector::Zero();  // cosines and sines that stand out; the others are 0
    double explained = 0.0;         // sum of squares
    int strongest = 0;              // harmonic, 0 when none is found
    double phase = 0.0;             // of that one as fitted
    double phase_rate = 0.0;        // of the first, radians per cycle: the tuning is not right yet
  };
  // At some samples from the newest reference.
  [[nodiscard]] Vector waves(const Mains& mains, double samples) const;
  void fit(Mains& mains) const;
  static void follow_phase(Mains& mains, double cycles, double cycle_hz);

  SampleRate rate_;
  std::array<Mains, 2> mains_{Mains{50.0, 50.0}, Mains{60.0, 60.0}};
  int believed_ = -1;
  double weight_ = 0.0, square_ = 0.0;  // fading count and sum of squares of steps
  int since_fit_ = 0;                   // cycles
  bool linked_ = false;
  double level_ = 0.0, instant_ = 0.0;  // of the last reference, as measured
};

}  // namespace limbwave::decode
