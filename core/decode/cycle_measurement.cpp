#include "decode/cycle_measurement.h"

#include <algorithm>
#include <cmath>

namespace limbwave::decode {
namespace {

/// A converter that is overdriven stays at its end, 32751 of 32768 or closer to 1; floats beyond 1 are not clipped, and
/// a single sample there may be just the top of a signal.
constexpr float kFullScale = 0.9995F;
constexpr float kBeyond = 1.0001F;
constexpr int kShortestRun = 3;

bool stays_at_full_scale(const float* samples, int count) {
  int run = 0;
  for (int i = 0; i < count; ++i) {
    run = std::fabs(samples[i]) >= kFullScale ? run + 1 : 0;
    if (run == kShortestRun) {
      return true;
    }
  }
  return false;
}

/// Walks over a channel from window to window and keeps the integral.
class Walk {
 public:
  Walk(const ChannelView& channel, std::int64_t from) : channel_(channel), at_(from) {}

  /// The integral of the reading runs from where the walk began.
  LevelReading read(const SettledWindow& window, std::int64_t from) {
    sum_ += sum_samples(channel_.at(at_), from - at_);
    const WindowSums sums = sum_window(window, channel_.at(from));
    const LevelReading reading{static_cast<double>(from) + window.centre(), sums.mean, sum_ + sums.integral, sums.slope,
                               sums.variance};
    clipped_ =
        sums.largest >= kFullScale && sums.largest <= kBeyond && stays_at_full_scale(channel_.at(from), window.length);
    own_integral_ = sums.integral;
    sum_ += sums.sum;
    at_ = from + window.length;
    return reading;
  }
  /// Integral of the last reading from its own window's first sample.
  [[nodiscard]] double own_integral() const { return own_integral_; }
  /// Whether the last reading's window touched full scale.
  [[nodiscard]] bool clipped() const { return clipped_; }

 private:
  ChannelView channel_;
  std::int64_t at_;
  double sum_ = 0.0;
  double own_integral_ = 0.0;
  bool clipped_ = false;
};

}  // namespace

CycleMeasurement CycleMeter::measure(const CycleBounds& bounds, const ChannelView& data, const ChannelView& counter) {
  CycleMeasurement result;
  result.bounds = bounds;
  result.linked = linked_ && std::fabs(bounds.start - last_end_) < 1e-9;
  const int half_slots = format_.slots / 2;
  const double slot = result.period() / format_.slots;

  // Slots: never the start of a slot, and a third of that at its end, where a linear-phase filter rings ahead.
  const int length = std::max(2, static_cast<int>(std::floor(slot * (1.0 - settle_ * (4.0 / 3.0)))));
  const SettledWindow& window = bank_.get(length);
  result.data_noise_gain = window.noise_gain;
  std::array<std::int64_t, kMaxSlots> from{};
  for (int j = 0; j < format_.slots; ++j) {
    const bool second = j >= half_slots;
    const double edge = second ? bounds.middle : bounds.start;
    const double width = (second ? bounds.end - bounds.middle : bounds.middle - bounds.start) / half_slots;
    const double start = edge + (j - (second ? half_slots : 0)) * width;
    from[static_cast<std::size_t>(j)] = static_cast<std::int64_t>(std::ceil(start + settle_ * width));
  }
  Walk walk(data, result.linked ? data_from_ : from[0]);
  double origin = 0.0;
  if (result.linked) {
    result.previous_reference = reference_;
    origin = reference_.integral;
  }
  for (int j = 0; j < format_.slots; ++j) {
    const auto index = static_cast<std::size_t>(j);
    result.slots[index] = walk.read(window, from[index]);
    if (!result.linked && j == 0) {
      origin = result.slots[0].integral;
    }
    result.slots[index].integral -= origin;
    if (walk.clipped()) {
      result.clipped |= 1U << index;
    }
  }
  result.broken = result.clipped;
  const auto last = static_cast<std::size_t>(format_.slots - 1);

  // The counter's halves: all but half a slot after and a quarter before the edges.
  const int half_length = std::max(2, static_cast<int>(std::floor(slot * (half_slots - 0.75))));
  const SettledWindow& half_window = bank_.get(half_length);
  const auto low_from = static_cast<std::int64_t>(std::ceil(bounds.start + 0.5 * slot));
  const auto high_from = static_cast<std::int64_t>(std::ceil(bounds.middle + 0.5 * slot));
  Walk counter_walk(counter, result.linked ? counter_from_ : low_from);
  result.low = counter_walk.read(half_window, low_from);
  result.counter_clipped = counter_walk.clipped();
  result.high = counter_walk.read(half_window, high_from);
  const double counter_origin = result.linked ? high_.integral : result.low.integral;
  result.low.integral -= counter_origin;
  result.high.integral -= counter_origin;
  result.previous_high = high_;
  result.previous_high.integral = 0.0;
  result.previous_reference.integral = 0.0;
  result.counter_clipped = result.counter_clipped || counter_walk.clipped();

  // For the next cycle: the integral of these two windows from their own start.
  reference_ = result.slots[last];
  reference_.integral = walk.own_integral();
  data_from_ = from[last];
  high_ = result.high;
  high_.integral = counter_walk.own_integral();
  counter_from_ = high_from;
  linked_ = true;
  last_end_ = bounds.end;
  return result;
}

}  // namespace limbwave::decode
