#include "decode/slot_alignment.h"

#include <algorithm>
#include <utility>

namespace limbwave::decode {
namespace {

constexpr std::size_t kBefore = 3;
constexpr std::size_t kAfter = 2;

bool supports(const LineInCycle& cycle, std::size_t slot) {
  return cycle.valid && (cycle.clipped >> slot & 1U) == 0;
}

}  // namespace

void SlotAligner::push(const LineInCycle& cycle) {
  if (cycle.gap_before) {
    finish();
  }
  window_.push_back(cycle);
  while (next_ + kAfter < window_.size()) {
    emit(next_++);
  }
  while (next_ > kBefore) {
    window_.pop_front();
    --next_;
  }
}

void SlotAligner::finish() {
  while (next_ < window_.size()) {
    emit(next_++);
  }
  window_.clear();
  next_ = 0;
}

std::vector<AccelerationFrame> SlotAligner::take_frames() {
  return std::exchange(frames_, {});
}

double SlotAligner::interpolate(std::size_t index, std::size_t slot, double instant) const {
  std::array<double, kBefore + 1 + kAfter> times{};
  std::array<double, kBefore + 1 + kAfter> values{};
  std::size_t count = 0;
  const auto add = [&](std::size_t k) {
    times[count] = window_[k].sample[slot];
    values[count] = window_[k].volts[slot];
    ++count;
  };
  if (supports(window_[index], slot)) {
    add(index);
  }
  for (std::size_t k = index; k-- > (index > kBefore ? index - kBefore : 0);) {
    if (!supports(window_[k], slot)) {
      break;
    }
    add(k);
  }
  for (std::size_t k = index + 1; k < std::min(window_.size(), index + kAfter + 1); ++k) {
    if (!supports(window_[k], slot)) {
      break;
    }
    add(k);
  }
  if (count == 0) {
    return window_[index].volts[slot];
  }
  // Neville's scheme: exact instants, no matter how evenly they are spaced.
  for (std::size_t order = 1; order < count; ++order) {
    for (std::size_t k = 0; k + order < count; ++k) {
      const double a = times[k];
      const double b = times[k + order];
      values[k] = ((instant - b) * values[k] + (a - instant) * values[k + 1]) / (a - b);
    }
  }
  return values[0];
}

void SlotAligner::emit(std::size_t index) {
  const LineInCycle& cycle = window_[index];
  const double instant = cycle.start_sample + 0.5 * cycle.period_samples;
  AccelerationFrame frame;
  frame.time_s = instant / rate_.hz;
  frame.gap_before = cycle.gap_before;
  for (std::size_t sensor = 0; sensor < static_cast<std::size_t>(sensors_); ++sensor) {
    bool usable = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t slot = 3 * sensor + axis;
      usable = usable && supports(cycle, slot);
      frame.volts[sensor][static_cast<Eigen::Index>(axis)] = interpolate(index, slot, instant);
    }
    if (usable) {
      frame.usable |= 1U << sensor;
    }
  }
  frames_.push_back(frame);
}

}  // namespace limbwave::decode
