#include "simulate/curve.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "base/units.h"

namespace limbwave::simulate {
namespace {

// Index reflected into 0..n−1 about the ends, and whether an odd number of reflections happened on each side.
double reflected(const std::vector<double>& x, std::ptrdiff_t i) {
  const auto n = static_cast<std::ptrdiff_t>(x.size());
  double offset = 0.0;
  double sign = 1.0;
  while (i < 0 || i >= n) {
    const double end = i < 0 ? x.front() : x.back();
    i = i < 0 ? -i : 2 * (n - 1) - i;
    offset += sign * 2.0 * end;
    sign = -sign;
  }
  return offset + sign * x[static_cast<std::size_t>(i)];
}

// Discrete-time Fourier transform of the quintic B-spline at the integers, w in radians per sample.
double quintic_response(double w) {
  return (66.0 + 52.0 * std::cos(w) + 2.0 * std::cos(2.0 * w)) / 120.0;
}

// Taps 0..half of the symmetric filter from samples to spline coefficients: low pass over spline response. The response
// is integrated over frequency with the trapezoidal rule, which converges fast for a smooth periodic function.
std::vector<double> coefficient_filter(double pass, std::ptrdiff_t half) {
  const int steps = 4096;
  std::vector<double> taps(static_cast<std::size_t>(half) + 1, 0.0);
  for (int k = 0; k <= steps; ++k) {
    const double w = kPi * k / steps;
    const double low_pass = 1.0 - smooth_step((w - pass) / pass).v;
    const double weight = (k == 0 || k == steps ? 0.5 : 1.0) / steps * low_pass / quintic_response(w);
    if (weight == 0.0) {
      break;
    }
    for (std::ptrdiff_t n = 0; n <= half; ++n) {
      taps[static_cast<std::size_t>(n)] += weight * std::cos(w * static_cast<double>(n));
    }
  }
  double sum = taps[0];
  for (std::size_t n = 1; n < taps.size(); ++n) {
    sum += 2.0 * taps[n];
  }
  for (double& tap : taps) {
    tap /= sum;  // what was cut off at the ends must not change a constant
  }
  return taps;
}

}  // namespace

Curve& Curve::key(double time_s, double value) {
  assert(keys_.empty() || time_s >= keys_.back().time);
  keys_.push_back({time_s, value});
  return *this;
}

Curve& Curve::oscillate(double start_s, double end_s, double fade_s, double frequency_hz, double amplitude,
                        double phase) {
  oscillations_.push_back({start_s, end_s, fade_s, frequency_hz, amplitude, phase});
  return *this;
}

Jet Curve::at(double time_s) const {
  Jet sum;
  if (!keys_.empty()) {
    const auto next =
        std::upper_bound(keys_.begin(), keys_.end(), time_s, [](double t, const Key& key) { return t < key.time; });
    if (next == keys_.begin()) {
      sum.v = next->value;
    } else if (next == keys_.end()) {
      sum.v = keys_.back().value;
    } else {
      const Key& a = *(next - 1);
      sum = (next->value - a.value) * smooth_step(time_s, a.time, next->time - a.time);
      sum.v += a.value;
    }
  }
  for (const Oscillation& o : oscillations_) {
    if (time_s > o.start && time_s < o.end) {
      const double w = 2.0 * kPi * o.frequency;
      const Jet fade_in = smooth_step(time_s, o.start, o.fade);
      const Jet fade_out = smooth_step(o.end - time_s, 0.0, o.fade);
      const Jet fade = fade_in * Jet{fade_out.v, -fade_out.d, fade_out.dd};
      sum = sum + o.amplitude * (fade * sin(Jet{w * (time_s - o.start) + o.phase, w, 0.0}));
    }
  }
  return sum;
}

double Curve::end() const {
  double end = keys_.empty() ? 0.0 : keys_.back().time;
  for (const Oscillation& o : oscillations_) {
    end = std::max(end, o.end);
  }
  return end;
}

SampledCurve::SampledCurve(const std::vector<double>& samples, double rate_hz, double pass_hz) : rate_(rate_hz) {
  assert(samples.size() >= 2 && rate_hz > 0.0);
  const double pass = std::min(2.0 * kPi * pass_hz / rate_hz, 0.5 * kPi);
  const auto half = static_cast<std::ptrdiff_t>(std::ceil(16.0 / pass * 2.0));
  const std::vector<double> taps = coefficient_filter(pass, half);
  coefficients_.resize(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto at = static_cast<std::ptrdiff_t>(i);
    double sum = taps[0] * samples[i];
    for (std::ptrdiff_t n = 1; n <= half; ++n) {
      sum += taps[static_cast<std::size_t>(n)] * (reflected(samples, at - n) + reflected(samples, at + n));
    }
    coefficients_[i] = sum;
  }
}

Jet SampledCurve::at(double time_s) const {
  const double x = time_s * rate_;
  const auto base = static_cast<std::ptrdiff_t>(std::floor(x));
  const double u = x - static_cast<double>(base);
  // Pieces of the quintic B-spline for the six coefficients base−2 .. base+3: u and 1 − u mirror each other.
  const auto pieces = [](double a) {
    // (3−y)^5 − 6(2−y)^5 + 15(1−y)^5 by distance y = 2 + a, 1 + a, a, each over 120, with two derivatives.
    std::array<std::array<double, 3>, 3> p{};
    for (int k = 0; k < 3; ++k) {
      const double y = a + k;
      const auto add = [&](double c, double z) {
        if (z > 0.0) {
          const double z3 = z * z * z;
          p[static_cast<std::size_t>(k)][0] += c * z3 * z * z / 120.0;
          p[static_cast<std::size_t>(k)][1] -= c * z3 * z / 24.0;
          p[static_cast<std::size_t>(k)][2] += c * z3 / 6.0;
        }
      };
      add(1.0, 3.0 - y);
      add(-6.0, 2.0 - y);
      add(15.0, 1.0 - y);
    }
    return p;
  };
  const auto left = pieces(u);         // coefficients base, base−1, base−2
  const auto right = pieces(1.0 - u);  // coefficients base+1, base+2, base+3
  Jet r;
  for (std::size_t k = 0; k < 3; ++k) {
    const double cl = coefficient(base - static_cast<std::ptrdiff_t>(k));
    const double cr = coefficient(base + 1 + static_cast<std::ptrdiff_t>(k));
    r.v += cl * left[k][0] + cr * right[k][0];
    r.d += (cl * left[k][1] - cr * right[k][1]) * rate_;
    r.dd += (cl * left[k][2] + cr * right[k][2]) * rate_ * rate_;
  }
  return r;
}

double SampledCurve::coefficient(std::ptrdiff_t index) const {
  return reflected(coefficients_, index);
}

}  // namespace limbwave::simulate
