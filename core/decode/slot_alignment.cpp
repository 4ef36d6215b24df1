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

const AlignmentKernel& kernel() {
  static const AlignmentKernel instance;
  return instance;
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

SlotAligner::Value SlotAligner::interpolate(std::size_t index, std::size_t slot, double instant) const {
  if (index >= AlignmentKernel::kBefore && index + kAfter < window_.size()) {
    AlignmentKernel::Values instants;
    AlignmentKernel::Values volts;
    const double per_sample = 1.0 / window_[index].period_samples;
    bool whole = true;
    for (std::size_t k = 0; k < AlignmentKernel::kTaps; ++k) {
      const LineInCycle& cycle = window_[index + k - AlignmentKernel::kBefore];
      whole = whole && supports(cycle, slot);
      instants[k] = (cycle.sample[slot] - instant) * per_sample;
      volts[k] = cycle.volts[slot];
    }
    if (whole) {
      return {kernel().at_zero(instants, volts), true};
    }
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

void SlotAligner::emit(std::size_t index) {
  const LineInCycle& cycle = window_[index];
  const double instant = cycle.start_sample + 0.5 * cycle.period_samples;
  AccelerationFrame frame;
  frame.time_s = instant / rate_.hz;
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
