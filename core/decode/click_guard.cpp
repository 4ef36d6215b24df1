#include "decode/click_guard.h"

#include <algorithm>

namespace limbwave::decode {
namespace {

constexpr double kKept = 1.0 - 1.0 / 60.0;  // per cycle
constexpr double kEnough = 32.0;            // slots, before the line is told from them
constexpr double kFactor = 36.0;            // six times the expected deviation

}  // namespace

double ClickGuard::expected(double step_square) const {
  if (weight_ < kEnough) {
    return first_square_;
  }
  const double spread = step_step_ - step_ * step_ / weight_;
  const double ringing = spread > 1e-18 ? std::max(0.0, (step_variance_ - step_ * variance_ / weight_) / spread) : 0.0;
  const double noise = std::max(0.0, (variance_ - ringing * step_) / weight_);
  return noise + ringing * step_square;
}

std::uint32_t ClickGuard::step(const CycleMeasurement& cycle, int slots, double swing) {
  const double least = kRestless * swing * kRestless * swing;
  std::uint32_t clicks = 0;
  weight_ *= kKept;
  step_ *= kKept;
  step_step_ *= kKept;
  variance_ *= kKept;
  step_variance_ *= kKept;
  for (int j = 0; j < slots; ++j) {
    const auto slot = static_cast<std::size_t>(j);
    const auto before = static_cast<std::size_t>(j == 0 ? slots - 1 : j - 1);  // the reference does not move
    if (((cycle.clipped >> slot | cycle.clipped >> before) & 1U) != 0) {
      continue;
    }
    const double height = cycle.slots[slot].mean - cycle.slots[before].mean;
    const double square = height * height;
    const double limit = std::max(least, kFactor * expected(square));
    // A line that has become worse for good is learnt little by little.
    const double variance = std::min(cycle.slots[slot].variance, limit);
    if (cycle.slots[slot].variance > limit && j + 1 < slots) {
      clicks |= std::uint32_t{1} << slot;
    }
    weight_ += 1.0;
    step_ += square;
    step_step_ += square * square;
    variance_ += variance;
    step_variance_ += variance * square;
  }
  return clicks;
}

}  // namespace limbwave::decode
