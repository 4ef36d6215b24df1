/// The newest samples of both channels, and what can be told of them on the way in.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "base/time.h"
#include "decode/counter_edges.h"

namespace limbwave::decode {

/// Largest magnitude of the last second, from peaks of tenths of a second on a grid fixed to the take.
class PeakMeter {
 public:
  explicit PeakMeter(SampleRate rate) : length_(static_cast<std::int64_t>(rate.hz / 10.0) + 1) {}
  /// Samples from `position` on that lie in the same tenth.
  [[nodiscard]] std::int64_t room(std::int64_t position) const { return length_ - position % length_; }
  /// The peak of samples that start at `position` and lie in one tenth; positions only grow.
  void add(std::int64_t position, float peak);
  [[nodiscard]] float peak() const;

 private:
  std::int64_t length_;
  std::int64_t block_ = -1;
  std::array<float, 10> peaks_{};
};

/// A contiguous stretch of stereo samples, [first, position) in samples of the take.
class StereoHistory {
 public:
  explicit StereoHistory(SampleRate rate) : left_peaks_(rate), right_peaks_(rate) {}
  /// Appends interleaved frames. False, and nothing is appended, when one of them is not a finite number.
  bool append(std::span<const float> interleaved);
  /// Forgets everything; the next sample to come is `position`.
  void restart(std::int64_t position);
  /// Forgets samples before `from`, now or later.
  void drop_before(std::int64_t from);

  [[nodiscard]] std::int64_t first() const { return first_; }
  [[nodiscard]] std::int64_t position() const { return first_ + static_cast<std::int64_t>(count_); }
  [[nodiscard]] ChannelView left() const { return {left_.get(), first_, position()}; }
  [[nodiscard]] ChannelView right() const { return {right_.get(), first_, position()}; }
  [[nodiscard]] float left_peak() const { return left_peaks_.peak(); }
  [[nodiscard]] float right_peak() const { return right_peaks_.peak(); }

 private:
  void reserve(std::size_t count);

  std::unique_ptr<float[]> left_, right_;
  std::size_t capacity_ = 0;
  std::size_t count_ = 0;
  std::int64_t first_ = 0;
  PeakMeter left_peaks_, right_peaks_;
};

}  // namespace limbwave::decode
