/// One run of the solver as the studio wants it: read or solve, then everything that faces show of the result, made
/// beside the window. No widgets.
#pragma once

#include <QString>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "signal/min_max_pyramid.h"
#include "workspaces/solve/solve_services.h"

namespace limbwave::ui {

/// What curves show of a sensor, made beside the window. One value per frame of the clip.
struct SensorCurve {
  QString name;
  int segment = -1;
  std::vector<float> elevation_deg;
  std::vector<float> trust;      ///< 0..1
  std::vector<float> sigma_deg;  ///< Of the bone's joint, where the method tells; then in place of trust.
  /// Of these, so that an hour is drawn as fast as a second.
  signal::MinMaxPyramid elevation_extremes{16}, trust_extremes{16}, sigma_extremes{16};
};

/// Never changed once made, so that faces share it.
using SensorCurves = std::shared_ptr<const std::vector<SensorCurve>>;

struct SolveRequest {
  bool load = false;  ///< Read the solve of `settings.name`; else solve.
  std::shared_ptr<const take::Take> take;
  solve::SolveSettings settings;  ///< With the keys that the solve is to have.
  body::Skeleton lengths;         ///< Lengths that outlive a new solve; without segments: the take's own.
  double clip_start_s = 0.0;      ///< Of the take, where the clip's time 0 lies.
};

struct SolveOutcome {
  std::shared_ptr<const solve::Solve> solve;
  SensorCurves curves;
  std::shared_ptr<const evaluate::Truth> truth;  ///< Null without one.
  std::optional<evaluate::Evaluation> evaluation;
  Status compared;     ///< Why there is no evaluation although there is a truth.
  bool fresh = false;  ///< Solved now, so not on disk yet.
  /// What was wrong with the saved solve, where it is now, and whether its keys could be read.
  std::optional<Error> damage;
  std::filesystem::path aside;
  bool kept_keys = false;
};

/// To be called in a job. A saved solve that cannot be read is set aside and solved again with its keys.
Result<SolveOutcome> run_solve(const SolveServices& services, const SolveRequest& request, const Progress& progress);

}  // namespace limbwave::ui
