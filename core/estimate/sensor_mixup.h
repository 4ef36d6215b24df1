/// Boards that are worn where another should be, or the wrong way round: found by what would explain the readings
/// better. A filter that takes a shin's board for the thigh's is contradicted by both; exchanged, or turned by half, it
/// is not. Hypotheses are compared by the likelihood of the innovations over a stretch of the recording.
#pragma once

#include <optional>
#include <vector>

#include "base/diagnostics.h"
#include "base/progress.h"
#include "estimate/body_smoother.h"
#include "estimate/body_watch.h"

namespace limbwave::estimate {

/// What may be wrong about one board or two.
struct Mixup {
  int board = -1, other = -1;                  ///< Exchanged with each other; `other` -1: not.
  Quaterniond turn = Quaterniond::Identity();  ///< Else: readings are right when turned by this, v_S = turn · v_read.
  int axis = -1;                               ///< Of the half turn: 0 x, 1 y, 2 z of the board.
  double gain = 0.0;                           ///< Of log likelihood over the stretch.
};

/// Boards whose innovations are far larger than they should be, worst first; those that `watch` found turned among
/// them.
std::vector<int> suspicious_boards(const BodyModel& model, const BodyRun& run, const BodyWatch& watch);

/// The mixup that explains the readings best, if any explains them clearly better than none. Neighbours along the limbs
/// and across the body, and half turns, of at most four suspects.
Result<std::optional<Mixup>> find_mixup(const BodyModel& model, const BodyFilterParameters& parameters,
                                        const BodyWatchParameters& watch, const BodyReadings& readings,
                                        const std::vector<int>& suspects, const Progress& progress);

/// Undoes a mixup in the readings.
void undo_mixup(const Mixup& mixup, BodyReadings& readings);

/// In the user's words.
Diagnostic tell(const Mixup& mixup, const BodyModel& model);

}  // namespace limbwave::estimate
