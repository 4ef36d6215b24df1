/// Largest magnitude of the last second, and the check for samples that are not numbers.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/time.h"

namespace limbwave::decode {

/// True when no sample is NaN or infinite.
bool all_finite(std::span<const float> samples);

/// Keeps the peaks of tenths of a second on a grid fixed to the take.
class PeakMeter {
 public:
  explicit PeakMeter(SampleRate rate) : length_(static_cast<std::int64_t>(rate.hz / 10.0) + 1) {}
  /// Samples from `position` on; positions only grow.
  void add(std::int64_t position, std::span<const float> samples);
  [[nodiscard]] float peak() const;

 private:
  std::int64_t length_;
  std::int64_t block_ = -1;
  std::array<float, 10> peaks_{};
};

}  // namespace limbwave::decode
