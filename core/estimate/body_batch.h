/// The optimiser on top of the smoother: all states of a take at once, by Gauss and Newton's method.
///
/// A smoother linearises what is measured where the filter believed to be. Linearised about the smoother's own answer
/// and solved again, until nothing changes, it is the Gauss-Newton method on the joint posterior of all states and
/// constants (Bell 1994, "The iterated Kalman smoother as a Gauss-Newton method").
#pragma once

#include <functional>

#include "estimate/body_smoother.h"

namespace limbwave::estimate {

/// States at every instant that is filtered. What is constant is kept once a stretch: the memory is some 3 kB an
/// instant for a whole body.
struct BodyTrajectory {
  struct Point {
    body::TreeState joints;
    std::vector<Vector3d> tissue_angle, tissue_gain;
    std::size_t stretch = 0;
  };
  std::vector<Point> points;
  std::vector<BodyState> constants;  ///< Per stretch.

  [[nodiscard]] BodyState state(std::size_t i) const;
};

/// `smooth_body`, linearised about a trajectory where there is one; what it finds goes to `found` if that is wanted.
/// `cost`: told the cost of the readings about the trajectory after the forward run, answers whether to go on; when
/// not, the error is `cancelled()`.
Result<BodyRun> smooth_about(const BodyModel& model, const BodyFilterParameters& parameters,
                             const BodyReadings& readings, double rate_hz, const Progress& progress, double stretch_s,
                             BodyStepHook* hook, const BodyTrajectory* about, BodyTrajectory* found,
                             const std::function<bool(double)>& cost = {});

struct BodyOptimum {
  BodyRun run;
  /// After each round, the smoother's own first: Σ ν²/σ² of readings, of changes of acceleration against the process
  /// noise, and of constants and the first pose against their priors.
  std::vector<double> costs;
  std::size_t best = 0;  ///< Which round's the run is.
  BodyState first;       ///< Its state at the first instant.
};

/// Rounds of smoothing until the cost falls by less than one part in 2000, or `most` are done.
Result<BodyOptimum> optimise_body(const BodyModel& model, const BodyFilterParameters& parameters,
                                  const BodyReadings& readings, double rate_hz, const Progress& progress,
                                  BodyStepHook* hook = nullptr, int most = 6);

}  // namespace limbwave::estimate
