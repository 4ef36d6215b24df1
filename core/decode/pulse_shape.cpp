#include "decode/pulse_shape.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "signal/fir_design.h"

namespace limbwave::decode {
namespace {

constexpr double kPassHz = 5500.0;   // to both sides of the carrier
constexpr double kStopHz = 14500.0;  // words, and what would fold onto the pulse
constexpr double kAttenuation = 75.0;
constexpr double kTail = 0.01;  // templates end where the pulse has fallen to this

}  // namespace

DrivenEnvelope::DrivenEnvelope(const RangingFormat& format, double step_s) : step_(step_s) {
  const double a = kPi * format.pulse_hz / format.transducer_q;
  const double b = 2.0 * kPi * format.microphone_bandwidth_hz;
  const double burst = format.pulse_cycles / format.pulse_hz;
  const double end = burst + 12.0 / std::min(a, b);
  double x = 0.0;
  double y = 0.0;
  double highest = 0.0;
  for (double t = 0.0; t < end; t += step_) {
    values_.push_back(y);
    highest = std::max(highest, y);
    // The drive ends within a step: in proportion, so that the end is not rounded to the raster.
    const double drive = std::clamp((burst - t) / step_, 0.0, 1.0);
    const auto dx = [&](double x_) { return a * (drive - x_); };
    const auto dy = [&](double x_, double y_) { return b * (x_ - y_); };
    const double x1 = dx(x);
    const double y1 = dy(x, y);
    const double x2 = dx(x + 0.5 * step_ * x1);
    const double y2 = dy(x + 0.5 * step_ * x1, y + 0.5 * step_ * y1);
    const double x3 = dx(x + 0.5 * step_ * x2);
    const double y3 = dy(x + 0.5 * step_ * x2, y + 0.5 * step_ * y2);
    const double x4 = dx(x + step_ * x3);
    const double y4 = dy(x + step_ * x3, y + step_ * y3);
    x += step_ / 6.0 * (x1 + 2.0 * x2 + 2.0 * x3 + x4);
    y += step_ / 6.0 * (y1 + 2.0 * y2 + 2.0 * y3 + y4);
  }
  for (double& value : values_) {
    value /= highest;
  }
}

double DrivenEnvelope::at(double t) const {
  const double place = t / step_;
  if (place < 0.0 || place + 1.0 >= static_cast<double>(values_.size())) {
    return 0.0;
  }
  const auto i = static_cast<std::size_t>(place);
  const double u = place - static_cast<double>(i);
  return values_[i] + u * (values_[i + 1] - values_[i]);
}

double DrivenEnvelope::end() const {
  std::size_t last = values_.size();
  while (last > 1 && values_[last - 1] < kTail) {
    --last;
  }
  return static_cast<double>(last) * step_;
}

double DrivenEnvelope::centroid() const {
  double weight = 0.0;
  double moment = 0.0;
  for (std::size_t i = 0; i < values_.size(); ++i) {
    weight += values_[i] * values_[i];
    moment += values_[i] * values_[i] * static_cast<double>(i) * step_;
  }
  return moment / weight;
}

BasebandPlan::BasebandPlan(const RangingFormat& format, SampleRate rate) {
  step = std::max(1, static_cast<int>(std::floor(rate.hz / (kPassHz + kStopHz))));
  rate_hz = rate.hz / step;
  const std::size_t taps = signal::kaiser_taps((kStopHz - kPassHz) / rate.hz, kAttenuation) | 1U;
  half = taps / 2;
  low_pass = signal::low_pass(taps, 0.5 * (kPassHz + kStopHz) / rate.hz, kAttenuation);
  const std::size_t padded = (taps + signal::kDotMultiple - 1) / signal::kDotMultiple * signal::kDotMultiple;
  taps_re.assign(padded, 0.0F);
  taps_im.assign(padded, 0.0F);
  for (std::size_t k = 0; k < taps; ++k) {
    // Relative to the middle; the carrier's phase there is turned back value by value.
    const double angle = -2.0 * kPi * format.pulse_hz / rate.hz * (static_cast<double>(k) - static_cast<double>(half));
    taps_re[k] = static_cast<float>(low_pass[k] * std::cos(angle));
    taps_im[k] = static_cast<float>(low_pass[k] * std::sin(angle));
    noise_gain += low_pass[k] * low_pass[k];
  }
}

PulseShape::PulseShape(const RangingFormat& format, const BasebandPlan& plan, SampleRate rate) {
  const double value_s = 1.0 / plan.rate_hz;
  const DrivenEnvelope envelope(format, 0.25e-6);
  const double reach_s = static_cast<double>(plan.half) / rate.hz;
  lead_ = static_cast<std::size_t>(std::floor(0.6 * reach_s / value_s));
  length_ = lead_ + static_cast<std::size_t>(std::ceil(envelope.end() / value_s)) + 1;
  length_ = (length_ + signal::kDotMultiple - 1) / signal::kDotMultiple * signal::kDotMultiple;
  // One more raster step at both ends, for the derivative. A real carrier has half its amplitude about each frequency.
  const auto value = [&](std::size_t i, double phase) {
    const double t = (static_cast<double>(i) - static_cast<double>(lead_) - phase / kPhases) * value_s;
    double sum = 0.0;
    for (std::size_t k = 0; k < plan.low_pass.size(); ++k) {
      sum += plan.low_pass[k] * envelope.at(t + (static_cast<double>(plan.half) - static_cast<double>(k)) / rate.hz);
    }
    return 0.5 * sum;
  };
  shape_.resize(kPhases * length_);
  slope_.resize(kPhases * length_);
  bend_.resize(kPhases * length_);
  for (int phase = 0; phase < kPhases; ++phase) {
    for (std::size_t i = 0; i < length_; ++i) {
      const std::size_t at = static_cast<std::size_t>(phase) * length_ + i;
      shape_[at] = static_cast<float>(value(i, phase));
      slope_[at] = static_cast<float>((value(i, phase + 1.0) - value(i, phase - 1.0)) * (0.5 * kPhases));
    }
  }
  constexpr double kBendStep = kPhases / 8.0;
  for (int phase = 0; phase < kPhases; ++phase) {
    const std::size_t at = static_cast<std::size_t>(phase) * length_;
    Eigen::VectorXd bend(static_cast<Eigen::Index>(length_));
    for (std::size_t i = 0; i < length_; ++i) {
      bend[static_cast<Eigen::Index>(i)] =
          value(i, phase + kBendStep) + value(i, phase - kBendStep) - 2.0 * static_cast<double>(shape_[at + i]);
    }
    const auto table = [&](const std::vector<float>& values) {
      return Eigen::Map<const Eigen::VectorXf>(values.data() + at, bend.size()).cast<double>().eval();
    };
    const Eigen::VectorXd g = table(shape_).normalized();
    Eigen::VectorXd d = table(slope_);
    d = (d - g.dot(d) * g).normalized();
    bend -= g.dot(bend) * g + d.dot(bend) * d;
    bend.normalize();
    std::copy_n(bend.cast<float>().eval().data(), length_, bend_.data() + at);
  }
  double cross = 0.0;
  for (std::size_t i = 0; i < length_; ++i) {
    energy_ += static_cast<double>(shape_[i]) * shape_[i];
    slope_energy_ += static_cast<double>(slope_[i]) * slope_[i];
    cross += static_cast<double>(shape_[i]) * slope_[i];
  }
  for (std::size_t i = 0; i < length_; ++i) {
    middle_ += static_cast<double>(shape_[i]) * shape_[i] * static_cast<double>(i) / energy_;
  }
  for (std::size_t i = 0; i < length_; ++i) {
    const double off = static_cast<double>(i) - middle_;
    spread_ += static_cast<double>(shape_[i]) * shape_[i] * off * off;
  }
  slope_energy_ -= cross * cross / energy_;
  centroid_s_ = envelope.centroid();
}

}  // namespace limbwave::decode
