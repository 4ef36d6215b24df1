#include "estimate/body_batch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "estimate/body_runner.h"
#include "geometry/so3.h"

namespace limbwave::estimate {
namespace {

using Eigen::VectorXd;

constexpr double kStretch = 1.0;      // s; of snapshots
constexpr double kLeastLooks = 60.0;  // a second
constexpr double kLeastFall = 1.0 / 2000.0;

// What a stretch of the recording leaves for the way back.
struct Kept {
  StepRecord record;
  BodyState state;
  AlignedRows P;  // rows: joint degrees of freedom, or all that moves
};

// −P λ for the constants of a filter's state; nothing for what moves.
VectorXd change_of_constants(const BodyFilter& filter, const VectorXd& lambda) {
  VectorXd x = VectorXd::Zero(lambda.size());
  for (int i = filter.layout().moving; i < filter.layout().size; ++i) {
    x[i] = -Eigen::Map<const VectorXd>(filter.covariance().row(i), lambda.size()).dot(lambda);
  }
  return x;
}

template <typename T>
void reverse(std::vector<T>& values) {
  std::reverse(values.begin(), values.end());
}

void reverse(BodyTrack& track) {
  reverse(track.times);
  reverse(track.R_joint);
  reverse(track.root_p_W);
  reverse(track.sigma);
  reverse(track.point_sigma);
  reverse(track.root_sigma);
}

// The root's way by looks at the feet, at the poses' own times.
void place_root(const std::vector<FootLook>& looks, const std::vector<RootPlace>& places, BodyTrack& track) {
  std::size_t k = 0;
  for (std::size_t i = 0; i < track.times.size() && !looks.empty(); ++i) {
    while (k + 2 < looks.size() && looks[k + 1].time_s <= track.times[i]) {
      ++k;
    }
    const std::size_t next = std::min(k + 1, looks.size() - 1);
    const double between = looks[next].time_s - looks[k].time_s;
    const double s = between > 0.0 ? std::clamp((track.times[i] - looks[k].time_s) / between, 0.0, 1.0) : 0.0;
    place_root(
        RootPlace{(1.0 - s) * places[k].p + s * places[next].p, (1.0 - s) * places[k].sigma + s * places[next].sigma},
        track, i);
  }
}

// The part of the cost that is not of readings.
double cost_of_motion(const BodyModel& model, const BodyFilterParameters& p, const BodyReadings& readings,
                      BodyStepHook* hook, const BodyTrajectory& trajectory) {
  BodyRunner runner(model, p, readings, 1.0, hook);
  if (!runner.start()) {
    return 0.0;
  }
  const BodyFilter& filter = runner.filter;
  const int n = filter.layout().dofs;
  const bool free_root = filter.tree().root_motion() == body::RootMotion::kFree;
  double cost = 0.0;
  const VectorXd off = filter.difference(filter.state(), trajectory.state(0));
  for (int i = 0; i < filter.layout().size; ++i) {
    if (i < n || i >= filter.layout().moving) {
      cost += off[i] * off[i] / filter.covariance()(i, i);
    }
  }
  for (std::size_t k = 1; k < trajectory.points.size(); ++k) {
    const double dt = runner.instants[k].time_s - runner.instants[k - 1].time_s;
    const double kept = p.acceleration_time > 0.0 ? std::exp(-dt / p.acceleration_time) : 1.0;
    const VectorXd jump = trajectory.points[k].joints.qdd - kept * trajectory.points[k - 1].joints.qdd;
    for (int i = 0; i < n; ++i) {
      const double walk = free_root && i < 3 ? p.root_acceleration_walk : p.acceleration_walk;
      cost += jump[i] * jump[i] / (walk * walk * dt);
    }
  }
  return cost;
}

}  // namespace

BodyState BodyTrajectory::state(std::size_t i) const {
  const Point& point = points[i];
  BodyState state = constants[point.stretch];
  state.joints = point.joints;
  state.tissue_angle = point.tissue_angle;
  state.tissue_gain = point.tissue_gain;
  return state;
}

Result<BodyRun> smooth_about(const BodyModel& model, const BodyFilterParameters& parameters,
                             const BodyReadings& readings, double rate_hz, const Progress& progress, double stretch_s,
                             BodyStepHook* hook, const BodyTrajectory* about, BodyTrajectory* found,
                             const std::function<bool(double)>& cost) {
  BodyRunner run(model, parameters, readings, rate_hz, hook);
  BodyRun result;
  if (Status status = run.begin(result); !status) {
    return status.error();
  }
  BodyState point;
  const auto step = [&](std::size_t i, StepRecord* record) {
    if (about != nullptr) {
      point = about->state(i);
    }
    run.step(i, record, about != nullptr ? &point : nullptr);
  };
  struct Checkpoint {
    std::size_t first;
    BodyFilter::Snapshot snapshot;
  };
  std::vector<Checkpoint> checkpoints;
  const std::size_t count = run.instants.size();
  double next = -1e300;
  for (std::size_t i = 0; i < count; ++i) {
    if (run.instants[i].time_s >= next) {
      checkpoints.push_back({i, run.filter.snapshot()});
      next = run.instants[i].time_s + stretch_s;
    }
    step(i, nullptr);
    if (i % 64 == 0 && !progress.report(0.5 * static_cast<double>(i) / static_cast<double>(count))) {
      return cancelled();
    }
  }
  run.finish(result);
  if (cost && !cost(run.filter.cost())) {
    return cancelled();
  }

  const int size = run.filter.layout().size;
  const int dofs = run.filter.layout().dofs;
  const int moving = run.filter.layout().moving;
  SampledAdjoint adjoint(size);
  std::vector<Kept> kept;
  BodyTrack reversed;
  if (found != nullptr) {
    found->points.resize(count);
    found->constants.resize(checkpoints.size());
  }
  // Feet are looked at as often as poses are wanted, but not seldom.
  const FootContacts* feet = run.feet();
  const std::vector<char> looked = feet == nullptr          ? std::vector<char>(count, 0)
                                   : rate_hz >= kLeastLooks ? run.wanted
                                                            : chosen(run.instants, kLeastLooks);
  std::vector<FootLook> looks;
  const auto posed = [&](std::size_t i) { return run.wanted[i] != 0 || looked[i] != 0 || found != nullptr; };
  std::size_t end = count;
  while (!checkpoints.empty()) {
    const Checkpoint& checkpoint = checkpoints.back();
    run.filter.resume(checkpoint.snapshot);
    if (kept.size() < end - checkpoint.first) {
      kept.resize(end - checkpoint.first);
    }
    for (std::size_t i = checkpoint.first; i < end; ++i) {
      Kept& k = kept[i - checkpoint.first];
      step(i, &k.record);
      if (posed(i)) {
        k.state = run.filter.state();
        const ErrorCovariance& P = run.filter.covariance();
        k.P.resize(found != nullptr ? moving : dofs, P.stride());
        std::copy_n(P.row(0), k.P.rows() * P.stride(), k.P.row(0));
      }
    }
    for (std::size_t i = end; i-- > checkpoint.first;) {
      Kept& k = kept[i - checkpoint.first];
      if (posed(i)) {
        const SampledAdjoint::Rows changes = adjoint.changes(k.P);
        if (found != nullptr) {
          VectorXd x = VectorXd::Zero(size);
          x.head(moving) = -changes.col(0);
          run.filter.inject(k.state, x);
          found->points[i] = {k.state.joints, k.state.tissue_angle, k.state.tissue_gain, checkpoints.size() - 1};
        } else {
          run.filter.tree().add(k.state.joints, -changes.col(0));
        }
        if (looked[i] != 0) {
          looks.push_back(feet->look_at(run.filter, k.state, k.P.row(0), k.P.columns()));
        }
        if (run.wanted[i] != 0) {
          append_pose(run.filter, k.state, reversed);
          append_sigma(pose_sigma(run.filter.tree(), model.skeleton, k.state.joints,
                                  joint_covariance(k.P.row(0), k.P.columns(), dofs),
                                  changes.topRightCorner(dofs, SampledAdjoint::kSamples)),
                       reversed);
        }
      }
      adjoint.over_step(k.record, run.filter.tree());
    }
    if (found != nullptr) {
      run.filter.resume(checkpoint.snapshot);
      BodyState& constants = found->constants[checkpoints.size() - 1];
      constants = run.filter.state();
      run.filter.inject(constants, change_of_constants(run.filter, adjoint.lambda()));
    }
    end = checkpoint.first;
    checkpoints.pop_back();
    if (!progress.report(1.0 - 0.5 * static_cast<double>(end) / static_cast<double>(count))) {
      return cancelled();
    }
  }
  reverse(reversed);
  result.track = std::move(reversed);
  if (feet != nullptr) {
    reverse(looks);
    place_root(looks, feet->smooth(looks), result.track);
  }
  return result;
}

Result<BodyOptimum> optimise_body(const BodyModel& model, const BodyFilterParameters& parameters,
                                  const BodyReadings& readings, double rate_hz, const Progress& progress,
                                  BodyStepHook* hook, int most) {
  BodyOptimum optimum;
  BodyRun before;  // the last round's, to be taken back to where the cost rises
  BodyState first_before;
  BodyTrajectory trajectory;
  for (int round = 0; round <= most; ++round) {
    const auto share = [&](int r) { return static_cast<double>(r) / (most + 1); };
    bool fell = true;
    BodyTrajectory next;
    const double of_motion = round > 0 ? cost_of_motion(model, parameters, readings, hook, trajectory) : 0.0;
    // A round tells what the one before it cost.
    const auto judge = [&](double of_readings) {
      if (round == 0) {
        return true;
      }
      optimum.costs.push_back(of_readings + of_motion);
      const std::size_t last = optimum.costs.size() - 1;
      if (last > 0) {
        optimum.best = optimum.costs[last] < optimum.costs[optimum.best] ? last : optimum.best;
        fell = optimum.costs[last] < (1.0 - kLeastFall) * optimum.costs[last - 1];
      }
      return fell && round < most;
    };
    Result<BodyRun> run =
        smooth_about(model, parameters, readings, rate_hz, progress.part(share(round), share(round + 1)), kStretch,
                     hook, round > 0 ? &trajectory : nullptr, &next, judge);
    if (!run && is_cancelled(run.error()) && round > 0 && optimum.costs.size() == static_cast<std::size_t>(round) &&
        (!fell || round == most)) {
      break;
    }
    if (!run) {
      return run.error();
    }
    before = std::exchange(optimum.run, *std::move(run));
    first_before = std::exchange(optimum.first, next.state(0));
    trajectory = std::move(next);
  }
  if (optimum.best + 1 < optimum.costs.size()) {
    optimum.run = std::move(before);
    optimum.first = std::move(first_before);
  }
  return optimum;
}

}  // namespace limbwave::estimate
