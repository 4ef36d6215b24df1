#include "workspaces/solve/solve_run.h"

#include "common/shown_names.h"
#include "solve/compose.h"
#include "solve/solve.h"
#include "solve/uncertainty.h"
#include "workspaces/solve/solve_pose.h"

namespace limbwave::ui {

namespace {

SensorCurves make_curves(const take::Take& take, const solve::Solve& solve) {
  const body::Rig& rig = take.info.rig;
  const std::vector<int> segments = solve::sensor_segments(rig, solve.clip.skeleton);
  std::vector<std::vector<float>> elevation = elevations(solve.clip, segments);
  auto curves = std::make_shared<std::vector<SensorCurve>>(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    SensorCurve& curve = (*curves)[i];
    curve.name = shown_name(rig.accelerometers[i].name);
    curve.segment = segments[i];
    curve.elevation_deg = std::move(elevation[i]);
    if (i < solve.trust.size()) {
      curve.trust = solve.trust[i];
    }
    if (!solve.uncertainty.times.empty() && segments[i] >= 0 && !solve.clip.joints.empty()) {
      for (const double time : solve.clip.joints.front().rotation.times) {
        curve.sigma_deg.push_back(
            static_cast<float>(solve::joint_sigma_deg(solve.uncertainty, static_cast<std::size_t>(segments[i]), time)));
      }
      curve.sigma_extremes.append(curve.sigma_deg);
    }
    curve.elevation_extremes.append(curve.elevation_deg);
    curve.trust_extremes.append(curve.trust);
  }
  return curves;
}

Result<solve::Solve> read_or_solve(const SolveServices& services, const SolveRequest& request, SolveOutcome& outcome,
                                   const Progress& progress) {
  solve::SolveSettings settings = request.settings;
  if (request.load) {
    Result<solve::Solve> loaded = services.load(*request.take, settings.name);
    if (loaded || is_cancelled(loaded.error())) {
      return loaded;
    }
    // Keys and lengths are the user's own and cannot be computed again: keep what is there.
    outcome.damage = loaded.error();
    if (Result<solve::SolveSettings> kept = services.load_settings(*request.take, settings.name); kept) {
      settings = std::move(kept).value();
      outcome.kept_keys = true;
    }
    Result<std::filesystem::path> aside = services.set_aside(*request.take, settings.name);
    if (!aside) {
      return aside.error();
    }
    outcome.aside = std::move(aside).value();
  }
  outcome.fresh = true;
  if (settings.headings.empty()) {
    settings.headings = solve::known_headings(*request.take, settings.name);
  }
  return services.solve(*request.take, settings, progress.part(0.0, 0.9));
}

void compare(const SolveServices& services, const SolveRequest& request, SolveOutcome& outcome) {
  Result<std::optional<evaluate::Truth>> truth =
      services.load_truth ? services.load_truth(*request.take) : std::optional<evaluate::Truth>();
  if (!truth) {
    outcome.compared = truth.error();
    return;
  }
  if (!truth->has_value()) {
    return;
  }
  outcome.truth = std::make_shared<const evaluate::Truth>(*std::move(truth).value());
  Result<evaluate::Evaluation> evaluation =
      services.evaluate(outcome.solve->clip, request.clip_start_s, *outcome.truth);
  if (evaluation) {
    outcome.evaluation = std::move(evaluation).value();
  } else {
    outcome.compared = evaluation.error();
  }
}

}  // namespace

Result<SolveOutcome> run_solve(const SolveServices& services, const SolveRequest& request, const Progress& progress) {
  SolveOutcome outcome;
  Result<solve::Solve> solved = read_or_solve(services, request, outcome, progress);
  if (!solved) {
    return solved.error();
  }
  auto made = std::make_shared<solve::Solve>(std::move(solved).value());
  if (!request.load && request.lengths.segments.size() == made->clip.skeleton.segments.size()) {
    made->clip.skeleton = request.lengths;
  }
  outcome.curves = make_curves(*request.take, *made);
  outcome.solve = std::move(made);
  compare(services, request, outcome);
  return outcome;
}

}  // namespace limbwave::ui
