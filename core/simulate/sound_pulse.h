/// The shape of a pulse as a microphone hears it, as continuous time.
#pragma once

#include <complex>

#include "body/rig.h"

namespace limbwave::simulate {

/// Ten cycles drive a resonant transducer; a microphone of finite bandwidth hears it. Both are one pole of the complex
/// envelope, so that the envelope is a sum of three exponentials in each of two stretches.
class SoundPulse {
 public:
  explicit SoundPulse(const body::DriverBoxSignal& box);

  /// Envelope t seconds after the source began, its peak 1.
  [[nodiscard]] double envelope(double t) const;
  /// After this the pulse is gone (less than 1e-7), seconds.
  [[nodiscard]] double length() const { return length_; }

  /// Adds `amplitude` · envelope · cos(2π f t' + phase) to `count` samples; t' = (start + n · step) · rate_of_time.
  /// Samples with t' < 0 are left alone.
  void add(float* samples, int count, double start, double step, double rate_of_time, double amplitude,
           double phase) const;

 private:
  [[nodiscard]] double step_response(double t) const;
  double a_, b_;  // 1/s, the two poles
  double burst_;  // s
  double omega_;  // rad/s
  double peak_ = 1.0;
  double length_ = 0.0;
};

}  // namespace limbwave::simulate
