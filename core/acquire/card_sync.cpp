#include "acquire/card_sync.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace limbwave::acquire {

float mark_sample(std::int64_t n) {
  return n < 0 || n >= kMarkSamples ? 0.0F : kMarkChips[static_cast<std::size_t>(n / kMarkChip)];
}

std::optional<std::int64_t> find_mark(std::span<const float> samples, double clear) {
  const auto count = static_cast<std::int64_t>(samples.size()) - kMarkSamples + 1;
  if (count <= 0) {
    return std::nullopt;
  }
  // Sums of a chip's length make the correlation thirteen additions.
  std::vector<double> sums(samples.size() + 1);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    sums[i + 1] = sums[i] + static_cast<double>(std::isfinite(samples[i]) ? samples[i] : 0.0F);
  }
  std::vector<double> likeness(static_cast<std::size_t>(count));
  for (std::int64_t n = 0; n < count; ++n) {
    double sum = 0.0;
    for (std::size_t c = 0; c < kMarkChips.size(); ++c) {
      const auto at = static_cast<std::size_t>(n) + c * kMarkChip;
      sum += static_cast<double>(kMarkChips[c]) * (sums[at + kMarkChip] - sums[at]);
    }
    likeness[static_cast<std::size_t>(n)] = std::abs(sum);
  }
  const double most = *std::max_element(likeness.begin(), likeness.end());
  if (!(most > 1e-6)) {
    return std::nullopt;
  }
  // The first that is nearly as strong as any: of several marks the earliest.
  const auto strong = std::find_if(likeness.begin(), likeness.end(), [&](double l) { return l > 0.8 * most; });
  const auto peak = std::max_element(strong, std::min(strong + kMarkSamples, likeness.end()));
  // Beside a mark there is nothing like it, but at its next repetition.
  double beside = 0.0;
  const std::int64_t at = peak - likeness.begin();
  for (std::int64_t n = std::max<std::int64_t>(0, at - 4 * kMarkSamples); n < std::min(count, at + 4 * kMarkSamples);
       ++n) {
    if (std::abs(n - at) >= kMarkChip) {
      beside = std::max(beside, likeness[static_cast<std::size_t>(n)]);
    }
  }
  return *peak >= clear * beside ? std::optional(at) : std::nullopt;
}

}  // namespace limbwave::acquire
