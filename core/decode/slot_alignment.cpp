#include "decode/slot_alignment.h"

#include <algorithm>
#include <utility>

#include "decode/alignment_kernel.h"

namespace limbwave::decode {
namespace {

constexpr std::size_t kAfter = AlignmentKernel::kAfter;
constexpr std::size_t kBefore = 3;      // of the polynomial
constexpr std::size_t kFewest = 4;      // points that make a value
constexpr double kExtrapolated = 0.05;  // of a cycle: hardly more than none

const AlignmentKernel& kernel(std::size_t after) {
  static const std::array<AlignmentKernel, kAfter + 1> instances{AlignmentKernel(0), AlignmentKernel(1),
                                                                 AlignmentKernel(2)};
  return instances[after];
}

/// The polynomial through `count` points, at x = 0: Lagrange's form, which copes with any spacing.
double interpolate_at_zero(const double* x, const double* values, std::size_t count) {
  double sum = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    double numerator = values[k];
    double denominator = 1.0;
    for (std::size_t l = 0; l < count; ++l) {
      if (l != k) {
        numerator *= x[l];
        denominator *= x[l] - x[k];
      }
    }
    sum += numerator / denominator;
  }
  return sum;
}

bool supports(const LineInCycle& cycle, std::size_t slot) {
  return cycle.valid && ((cycle.clipped | cycle.uncertain) >> slot & 1U) == 0;
}

}  // namespace

void SlotAligner::push(const LineInCycle& cycle) {
  if (cycle.gap_before) {
    finish();
    gap_ = true;
  }
  window_.push_back(cycle);
  while (next_ + kAfter < window_.size()) {
    emit(next_++);
  }
  while (next_ > AlignmentKernel::kBefore) {
    window_.pop_front();
    --next_;
  }
}

void SlotAligner::finish() {
  while (next_ + 1 < window_.size()) {
    emit(next_++);
  }
  window_.clear();
  next_ = kFirst;
}

std::vector<AccelerationFrame> SlotAligner::take_frames() {
  return std::exchange(frames_, {});
}

std::vector<AccelerationFrame> SlotAligner::ahead() const {
  std::vector<AccelerationFrame> frames;
  for (std::size_t index = next_; index < window_.size(); ++index) {
    const LineInCycle& cycle = window_[index];
    const double instant = cycle.start_sample + 0.5 * cycle.period_samples;
    AccelerationFrame frame = empty_frame(instant);
    frame.gap_before = gap_ && index == next_;
    for (std::size_t sensor = 0; sensor < static_cast<std::size_t>(sensors_); ++sensor) {
      bool usable = true;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t slot = 3 * sensor + axis;
        const std::optional<double> volts = by_kernel(index, slot, instant, window_.size() - 1 - index);
        usable = usable && volts.has_value();
        frame.volts[sensor][static_cast<Eigen::Index>(axis)] = volts.value_or(cycle.volts[slot]);
      }
      if (usable) {
        frame.usable |= 1U << sensor;
      }
    }
    frames.push_back(frame);
  }
  return frames;
}

std::optional<double> SlotAligner::by_kernel(std::size_t index, std::size_t slot, double instant,
                                             std::size_t after) const {
  if (index < AlignmentKernel::kBefore || index + after >= window_.size()) {
    return std::nullopt;
  }
  AlignmentKernel::Values instants{};
  AlignmentKernel::Values volts{};
  const double per_sample = 1.0 / window_[index].period_samples;
  bool whole = true;
  for (std::size_t k = 0; k <= AlignmentKernel::kBefore + after; ++k) {
    const LineInCycle& cycle = window_[index + k - AlignmentKernel::kBefore];
    whole = whole && supports(cycle, slot);
    instants[k] = (cycle.sample[slot] - instant) * per_sample;
    volts[k] = cycle.volts[slot];
  }
  return whole ? std::optional(kernel(after).at_zero(instants, volts)) : std::nullopt;
}

SlotAligner::Value SlotAligner::interpolate(std::size_t index, std::size_t slot, double instant) const {
  if (const std::optional<double> volts = by_kernel(index, slot, instant, kAfter)) {
    return {*volts, true};
  }
  // Unbroken support on either side of this cycle; a bad cycle itself is bridged.
  std::array<double, kBefore + 1 + kAfter> x{};
  std::array<double, kBefore + 1 + kAfter> values{};
  std::size_t count = 0;
  const auto add = [&](const LineInCycle& cycle) {
    const bool good = supports(cycle, slot);
    if (good) {
      x[count] = cycle.sample[slot] - instant;
      values[count] = cycle.volts[slot];
      ++count;
    }
    return good;
  };
  add(window_[index]);
  for (std::size_t k = 1; k <= std::min(index, kBefore) && add(window_[index - k]); ++k) {
  }
  for (std::size_t k = index + 1; k < std::min(window_.size(), index + kAfter + 1) && add(window_[k]); ++k) {
  }
  if (count == 0) {
    return {window_[index].volts[slot], false};
  }
  const auto [earliest, latest] = std::minmax_element(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(count));
  const double reach = kExtrapolated * window_[index].period_samples;
  return {interpolate_at_zero(x.data(), values.data(), count),
          count >= kFewest && *earliest <= reach && *latest >= -reach};
}

AccelerationFrame SlotAligner::empty_frame(double instant) const {
  AccelerationFrame frame;
  frame.time_s = instant / rate_.hz;
  return frame;
}

void SlotAligner::emit(std::size_t index) {
  const LineInCycle& cycle = window_[index];
  const double instant = cycle.start_sample + 0.5 * cycle.period_samples;
  AccelerationFrame frame = empty_frame(instant);
  frame.gap_before = std::exchange(gap_, false);
  for (std::size_t sensor = 0; sensor < static_cast<std::size_t>(sensors_); ++sensor) {
    bool usable = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t slot = 3 * sensor + axis;
      const Value value = interpolate(index, slot, instant);
      usable = usable && supports(cycle, slot) && value.supported;
      frame.volts[sensor][static_cast<Eigen::Index>(axis)] = value.volts;
    }
    if (usable) {
      frame.usable |= 1U << sensor;
    }
  }
  frames_.push_back(frame);
}

}  // namespace limbwave::decode
