/// A line-in signal made from first principles for tests: pieces of constant or slowly moving voltage, a capacitor
/// solved in closed form, a sampler that averages over its sample, and, where asked for, an oversampled filter chain.
/// Shares nothing with the simulator or the decoder.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

namespace limbwave::test {

struct LineInSignalSpec {
  double rate = 48000.0;
  double seconds = 3.0;
  double cycle_hz = 60.0;
  double clock_offset = 0.0;  // relative
  double clock_wander = 0.0;  // relative RMS, slow
  double slot_jitter = 0.0;   // relative RMS per slot
  double supply_volts = 3.3;
  double reference_volts = 0.33;
  /// Volts of an axis (0..14) at a time in seconds.
  std::function<double(int, double)> volts = [](int axis, double) { return 1.2 + 0.06 * axis; };
  double full_scale_volts = 3.3 / 1.4;                                    // what makes full scale: the gain
  std::function<double(double)> gain = [](double) { return 1.0; };        // knob, after the capacitor, both channels
  std::function<double(double)> left_gain = [](double) { return 1.0; };   // balance
  std::function<double(double)> right_gain = [](double) { return 1.0; };  // balance
  double coupling_hz = 0.0;
  double right_coupling_hz = -1.0;  // negative: as left
  double dc_offset = 0.0;           // of the card, fraction of full scale
  double overshoot = 0.0, ringing_hz = 12000.0;
  bool anti_alias = false;
  double noise = 0.0;  // RMS, fraction of full scale
  double hum = 0.0;    // amplitude on the left at 50 Hz, fraction of full scale
  int bits = 0;        // 0: floats
  bool left_inverted = false, right_inverted = false, swapped = false;
  std::uint64_t seed = 1;
};

struct LineInSignal {
  std::vector<float> interleaved;
  std::vector<double> cycle_starts;  // samples
};

namespace detail {

/// Averages over cells of 1 / (rate · over) seconds of a channel that is piecewise constant between `edges`.
/// value(piece, time) is in fractions of full scale.
inline std::vector<double> average(const std::vector<double>& edges,
                                   const std::function<double(std::size_t, double)>& value, double cell_rate,
                                   std::size_t cells, double corner_hz) {
  std::vector<double> out(cells);
  const double k = 2.0 * std::numbers::pi * corner_hz;
  // The capacitor has been at the signal for long: it holds the mean.
  double capacitor = 0.0;
  for (std::size_t i = 0; i < 16; ++i) {
    capacitor += value(i, 0.0) / 16.0;
  }
  std::size_t piece = 0;
  for (std::size_t n = 0; n < cells; ++n) {
    double t = static_cast<double>(n) / cell_rate;
    const double end = static_cast<double>(n + 1) / cell_rate;
    double integral = 0.0;
    while (t < end) {
      while (piece + 1 < edges.size() && edges[piece + 1] <= t) {
        ++piece;
      }
      const double to = piece + 1 < edges.size() ? std::min(end, edges[piece + 1]) : end;
      const double x = value(piece, 0.5 * (t + to));
      if (k > 0.0) {
        const double decay = std::exp(-k * (to - t));
        integral += (x - capacitor) * (1.0 - decay) / k;
        capacitor = x + (capacitor - x) * decay;
      } else {
        integral += x * (to - t);
      }
      t = to;
    }
    out[n] = integral * cell_rate;
  }
  return out;
}

/// Second-order low pass that overshoots, for held inputs.
inline void ring(std::vector<double>& x, double cell_rate, double overshoot, double hz) {
  const double l = std::log(overshoot);
  const double zeta = -l / std::sqrt(std::numbers::pi * std::numbers::pi + l * l);
  const double w0 = 2.0 * std::numbers::pi * hz;
  const double wd = w0 * std::sqrt(1.0 - zeta * zeta);
  const double dt = 1.0 / cell_rate;
  const double decay = std::exp(-zeta * w0 * dt);
  const double c = std::cos(wd * dt);
  const double s = std::sin(wd * dt);
  double position = x.empty() ? 0.0 : x[0];
  double velocity = 0.0;
  for (double& value : x) {
    const double target = value;
    const double d = position - target;
    const double e = (velocity + zeta * w0 * d) / wd;
    position = target + decay * (d * c + e * s);
    velocity = decay * (velocity * c - (w0 * w0 * d + zeta * w0 * velocity) / wd * s);
    value = position;
  }
}

/// Linear-phase low pass at 0.45 of the output rate, 24 output samples on either side, then every `over`-th cell.
inline std::vector<double> decimate(const std::vector<double>& x, std::size_t over, bool filter) {
  const std::size_t count = x.size() / over;
  std::vector<double> out(count);
  std::vector<double> taps;
  const auto half = static_cast<std::ptrdiff_t>(filter ? 24 * over : 0);
  for (std::ptrdiff_t i = -half; filter && i < half + static_cast<std::ptrdiff_t>(over); ++i) {
    const double u = (static_cast<double>(i) + 0.5 - 0.5 * static_cast<double>(over)) / static_cast<double>(over);
    const double a = std::numbers::pi * 0.9 * u;
    const double window = 0.5 + 0.5 * std::cos(std::numbers::pi * u / 25.0);
    taps.push_back((a == 0.0 ? 1.0 : std::sin(a) / a) * window);
  }
  if (!filter) {
    taps.assign(over, 1.0);
  }
  double sum = 0.0;
  for (const double tap : taps) {
    sum += tap;
  }
  for (std::size_t n = 0; n < count; ++n) {
    double y = 0.0;
    for (std::size_t i = 0; i < taps.size(); ++i) {
      auto at = static_cast<std::ptrdiff_t>(n * over + i) - half;
      at = std::clamp<std::ptrdiff_t>(at, 0, static_cast<std::ptrdiff_t>(x.size()) - 1);
      y += taps[i] * x[static_cast<std::size_t>(at)];
    }
    out[n] = y / sum;
  }
  return out;
}

}  // namespace detail

/// Time 0 is half a sample before sample 0: sample n averages [n, n + 1) / rate, its centre is (n + ½) / rate.
inline LineInSignal make_line_in_signal(const LineInSignalSpec& spec) {
  std::mt19937_64 generator(spec.seed);
  std::normal_distribution<double> normal;
  // Slot edges; the first cycle starts in the middle of slot 9.
  std::vector<double> edges{-6.5 / (16.0 * spec.cycle_hz * (1.0 + spec.clock_offset))};
  LineInSignal result;
  double wander = 0.0;
  for (std::int64_t slot = 0; edges.back() < spec.seconds + 0.1; ++slot) {
    wander += -wander / 2000.0 + normal(generator) * std::sqrt(2.0 / 2000.0);
    const double hz = spec.cycle_hz * (1.0 + spec.clock_offset + spec.clock_wander * wander);
    edges.push_back(edges.back() + (1.0 + spec.slot_jitter * normal(generator)) / (16.0 * hz));
    if ((slot + 9) % 16 == 15 && edges.back() >= 0.0 && edges.back() < spec.seconds) {
      result.cycle_starts.push_back(edges.back() * spec.rate - 0.5);
    }
  }
  const bool filtered = spec.anti_alias || spec.overshoot > 0.0;
  const std::size_t over = filtered ? 4 : 1;
  const auto frames = static_cast<std::size_t>(spec.seconds * spec.rate);
  const double cell_rate = spec.rate * static_cast<double>(over);
  const auto slot_of = [](std::size_t piece) { return static_cast<int>((piece + 9) % 16); };
  const auto left_value = [&](std::size_t piece, double t) {
    const int slot = slot_of(piece);
    return (slot == 15 ? spec.reference_volts : spec.volts(slot, t)) / spec.full_scale_volts;
  };
  const auto right_value = [&](std::size_t piece, double) {
    return (slot_of(piece) >= 8 ? spec.supply_volts : 0.0) / spec.full_scale_volts;
  };
  const double right_corner = spec.right_coupling_hz >= 0.0 ? spec.right_coupling_hz : spec.coupling_hz;
  // Without a capacitor the card centres the signals.
  const double left_centre = spec.coupling_hz > 0.0 ? 0.0 : 1.4 / spec.full_scale_volts;
  const double right_centre = right_corner > 0.0 ? 0.0 : 0.5 * spec.supply_volts / spec.full_scale_volts;
  std::array<std::vector<double>, 2> channels{
      detail::average(edges, left_value, cell_rate, frames * over, spec.coupling_hz),
      detail::average(edges, right_value, cell_rate, frames * over, right_corner)};
  result.interleaved.resize(2 * frames);
  for (std::size_t channel = 0; channel < 2; ++channel) {
    std::vector<double>& x = channels[channel];
    if (spec.overshoot > 0.0) {
      detail::ring(x, cell_rate, spec.overshoot, spec.ringing_hz);
    }
    if (filtered) {
      x = detail::decimate(x, over, spec.anti_alias);
    }
    const bool inverted = channel == 0 ? spec.left_inverted : spec.right_inverted;
    for (std::size_t n = 0; n < frames; ++n) {
      const double t = (static_cast<double>(n) + 0.5) / spec.rate;
      double y = x[n] - (channel == 0 ? left_centre : right_centre);
      y *= spec.gain(t) * (channel == 0 ? spec.left_gain(t) : spec.right_gain(t)) * (inverted ? -1.0 : 1.0);
      y += (channel == 0 ? spec.hum * std::sin(100.0 * std::numbers::pi * t) : 0.0) + spec.dc_offset +
           (spec.noise > 0.0 ? spec.noise * normal(generator) : 0.0);
      if (spec.bits > 0) {
        const double steps = std::ldexp(1.0, spec.bits - 1);
        y = std::clamp(std::round(y * steps), -steps, steps - 1.0) / steps;
      }
      result.interleaved[2 * n + (channel == 0) * spec.swapped + (channel == 1) * !spec.swapped] =
          static_cast<float>(y);
    }
  }
  return result;
}

/// What the board really had: volts of an axis relative to the reference at a position in samples.
inline double true_volts(const LineInSignalSpec& spec, int axis, double sample) {
  return axis == 15 ? 0.0 : spec.volts(axis, (sample + 0.5) / spec.rate) - spec.reference_volts;
}

/// The electronics of the "paper" error profile.
inline LineInSignalSpec paper_electronics(double rate, double coupling_hz) {
  LineInSignalSpec spec;
  spec.rate = rate;
  spec.coupling_hz = coupling_hz;
  spec.right_coupling_hz = coupling_hz * 0.93;  // capacitors differ
  spec.clock_offset = 0.03;
  spec.clock_wander = 0.003;
  spec.overshoot = 0.15;
  spec.anti_alias = true;
  spec.noise = 1e-3;
  spec.bits = 16;
  return spec;
}

}  // namespace limbwave::test
