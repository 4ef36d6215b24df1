#include "solve/live_latency.h"

#include <algorithm>
#include <numeric>

namespace limbwave::solve {
namespace {

double last_of(const PoseTimes& times) {
  return times.drawn > 0.0 ? times.drawn : times.solved;
}

double duration(const PoseTimes& times, LatencyStage stage) {
  switch (stage) {
    case LatencyStage::kCycle:
      return times.cycle_end - times.oldest_slot;
    case LatencyStage::kArrival:
      return times.arrived - times.cycle_end;
    case LatencyStage::kSolve:
      return times.solved - times.arrived;
    case LatencyStage::kHandover:
      return times.drawn > 0.0 ? times.taken - times.solved : 0.0;
    case LatencyStage::kDraw:
      return times.drawn > 0.0 ? times.drawn - times.taken : 0.0;
    case LatencyStage::kTotal:
      break;
  }
  return last_of(times) - times.oldest_slot;
}

LatencyFigures figures_of(std::vector<double>& values) {
  std::sort(values.begin(), values.end());
  const double count = static_cast<double>(values.size());
  // The smallest value that 95 % do not exceed.
  const auto at = std::min(values.size() - 1, (values.size() * 95 + 99) / 100 - 1);
  return {std::accumulate(values.begin(), values.end(), 0.0) / count, values[at], values.back()};
}

}  // namespace

std::string_view name(LatencyStage stage) {
  constexpr std::array<std::string_view, kLatencyStages> names{"cycle",    "arrival", "solve",
                                                               "handover", "draw",    "total"};
  return names[static_cast<std::size_t>(stage)];
}

void LatencyMeter::add(const PoseTimes& times) {
  const bool drawn = times.drawn > 0.0;
  const bool in_order = times.oldest_slot > 0.0 && times.oldest_slot <= times.instant &&
                        times.instant <= times.cycle_end && times.cycle_end <= times.arrived &&
                        times.arrived <= times.solved &&
                        (!drawn || (times.solved <= times.taken && times.taken <= times.drawn));
  if (!in_order) {
    return;
  }
  poses_.push_back(times);
  const double until = last_of(times);
  const auto kept = std::find_if(poses_.begin(), poses_.end(),
                                 [&](const PoseTimes& other) { return last_of(other) > until - window_s_; });
  poses_.erase(poses_.begin(), kept);
}

LatencyReport LatencyMeter::report() const {
  LatencyReport report;
  report.poses = poses_.size();
  if (poses_.empty()) {
    return report;
  }
  std::vector<double> values(poses_.size());
  for (std::size_t s = 0; s < kLatencyStages; ++s) {
    std::transform(poses_.begin(), poses_.end(), values.begin(),
                   [&](const PoseTimes& times) { return duration(times, static_cast<LatencyStage>(s)); });
    report.stages[s] = figures_of(values);
  }
  const auto over = std::count_if(values.begin(), values.end(), [](double total) { return total > kLatencyBudget_s; });
  report.over_budget = static_cast<double>(over) / static_cast<double>(values.size());
  return report;
}

}  // namespace limbwave::solve
