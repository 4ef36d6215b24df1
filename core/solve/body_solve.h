/// From readings to a clip by the body filter or the smoother.
#pragma once

#include <string>

#include "base/progress.h"
#include "estimate/body_smoother.h"
#include "solve/solve.h"

namespace limbwave::solve {

struct BodySolveSettings {
  std::string name = "default";
  std::string sensors = "AGD";  ///< Any of A, G and D.
  bool smooth = false;          ///< Both directions.
  std::string root = "free";    ///< "truth", "fixed", "contacts", "free", or a CSV file with the root's path.
  double rate_hz = 120.0;       ///< Poses a second of the clip at most.
};

/// The parameters that suit a model: what a rig of one free sensor needs is not what a body needs.
estimate::BodyFilterParameters body_parameters(const estimate::BodyModel& model, const BodySolveSettings& settings);

/// Solves readings on the take's skeleton. Fails when nothing of the chosen sensors is there, or the root is not.
Result<Solve> solve_body(const take::Take& take, estimate::BodyReadings readings, const BodySolveSettings& settings,
                         const Progress& progress);
/// The same for a take of kind "log".
Result<Solve> solve_log(const take::Take& take, const BodySolveSettings& settings, const Progress& progress);

}  // namespace limbwave::solve
