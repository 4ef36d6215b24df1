/// The movement of a chain over one stretch of time that fits best; what smooth_chain puts together.
#pragma once

#include <optional>
#include <vector>

#include "base/progress.h"
#include "estimate/chain_smoother.h"

namespace limbwave::estimate {

/// By link and instant of a window.
struct ChainEstimate {
  std::vector<std::vector<Vector3d>> up_L;
  std::vector<std::vector<double>> sd_rad;    ///< Of the direction, per axis across it.
  std::vector<std::vector<double>> residual;  ///< What the chain leaves of a reading, RMS per axis, m/s²; NaN: unknown.
  std::vector<double> cost;  ///< By instant: how unlikely all this is, ½ χ² over all residuals and links.
};

/// Times strictly increasing without gaps, at least ChainModel::kReach + 1 of them; `samples` and `start` by link.
/// Empty when `progress` says stop.
std::optional<ChainEstimate> estimate_window(const LimbChain& chain, const std::vector<double>& times,
                                             const std::vector<std::vector<ForceSample>>& samples,
                                             const std::vector<std::vector<Inclination>>& start,
                                             const ChainParameters& parameters, const Progress& progress);

/// Orientations that show `start`'s inclinations, with headings that fit the joints: carried on from instant to
/// instant by the simplest turns, and drawn towards what the joints can do.
ChainState chain_state_from(const LimbChain& chain, const std::vector<double>& times,
                            const std::vector<std::vector<Inclination>>& start, const ChainPriors& priors);

/// How fast readings change, m/s³: the slope of a line through five of them; 0 where that cannot be told.
std::vector<double> reading_changes(const std::vector<double>& times, const std::vector<ForceSample>& samples);

/// Root mean square of the finite `values` over `reach_s` to either side of every time; 0 where there are none.
std::vector<double> rms_around(const std::vector<double>& times, const std::vector<double>& values, double reach_s);

}  // namespace limbwave::estimate
