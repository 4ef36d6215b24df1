/// The whole recorded signal of a take at every zoom level.
#pragma once

#include <memory>

#include "base/progress.h"
#include "base/result.h"
#include "plots/box_history.h"
#include "signal/min_max_pyramid.h"
#include "take/take.h"

namespace limbwave::ui {

struct TakeOverview {
  signal::MinMaxPyramid left, right;
  BoxHistory box;  ///< Of a driver box, instead of the two channels.
  double rate_hz = 0.0;
  std::int64_t frames = 0;
  [[nodiscard]] double seconds() const { return rate_hz > 0.0 ? static_cast<double>(frames) / rate_hz : 0.0; }
};

/// Reads signal.wav once, of a driver box short stretches of it; runs in a job. Fails when the samples cannot be read,
/// or cancelled.
Result<std::shared_ptr<const TakeOverview>> load_overview(const take::Take& take, const Progress& progress);

}  // namespace limbwave::ui
