#include "simulate/sound_pulse.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace limbwave::simulate {

SoundPulse::SoundPulse(const body::DriverBoxSignal& box)
    : a_(kPi * box.pulse_hz / box.transducer_q),
      b_(2.0 * kPi * box.microphone_bandwidth_hz),
      burst_(box.pulse_cycles / box.pulse_hz),
      omega_(2.0 * kPi * box.pulse_hz) {
  if (std::abs(a_ - b_) < 1e-3 * a_) {
    b_ = a_ * 1.001;  // the closed form needs two different poles
  }
  // The peak lies shortly after the burst's end.
  double highest = 0.0;
  for (int i = 0; i <= 4000; ++i) {
    highest = std::max(highest, envelope(burst_ * (0.5 + i * 5e-4)));
  }
  peak_ = highest;
  length_ = burst_ + 18.0 / std::min(a_, b_);
}

double SoundPulse::step_response(double t) const {
  return t <= 0.0 ? 0.0 : 1.0 - (b_ * std::exp(-a_ * t) - a_ * std::exp(-b_ * t)) / (b_ - a_);
}

double SoundPulse::envelope(double t) const {
  return (step_response(t) - step_response(t - burst_)) / peak_;
}

void SoundPulse::add(float* samples, int count, double start, double step, double rate_of_time, double amplitude,
                     double phase) const {
  const double scale = amplitude / peak_;
  const double dt = step * rate_of_time;
  int n = std::max(0, static_cast<int>(std::ceil(-start / step)));
  double t = (start + n * step) * rate_of_time;
  std::complex<double> carrier = std::polar(1.0, omega_ * t + phase);
  const std::complex<double> turn = std::polar(1.0, omega_ * dt);
  const double fall_a = std::exp(-a_ * dt);
  const double fall_b = std::exp(-b_ * dt);
  double ea = std::exp(-a_ * t) * b_ / (b_ - a_);
  double eb = std::exp(-b_ * t) * a_ / (b_ - a_);
  const double after_a = std::exp(a_ * burst_);
  const double after_b = std::exp(b_ * burst_);
  for (; n < count; ++n, t += dt) {
    const double driven = 1.0 - ea + eb;
    const double value = t < burst_ ? driven : ea * (after_a - 1.0) - eb * (after_b - 1.0);
    samples[n] += static_cast<float>(scale * value * carrier.real());
    carrier *= turn;
    ea *= fall_a;
    eb *= fall_b;
  }
}

}  // namespace limbwave::simulate
