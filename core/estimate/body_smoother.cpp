#include "estimate/body_smoother.h"

#include <algorithm>
#include <cmath>

#include "estimate/body_batch.h"
#include "estimate/body_runner.h"
#include "geometry/so3.h"

namespace limbwave::estimate {

Result<BodyRun> filter_body(const BodyModel& model, const BodyFilterParameters& parameters,
                            const BodyReadings& readings, double rate_hz, const Progress& progress,
                            BodyStepHook* hook) {
  BodyRunner run(model, parameters, readings, rate_hz, hook);
  BodyRun result;
  if (Status status = run.begin(result); !status) {
    return status.error();
  }
  reserve(result.track, run.instants.size());
  const int dofs = run.filter.layout().dofs;
  for (std::size_t i = 0; i < run.instants.size(); ++i) {
    run.step(i);
    if (run.wanted[i] != 0) {
      append_pose(run.filter, run.filter.state(), result.track);
      result.log_likelihoods.push_back(run.filter.log_likelihood());
      const ErrorCovariance& P = run.filter.covariance();
      append_sigma(pose_sigma(run.filter.tree(), model.skeleton, run.filter.state().joints,
                              joint_covariance(P.row(0), P.stride(), dofs), {}),
                   result.track);
      if (const FootContacts* feet = run.feet()) {
        place_root(feet->place(run.filter.state().time_s), result.track, result.track.times.size() - 1);
      }
    }
    if (i % 64 == 0 && !progress.report(static_cast<double>(i) / static_cast<double>(run.instants.size()))) {
      return cancelled();
    }
  }
  run.finish(result);
  return result;
}

Result<BodyRun> smooth_body(const BodyModel& model, const BodyFilterParameters& parameters,
                            const BodyReadings& readings, double rate_hz, const Progress& progress, double stretch_s,
                            BodyStepHook* hook) {
  return smooth_about(model, parameters, readings, rate_hz, progress, stretch_s, hook, nullptr, nullptr);
}

Diagnostics start_from_rest(BodyFilter& filter, const BodyReadings& readings) {
  Diagnostics found;
  const double begin = std::min(readings.inertial.empty() ? INFINITY : readings.inertial.front().time_s,
                                readings.ranges.empty() ? INFINITY : readings.ranges.front().time_s);
  const BodyModel& model = filter.model();
  const bool given = filter.parameters().root == RootMode::kGiven && !readings.root.empty();
  RootReading root;
  if (given) {
    root = root_at(readings.root, begin);
  }
  // Means over the first second, and how much every board moved in it.
  struct Mean {
    Vector3d f = Vector3d::Zero(), w = Vector3d::Zero();
    double ww = 0.0;
    int forces = 0, rates = 0;
    // Standard deviation of the rates, rad/s.
    [[nodiscard]] double spread() const { return std::sqrt(std::max(0.0, ww / rates - (w / rates).squaredNorm())); }
  };
  constexpr double kSecond = 1.0;
  constexpr double kStill = 0.05;       // rad/s
  constexpr double kMostBias = 0.05;    // rad/s: more is a turn
  constexpr double kBiasLeft = 0.0007;  // rad/s: nobody stands more still
  std::vector<Mean> means(model.boards.size());
  for (const InertialReading& reading : readings.inertial) {
    if (reading.time_s > begin + kSecond) {
      break;
    }
    Mean& mean = means[static_cast<std::size_t>(reading.board)];
    if (reading.f_S.allFinite() && reading.time_s < begin + 0.5 * kSecond) {
      mean.f += reading.f_S;
      ++mean.forces;
    }
    if (reading.w_S.allFinite()) {
      mean.w += reading.w_S;
      mean.ww += reading.w_S.squaredNorm();
      ++mean.rates;
    }
  }
  bool inclined = false;
  if (!given && filter.tree().root_motion() == body::RootMotion::kFree && filter.parameters().use_accelerometers) {
    // Inclination of the root from the board on it.
    for (std::size_t b = 0; b < model.boards.size() && !inclined; ++b) {
      if (model.boards[b].segment == 0 && means[b].forces > 0) {
        const Quaterniond rest = model.skeleton.segments.front().R_PL_rest;
        const Vector3d up_W = rest * (model.boards[b].R_LS * Vector3d(means[b].f));
        root.R_WL = geometry::shortest_arc(up_W, Vector3d::UnitZ()) * rest;
        root.p_W = model.skeleton.segments.front().p_PL;
        inclined = true;
      }
    }
  }
  filter.start(begin, given || inclined ? &root : nullptr);
  // Gyroscopes that read the same all the time stand still: what they read is their bias (§5.4 of the paper).
  BodyState state = filter.state();
  for (std::size_t b = 0; b < means.size(); ++b) {
    const Mean& mean = means[b];
    if (mean.rates < 20 || filter.layout().gyroscope_bias[b] < 0) {
      continue;
    }
    if (mean.spread() > kStill || (mean.w / mean.rates).norm() > kMostBias) {
      found.push_back({Severity::kWarning, "body.not-still",
                       "\"" + model.boards[b].name + "\" moved in the first second: its gyroscope's bias is not known",
                       "begin with a second of standing still", model.boards[b].name, begin});
      continue;
    }
    state.gyroscope_bias[b] = mean.w / mean.rates;
    for (int i = 0; i < 3; ++i) {
      filter.mutable_covariance().set_variance(filter.layout().gyroscope_bias[b] + i,
                                               kBiasLeft * kBiasLeft + mean.spread() * mean.spread() / mean.rates);
    }
  }
  filter.set_state(state);
  return found;
}

}  // namespace limbwave::estimate
