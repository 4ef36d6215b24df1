#include "simulate/electronics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>

#include "base/units.h"

namespace limbwave::simulate {
namespace {

constexpr int kOversampling = 4;
constexpr double kHumHz = 50.0;
constexpr double kKnobSeconds = 0.05;

// Modified Bessel function of the first kind, order 0.
double bessel_i0(double x) {
  double sum = 1.0;
  double term = 1.0;
  for (int k = 1; k < 60; ++k) {
    term *= (x / (2.0 * k)) * (x / (2.0 * k));
    sum += term;
  }
  return sum;
}

// Windowed sinc with the usual edges of audio converters: passes to 0.4535 of the rate, 80 dB down from 0.5465 of it.
// Taps 0..half, at kOversampling times the rate.
std::vector<double> anti_alias_filter() {
  constexpr double cutoff = 0.5 / kOversampling;
  constexpr double transition = (0.5465 - 0.4535) / kOversampling;
  constexpr double beta = 7.857;  // Kaiser's, for 80 dB
  const int half = static_cast<int>(std::ceil((80.0 - 7.95) / (14.36 * transition) / 2.0));
  std::vector<double> taps;
  double sum = 0.0;
  for (int n = 0; n <= half; ++n) {
    const double x = 2.0 * kPi * cutoff * n;
    const double u = static_cast<double>(n) / half;
    const double window = bessel_i0(beta * std::sqrt(1.0 - u * u)) / bessel_i0(beta);
    taps.push_back((n == 0 ? 2.0 * cutoff : 2.0 * cutoff * std::sin(x) / x) * window);
    sum += (n == 0 ? 1.0 : 2.0) * taps.back();
  }
  for (double& tap : taps) {
    tap /= sum;
  }
  return taps;
}

// Largest voltage of the larger channel after the high pass, away from the card's zero: the counter's square wave,
// which the high pass tilts so that its edges stand out further, with its overshoot.
double nominal_peak(const body::LineInSignal& board, const LineInErrors& errors) {
  const double half_cycle = 0.5 / board.cycle_rate_hz;
  const double tilt = 2.0 / (1.0 + std::exp(-2.0 * kPi * errors.coupling_hz * half_cycle));
  double overshoot = 0.0;
  if (errors.ringing > 0.0) {  // the first maximum of exp(−t/d) sin(ωt)
    const double w = 2.0 * kPi * errors.ringing_hz;
    const double wd = w * errors.ringing_decay_s;
    overshoot = errors.ringing * std::exp(-std::atan(wd) / wd) * wd / std::sqrt(1.0 + wd * wd);
  }
  const double right = board.supply_volts * (0.5 * tilt + overshoot);
  // The reference slot stands off the sensors' zero in every cycle, a sensor at the end of its range now and then.
  const double left = std::max(std::abs(board.reference_volts - board.zero_g_volts), board.volts_per_g * board.range_g);
  return std::max(left, right);
}

}  // namespace

LineInStream::LineInStream(const body::LineInSignal& board, const LineInErrors& errors,
                           const acquire::StreamFormat& format, std::uint64_t seed, SlotVoltages& voltages)
    : format_(format),
      errors_(errors),
      oversampling_(errors.anti_alias ? kOversampling : 1),
      filter_(errors.anti_alias ? anti_alias_filter() : std::vector<double>{}),
      line_(board, errors, seed, voltages, format.rate.hz * oversampling_,
            filter_.empty() ? 0 : -static_cast<std::int64_t>(filter_.size()) + 1),
      noise_random_(seed, "noise"),
      dither_random_(seed, "dither"),
      samples_per_volt_(errors.gain / nominal_peak(board, errors)),
      noise_rms_(errors.noise_db > -300.0 ? std::pow(10.0, errors.noise_db / 20.0) : 0.0),
      drop_every_(errors.drop_frames > 0 ? std::llround(errors.drop_every_s * format.rate.hz) : 0) {
  assert(format.channels == 2);
  hum_phase_ = Random(seed, "hum").uniform(0.0, 2.0 * kPi);
  if (!filter_.empty()) {
    history_.resize(2 * filter_.size() - 1);
    for (std::size_t i = static_cast<std::size_t>(kOversampling); i < history_.size(); ++i) {
      history_[i] = line_.next();
    }
  }
}

double LineInStream::real_time(double frame) const {
  const double lost =
      drop_every_ > 0 ? std::floor(frame / static_cast<double>(drop_every_)) * static_cast<double>(errors_.drop_frames)
                      : 0.0;
  return (frame + lost) / format_.rate.hz;
}

double LineInStream::frame_at(double real_time_s) const {
  const double real = real_time_s * format_.rate.hz;
  if (drop_every_ == 0) {
    return real;
  }
  const auto kept = static_cast<double>(drop_every_);
  const double period = kept + static_cast<double>(errors_.drop_frames);
  const double rounds = std::floor(real / period);
  const double rest = real - rounds * period;
  return rest < kept ? rounds * kept + rest : -1.0;
}

// One sample of both channels, volts.
AnalogLine::Pair LineInStream::sampled() {
  if (filter_.empty()) {
    return line_.next();
  }
  const std::size_t length = history_.size();
  for (int i = 0; i < kOversampling; ++i) {
    history_[oldest_] = line_.next();
    oldest_ = oldest_ + 1 == length ? 0 : oldest_ + 1;
  }
  const std::size_t half = filter_.size() - 1;
  std::size_t before = (oldest_ + half) % length;
  std::size_t after = before;
  AnalogLine::Pair sum{filter_[0] * history_[before].left, filter_[0] * history_[before].right};
  for (std::size_t n = 1; n <= half; ++n) {
    before = before == 0 ? length - 1 : before - 1;
    after = after + 1 == length ? 0 : after + 1;
    sum.left += filter_[n] * (history_[before].left + history_[after].left);
    sum.right += filter_[n] * (history_[before].right + history_[after].right);
  }
  return sum;
}

void LineInStream::store(double value, std::byte* out) {
  if (format_.type == acquire::SampleType::kFloat32) {
    const auto sample = static_cast<float>(std::clamp(value, -1.0, 1.0));
    std::memcpy(out, &sample, sizeof sample);
    return;
  }
  const auto bytes = acquire::bytes_per_sample(format_.type);
  const double full = std::ldexp(1.0, static_cast<int>(8 * bytes) - 1);
  double steps = value * full;
  if (errors_.dither) {
    steps += dither_random_.uniform() - dither_random_.uniform();
  }
  const auto sample = static_cast<std::int32_t>(std::clamp(std::nearbyint(steps), -full, full - 1.0));
  for (std::size_t i = 0; i < bytes; ++i) {  // little-endian
    out[i] = static_cast<std::byte>((static_cast<std::uint32_t>(sample) >> (8U * i)) & 0xFFU);
  }
}

void LineInStream::read(std::span<std::byte> out) {
  const std::size_t frame_bytes = format_.bytes_per_frame();
  for (std::size_t at = 0; at + frame_bytes <= out.size(); at += frame_bytes) {
    if (drop_every_ > 0 && frame_ > 0 && frame_ % drop_every_ == 0) {
      for (std::int64_t i = 0; i < errors_.drop_frames; ++i) {
        sampled();
      }
    }
    auto [left, right] = sampled();
    const double t = static_cast<double>(frame_) / format_.rate.hz;
    double factor = samples_per_volt_;
    if (errors_.knob_time_s >= 0.0 && t >= errors_.knob_time_s) {
      const double turned = std::min((t - errors_.knob_time_s) / kKnobSeconds, 1.0);
      factor *= 1.0 + (errors_.knob_factor - 1.0) * turned;
    }
    if (errors_.silence_time_s >= 0.0 && t >= errors_.silence_time_s &&
        t < errors_.silence_time_s + errors_.silence_duration_s) {
      factor = 0.0;
    }
    left *= errors_.left_inverted ? -factor : factor;
    right *= errors_.right_inverted ? -factor : factor;
    if (errors_.hum > 0.0) {
      const double hum = errors_.hum * std::sin(2.0 * kPi * kHumHz * t + hum_phase_);
      left += hum;
      right += hum;
    }
    if (noise_rms_ > 0.0) {
      left += noise_rms_ * noise_random_.normal();
      right += noise_rms_ * noise_random_.normal();
    }
    if (errors_.swapped) {
      std::swap(left, right);
    }
    store(left, out.data() + at);
    store(right, out.data() + at + frame_bytes / 2);
    ++frame_;
  }
}

}  // namespace limbwave::simulate
