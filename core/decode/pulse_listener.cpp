#include "decode/pulse_listener.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "signal/fir_design.h"

namespace limbwave::decode {
namespace {

constexpr double kNoiseMemory = 1.0 / 24.0;  // of a slot

}  // namespace

PulseListener::PulseListener(const RangingFormat& format, SampleRate rate, const RangingParameters& parameters,
                             std::shared_ptr<const PulseShape> shape)
    : format_(format),
      rate_(rate),
      parameters_(parameters),
      plan_(format, rate),
      shape_(shape ? std::move(shape) : std::make_shared<const PulseShape>(format, plan_, rate)),
      finder_(*shape_, plan_),
      paper_(parameters.method == RangingMethod::kPaper ? std::make_unique<SteepestPoint>(format, rate) : nullptr) {
  for (const RangingSource& source : format_.sources) {
    longest_reach_ = std::max(longest_reach_, source.reach);
  }
  // What lies before the first sample is silence.
  const std::size_t before = std::max(plan_.taps_re.size(), paper_ ? paper_->margin() : 0) + 64;
  samples_.assign(before, 0.0F);
  samples_start_ = -static_cast<std::int64_t>(before);
  next_value_ = -static_cast<std::int64_t>(lead_values());
  values_start_ = next_value_;
}

void PulseListener::filter() {
  const auto half = static_cast<std::int64_t>(plan_.half);
  const auto taps = static_cast<std::int64_t>(plan_.taps_re.size());
  while (next_value_ * plan_.step - half + taps <= end()) {
    const float* x = samples_.data() + (next_value_ * plan_.step - half - samples_start_);
    const signal::DotPair sum = signal::dot_pair(x, plan_.taps_re.data(), plan_.taps_im.data(), plan_.taps_re.size());
    values_.emplace_back(sum.first, sum.second);
    ++next_value_;
  }
}

void PulseListener::advance() {
  filter();
  const std::int64_t margin = paper_ ? static_cast<std::int64_t>(paper_->margin()) : 0;
  while (true) {
    const std::int64_t first = slot_ * format_.slot_samples;
    const std::int64_t last = first + format_.slot_samples;
    if (next_value_ * plan_.step < last || (paper_ && end() < last + margin)) {
      break;
    }
    one_slot(first);
    ++slot_;
  }
  // Samples and values behind the present slot are done with.
  const std::int64_t first = slot_ * format_.slot_samples;
  const std::int64_t keep_sample =
      std::min(first - margin - 16, next_value_ * plan_.step - static_cast<std::int64_t>(plan_.taps_re.size()));
  if (keep_sample - samples_start_ > 16384) {
    samples_.erase(samples_.begin(), samples_.begin() + (keep_sample - samples_start_));
    samples_start_ = keep_sample;
  }
  const std::int64_t keep_value = first / plan_.step - static_cast<std::int64_t>(lead_values()) - 2;
  if (keep_value - values_start_ > 2048) {
    values_.erase(values_.begin(), values_.begin() + (keep_value - values_start_));
    values_start_ = keep_value;
  }
  std::erase_if(missing_, [&](const auto& gap) { return gap.second < first - format_.slot_samples; });
}

void PulseListener::measure_noise() {
  powers_.clear();
  for (const std::complex<float>& value : window_) {
    powers_.push_back(std::norm(value));
  }
  const auto quarter = powers_.begin() + static_cast<std::ptrdiff_t>(powers_.size() / 4);
  std::nth_element(powers_.begin(), quarter, powers_.end());
  noise_now_ = std::max(static_cast<double>(*quarter) / 0.2877, 1e-14);
  noise_ = noise_ < 0.0 ? noise_now_ : noise_ + kNoiseMemory * (noise_now_ - noise_);
}

// The values about the slot, their carrier counted from its first sample.
double PulseListener::cut_window(std::int64_t first) {
  const auto lead = static_cast<std::int64_t>(lead_values());
  const std::int64_t begin = static_cast<std::int64_t>(std::floor(static_cast<double>(first) / plan_.step)) - lead;
  const std::int64_t count = format_.slot_samples / plan_.step + lead;
  window_.clear();
  const double turn = -2.0 * kPi * format_.pulse_hz / rate_.hz;
  std::complex<double> carrier = std::polar(1.0, turn * static_cast<double>(begin * plan_.step - first));
  const std::complex<double> step = std::polar(1.0, turn * plan_.step);
  for (std::int64_t n = begin; n < begin + count; ++n) {
    const std::complex<float>& value = values_[static_cast<std::size_t>(n - values_start_)];
    const std::complex<double> turned = carrier * std::complex<double>(value.real(), value.imag());
    window_.emplace_back(static_cast<float>(turned.real()), static_cast<float>(turned.imag()));
    carrier *= step;
  }
  return static_cast<double>(begin * plan_.step - first) / rate_.hz;
}

void PulseListener::one_slot(std::int64_t first) {
  if (format_.sources.empty()) {
    return;
  }
  HeardSlot heard;
  heard.slot = slot_;
  heard.source = static_cast<int>(slot_ % static_cast<std::int64_t>(format_.sources.size()));
  const RangingSource& source = format_.sources[static_cast<std::size_t>(heard.source)];
  const std::int64_t reach = format_.slot_samples + static_cast<std::int64_t>(plan_.taps_re.size());
  heard.cut = std::any_of(missing_.begin(), missing_.end(), [&](const auto& gap) {
    return gap.first < first + reach && gap.second > first - static_cast<std::int64_t>(plan_.taps_re.size());
  });
  if (!heard.cut) {
    const double first_value_s = cut_window(first);
    measure_noise();
    heard.noise = noise_;
    heard.noise_now = noise_now_;
    if (paper_) {
      const std::size_t margin = paper_->margin();
      const std::size_t at = static_cast<std::size_t>(first - static_cast<std::int64_t>(margin) - samples_start_);
      heard.steepest = paper_->find(
          std::span<const float>(samples_).subspan(at, static_cast<std::size_t>(format_.slot_samples) + 2 * margin));
    } else {
      const FoundPulse found = finder_.find(window_, first_value_s - source.delay_s,
                                            std::min(longest_reach_, source.reach) / format_.speed_of_sound + 0.2e-3,
                                            std::max(noise_, 0.25 * noise_now_), parameters_.detection);
      heard.count = std::min(found.arrivals.size(), HeardSlot::kMost);
      std::copy_n(found.arrivals.begin(), heard.count, heard.arrivals.begin());
    }
  }
  heard_.push_back(heard);
}

void PulseListener::push(const float* samples, std::size_t count, std::size_t stride) {
  while (count > 0) {
    const std::size_t part = std::min<std::size_t>(count, 4096);
    const std::size_t old = samples_.size();
    samples_.resize(old + part);
    for (std::size_t i = 0; i < part; ++i) {
      const float sample = samples[i * stride];
      samples_[old + i] = std::isfinite(sample) ? sample : 0.0F;
    }
    samples += part * stride;
    count -= part;
    advance();
  }
}

void PulseListener::gap(SampleCount count) {
  if (count.value <= 0) {
    return;
  }
  missing_.emplace_back(end(), end() + count.value);
  const std::vector<float> silence(4096, 0.0F);
  for (std::int64_t left = count.value; left > 0; left -= 4096) {
    push(silence.data(), static_cast<std::size_t>(std::min<std::int64_t>(left, 4096)), 1);
  }
}

void PulseListener::finish() {
  const std::int64_t last = end();
  const std::vector<float> silence(static_cast<std::size_t>(format_.slot_samples) + 1024, 0.0F);
  push(silence.data(), silence.size(), 1);
  std::erase_if(heard_, [&](const HeardSlot& heard) { return heard.slot * format_.slot_samples >= last; });
  slot_ = std::min(slot_, (last + format_.slot_samples - 1) / format_.slot_samples);
}

std::vector<HeardSlot> PulseListener::take() {
  std::vector<HeardSlot> heard;
  std::swap(heard, heard_);
  return heard;
}

}  // namespace limbwave::decode
