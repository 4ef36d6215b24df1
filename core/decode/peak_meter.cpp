#include "decode/peak_meter.h"

#include <algorithm>

#include "decode/settled_window.h"

namespace limbwave::decode {

bool all_finite(std::span<const float> samples) {
  // 0 · x is 0 for every number and NaN for everything else.
  std::array<float, 8> lanes{};
  const std::size_t whole = samples.size() / lanes.size() * lanes.size();
  for (std::size_t i = 0; i < whole; i += lanes.size()) {
    for (std::size_t lane = 0; lane < lanes.size(); ++lane) {
      lanes[lane] += 0.0F * samples[i + lane];
    }
  }
  float sum = 0.0F;
  for (const float lane : lanes) {
    sum += lane;
  }
  for (std::size_t i = whole; i < samples.size(); ++i) {
    sum += 0.0F * samples[i];
  }
  return sum == 0.0F;
}

void PeakMeter::add(std::int64_t position, std::span<const float> samples) {
  while (!samples.empty()) {
    const std::int64_t block = position / length_;
    if (block != block_) {
      const std::int64_t skipped = std::min<std::int64_t>(block - block_, static_cast<std::int64_t>(peaks_.size()));
      for (std::int64_t i = 0; i < skipped; ++i) {
        peaks_[static_cast<std::size_t>(block - i) % peaks_.size()] = 0.0F;
      }
      block_ = block;
    }
    const auto count =
        std::min<std::size_t>(samples.size(), static_cast<std::size_t>((block + 1) * length_ - position));
    float& peak = peaks_[static_cast<std::size_t>(block) % peaks_.size()];
    peak = std::max(peak, largest_magnitude(samples.data(), static_cast<std::ptrdiff_t>(count)));
    samples = samples.subspan(count);
    position += static_cast<std::int64_t>(count);
  }
}

float PeakMeter::peak() const {
  return *std::max_element(peaks_.begin(), peaks_.end());
}

}  // namespace limbwave::decode
