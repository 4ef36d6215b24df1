#include "acquire/card_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "acquire/card_sync.h"

namespace limbwave::acquire {

DuplexPlan card_plan(const CardBoxSettings& settings, const std::vector<std::uint8_t>& schedule, bool marked) {
  DuplexPlan plan;
  plan.rate_hz = settings.rate_hz;
  plan.inputs = settings.wires + (marked ? 1 : 0);
  plan.outputs = settings.sources + (marked ? 1 : 0);
  plan.round = std::int64_t{settings.slot_samples} * static_cast<std::int64_t>(schedule.size());
  plan.backlog_s = settings.backlog_s;
  plan.samples.assign(static_cast<std::size_t>(plan.outputs), std::vector<float>(static_cast<std::size_t>(plan.round)));
  const auto pulse = static_cast<std::int64_t>(settings.pulse_cycles / settings.pulse_hz * settings.rate_hz);
  for (std::size_t slot = 0; slot < schedule.size(); ++slot) {
    if (schedule[slot] >= settings.sources) {
      continue;
    }
    auto& channel = plan.samples[schedule[slot]];
    const std::size_t first = slot * static_cast<std::size_t>(settings.slot_samples);
    for (std::int64_t n = 0; n < std::min<std::int64_t>(pulse, settings.slot_samples); ++n) {
      const double turns = settings.pulse_hz / settings.rate_hz * static_cast<double>(n);
      channel[first + static_cast<std::size_t>(n)] =
          settings.level * static_cast<float>(std::cos(2.0 * std::numbers::pi * turns));
    }
  }
  for (std::int64_t n = 0; marked && n < std::min<std::int64_t>(kMarkSamples, plan.round); ++n) {
    plan.samples.back()[static_cast<std::size_t>(n)] = settings.level * mark_sample(n);
  }
  return plan;
}

}  // namespace limbwave::acquire
