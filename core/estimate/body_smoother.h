/// A whole recording through the body filter, forward or forward and backward.
///
/// The smoother is the fixed-interval one of Bryson and Frazier: an adjoint λ runs backward over the filter's updates,
/// x_s = x ⊟ P λ, with no inverse of any covariance. What the backward run needs of the forward run (gains and Jacobian
/// rows of every update) would fill the memory; so the filter leaves a snapshot every second or two, and stretches
/// between snapshots are filtered again, from the last to the first, while their updates are kept.
#pragma once

#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "estimate/body_adjoint.h"
#include "estimate/body_filter.h"
#include "estimate/body_step_hook.h"

namespace limbwave::estimate {

/// Estimated poses at some instants.
struct BodyTrack {
  std::vector<double> times;
  std::vector<std::vector<Quaterniond>> R_joint;  ///< Per time and segment, away from rest.
  std::vector<Vector3d> root_p_W;                 ///< Per time: place of the root joint.
  std::vector<std::vector<float>> sigma;          ///< Per time and segment: of the joint's rotation, rad, all axes.
  std::vector<std::vector<float>> point_sigma;    ///< Per time and segment: of its far end's place, m, all axes.
  std::vector<Vector3d> root_sigma;               ///< Per time: of the root's place, m.
};

struct BodyRun {
  BodyTrack track;
  Diagnostics diagnostics;
  BodyState last;  ///< The filter's mind at the end.
  double log_likelihood = 0.0;
  std::vector<double> log_likelihoods;  ///< Of the filter, per pose of its track: of all readings up to there.
  std::vector<ReadingCount> gyroscopes, accelerometers, ranges;
};

/// Poses at every instant with inertial readings (all instants where there are none), at most `rate_hz` of them.
Result<BodyRun> filter_body(const BodyModel& model, const BodyFilterParameters& parameters,
                            const BodyReadings& readings, double rate_hz, const Progress& progress,
                            BodyStepHook* hook = nullptr);
/// The same from both sides. Memory: a snapshot per `stretch_s` and the updates of one stretch.
Result<BodyRun> smooth_body(const BodyModel& model, const BodyFilterParameters& parameters,
                            const BodyReadings& readings, double rate_hz, const Progress& progress,
                            double stretch_s = 1.5, BodyStepHook* hook = nullptr);

/// Starts the filter from the readings: the root from its path or from gravity, everything else at rest; gyroscopes
/// that stand still in the first second tell their bias (Vlasic et al. 2007, §5.4). Pose and mountings are left to the
/// filter, whose first updates in rest do what the paper's gradient descent does. Returns which boards moved.
Diagnostics start_from_rest(BodyFilter& filter, const BodyReadings& readings);

}  // namespace limbwave::estimate
