/// The envelope of a pulse after this decoder's own band pass, for any delay.
#pragma once

#include <cstddef>
#include <vector>

#include "base/time.h"
#include "decode/ranging_format.h"

namespace limbwave::decode {

/// The envelope that a microphone hears of a driven transducer: one pole each, integrated in small steps (Runge–Kutta).
class DrivenEnvelope {
 public:
  DrivenEnvelope(const RangingFormat& format, double step_s);
  [[nodiscard]] double at(double t) const;  ///< Seconds since the drive began; the peak is 1.
  [[nodiscard]] double end() const;         ///< It is below 1 % from then on, seconds.
  [[nodiscard]] double centroid() const;    ///< Mean instant of its energy, seconds.

 private:
  double step_;
  std::vector<double> values_;
};

/// From samples to complex values about the carrier: value n is the signal times e^(-i 2 pi f t), low-passed, at sample
/// n · step; t counts from sample 0. The delay of the filter is taken off.
struct BasebandPlan {
  BasebandPlan(const RangingFormat& format, SampleRate rate);
  int step = 7;                         ///< Samples per value.
  std::size_t half = 0;                 ///< Taps reach this far to both sides.
  std::vector<float> taps_re, taps_im;  ///< Padded; for the samples n·step − half ...
  std::vector<double> low_pass;         ///< 2 · half + 1 taps.
  double rate_hz = 0.0;                 ///< Of values.
  double noise_gain = 0.0;              ///< Power of a value per power of white noise in a sample.
};

/// Templates on a fine raster of delays.
class PulseShape {
 public:
  static constexpr int kPhases = 128;
  PulseShape(const RangingFormat& format, const BasebandPlan& plan, SampleRate rate);

  [[nodiscard]] std::size_t length() const { return length_; }  ///< Values.
  /// Values lead() before the first that the pulse reaches are part of the template.
  [[nodiscard]] std::size_t lead() const { return lead_; }
  /// Envelope of a pulse of amplitude 1 that begins at value lead() + phase / kPhases; `length` values.
  [[nodiscard]] const float* shape(int phase) const {
    return shape_.data() + static_cast<std::size_t>(phase) * length_;
  }
  /// Its derivative by the delay, per value.
  [[nodiscard]] const float* slope(int phase) const {
    return slope_.data() + static_cast<std::size_t>(phase) * length_;
  }
  /// What its second derivative has that neither shape nor slope have, of energy 1: what an echo shortly after leaves
  /// beside the best fit.
  [[nodiscard]] const float* bend(int phase) const { return bend_.data() + static_cast<std::size_t>(phase) * length_; }
  /// Middle of the shape's energy since its first value, of phase 0, values.
  [[nodiscard]] double middle() const { return middle_; }
  /// Sum of shape² (place − middle)².
  [[nodiscard]] double spread() const { return spread_; }
  [[nodiscard]] double energy() const { return energy_; }              ///< Sum of shape².
  [[nodiscard]] double slope_energy() const { return slope_energy_; }  ///< Of what is orthogonal to the shape.
  [[nodiscard]] double centroid_s() const { return centroid_s_; }      ///< Mean instant of the energy since the start.

 private:
  std::size_t length_ = 0, lead_ = 0;
  std::vector<float> shape_, slope_, bend_;
  double energy_ = 0.0, slope_energy_ = 0.0, centroid_s_ = 0.0;
  double middle_ = 0.0, spread_ = 0.0;
};

}  // namespace limbwave::decode
