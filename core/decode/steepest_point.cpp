#include "decode/steepest_point.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "decode/pulse_shape.h"
#include "signal/fir_design.h"

namespace limbwave::decode {
namespace {

constexpr double kHalfBandHz = 2500.0;  // 40 ± 2.5 kHz (p)
constexpr double kLowPassHz = 30000.0;  // (p)
constexpr std::size_t kBandTaps = 129;
constexpr std::size_t kLowTaps = 17;
constexpr double kFirst = 0.2;     // of the largest power: what counts as the first rise
constexpr std::size_t kSlope = 8;  // samples to both sides, over which a slope is taken: a carrier cycle is 3.5
constexpr double kOverNoise = 12.0;

signal::SymmetricFir filter(const std::vector<double>& h) {
  return signal::SymmetricFir({h.begin(), h.end()});
}

}  // namespace

SteepestPoint::SteepestPoint(const RangingFormat& format, SampleRate rate)
    : rate_hz_(rate.hz),
      band_(filter(signal::band_pass(kBandTaps, format.pulse_hz / rate.hz, kHalfBandHz / rate.hz, 40.0))),
      low_(filter(signal::low_pass(kLowTaps, std::min(0.45, kLowPassHz / rate.hz), 40.0))),
      margin_(band_.taps() / 2 + low_.taps() / 2) {
  // The offset between a pulse's beginning and its steepest point, from a perfect pulse.
  const std::size_t slot = static_cast<std::size_t>(format.slot_samples);
  const double start_s = 0.3 * static_cast<double>(slot) / rate.hz;
  const DrivenEnvelope envelope(format, 0.25e-6);
  std::vector<float> samples(slot + 2 * margin_);
  for (std::size_t n = 0; n < samples.size(); ++n) {
    const double t = (static_cast<double>(n) - static_cast<double>(margin_)) / rate.hz - start_s;
    samples[n] = static_cast<float>(envelope.at(t) * std::cos(2.0 * kPi * format.pulse_hz * t));
  }
  if (const auto found = steepest(samples)) {
    offset_s_ = found->delay_s - start_s;
  }
}

std::optional<SteepestPoint::Found> SteepestPoint::find(std::span<const float> samples) {
  auto found = steepest(samples);
  if (found) {
    found->delay_s -= offset_s_;
  }
  return found;
}

std::optional<SteepestPoint::Found> SteepestPoint::steepest(std::span<const float> samples) {
  const std::size_t slot = samples.size() - 2 * margin_;
  // Both filters are centred: the results belong to the samples in their middle.
  power_.resize(slot + low_.taps() - 1);
  band_.run(samples.data(), power_.size(), power_.data());
  for (float& power : power_) {
    power *= power;
  }
  envelope_.resize(slot);
  low_.run(power_.data(), slot, envelope_.data());
  sorted_.assign(envelope_.begin(), envelope_.end());
  const auto quarter = sorted_.begin() + static_cast<std::ptrdiff_t>(slot / 4);
  std::nth_element(sorted_.begin(), quarter, sorted_.end());
  Found found;
  found.noise = std::max(0.0, static_cast<double>(*quarter)) / 0.2877;  // the quantile of an exponential distribution
  const float largest = *std::max_element(envelope_.begin(), envelope_.end());
  const double threshold = std::max(kFirst * static_cast<double>(largest), kOverNoise * found.noise);
  std::size_t rise = 0;
  while (rise < slot && envelope_[rise] < threshold) {
    ++rise;
  }
  if (rise + 2 * kSlope >= slot || rise < 2) {
    return std::nullopt;
  }
  std::size_t peak = rise;
  const auto longest = static_cast<std::size_t>(0.35e-3 * rate_hz_);
  for (std::size_t i = rise; i < std::min(slot, rise + longest); ++i) {
    peak = envelope_[i] > envelope_[peak] ? i : peak;
  }
  const auto back = static_cast<std::size_t>(0.2e-3 * rate_hz_);
  std::size_t best = std::max(kSlope + 1, rise > back ? rise - back : 0);
  const auto slope = [&](std::size_t i) { return envelope_[i + kSlope] - envelope_[i - kSlope]; };
  for (std::size_t i = best; i < std::min(peak, slot - kSlope - 1); ++i) {
    best = slope(i) > slope(best) ? i : best;
  }
  double place = static_cast<double>(best);
  if (best > kSlope && best + kSlope + 1 < slot) {
    const double a = slope(best - 1);
    const double b = slope(best);
    const double c = slope(best + 1);
    const double curvature = a - 2.0 * b + c;
    place += curvature < 0.0 ? std::clamp(0.5 * (a - c) / curvature, -0.5, 0.5) : 0.0;
  }
  found.delay_s = place / rate_hz_;
  found.peak = std::sqrt(2.0 * std::max(0.0F, envelope_[peak]));
  return found;
}

}  // namespace limbwave::decode
