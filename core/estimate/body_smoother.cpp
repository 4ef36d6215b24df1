#include "estimate/body_smoother.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "geometry/so3.h"

namespace limbwave::estimate {
namespace {

using Eigen::VectorXd;

void append_pose(const BodyFilter& filter, const BodyState& state, BodyTrack& track) {
  track.times.push_back(state.time_s);
  const double delay = filter.parameters().reading_delay_s;
  if (delay > 0.0) {
    // What has been read is that long ago; the pose is wanted for now.
    body::TreeState now = state.joints;
    filter.tree().add(now, delay * now.qd + 0.5 * delay * delay * now.qdd);
    track.R_joint.push_back(filter.tree().segment_rotations(now));
    track.root_p_W.push_back(filter.tree().root_position(now));
    return;
  }
  track.R_joint.push_back(filter.tree().segment_rotations(state.joints));
  track.root_p_W.push_back(filter.tree().root_position(state.joints));
}

void append_sigma(PoseSigma sigma, BodyTrack& track) {
  track.sigma.push_back(std::move(sigma.joints));
  track.point_sigma.push_back(std::move(sigma.points));
  track.root_sigma.push_back(sigma.root);
}

// The covariance of the joints' degrees of freedom.
Eigen::MatrixXd joint_covariance(const double* rows, long stride, int dofs) {
  return Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>(rows, dofs, dofs, Eigen::OuterStride<>(stride));
}

void reserve(BodyTrack& track, std::size_t count) {
  track.times.reserve(count);
  track.R_joint.reserve(count);
  track.root_p_W.reserve(count);
  track.sigma.reserve(count);
  track.point_sigma.reserve(count);
  track.root_sigma.reserve(count);
}

// Which instants get a pose.
std::vector<char> chosen(const std::vector<BodyInstant>& instants, double rate_hz) {
  const bool inertial = std::any_of(instants.begin(), instants.end(), [](const auto& i) { return i.inertials > 0; });
  std::vector<char> wanted(instants.size(), 0);
  double next = -1e300;
  for (std::size_t i = 0; i < instants.size(); ++i) {
    if ((instants[i].inertials > 0 || !inertial) && instants[i].time_s >= next - 1e-4 / rate_hz) {
      wanted[i] = 1;
      next = std::max(next + 1.0 / rate_hz, instants[i].time_s + 0.5 / rate_hz);
    }
  }
  return wanted;
}

// The filter over one recording: what both directions share.
class Run {
 public:
  Run(const BodyModel& model, const BodyFilterParameters& parameters, const BodyReadings& readings, double rate_hz,
      BodyStepHook* hook)
      : readings_(readings), hook_(hook), filter(model, parameters) {
    for (const BodyInstant& instant : instants_of(readings)) {
      const bool inertial = instant.inertials > 0 && (parameters.use_gyroscopes || parameters.use_accelerometers);
      if (inertial || (instant.range_count > 0 && parameters.use_ranges)) {
        instants.push_back(instant);
      }
    }
    wanted = chosen(instants, rate_hz);
    any_inertial_ = std::any_of(instants.begin(), instants.end(), [](const auto& i) { return i.inertials > 0; });
  }

  void step(std::size_t i, StepRecord* record = nullptr) {
    const bool with_root = filter.parameters().root == RootMode::kGiven && !readings_.root.empty() &&
                           (instants[i].inertials > 0 || !any_inertial_);
    const BodyInstant used = hook_ != nullptr ? hook_->before(filter, instants[i], i, record) : instants[i];
    if (with_root) {
      const RootReading root = root_at(readings_.root, instants[i].time_s);
      filter.step(used, &root, record);
    } else {
      filter.step(used, nullptr, record);
    }
    if (hook_ != nullptr) {
      hook_->after(filter, used, i, record);
    }
  }

  Result<Diagnostics> start() {
    return hook_ != nullptr ? hook_->start(filter, readings_) : start_from_rest(filter, readings_);
  }

  Status check() const {
    if (instants.empty()) {
      return Error{"there is no reading of the sensors that shall be used", "", "choose other sensors"};
    }
    if (filter.parameters().root == RootMode::kGiven && readings_.root.empty()) {
      return Error{"the root is said to be given, but there is no path of it", "", "give one, or let the root be free"};
    }
    return {};
  }

  void finish(BodyRun& run) const {
    if (hook_ != nullptr) {
      hook_->finished(filter);
    }
    run.last = filter.state();
    run.log_likelihood = filter.log_likelihood();
    run.gyroscopes = filter.gyroscope_counts();
    run.accelerometers = filter.accelerometer_counts();
    run.ranges = filter.range_counts();
  }

 private:
  const BodyReadings& readings_;
  BodyStepHook* hook_;
  bool any_inertial_ = false;

 public:
  BodyFilter filter;
  std::vector<BodyInstant> instants;
  std::vector<char> wanted;
};

Error stopped() {
  return cancelled();
}

}  // namespace

Result<BodyRun> filter_body(const BodyModel& model, const BodyFilterParameters& parameters,
                            const BodyReadings& readings, double rate_hz, const Progress& progress,
                            BodyStepHook* hook) {
  Run run(model, parameters, readings, rate_hz, hook);
  if (Status status = run.check(); !status) {
    return status.error();
  }
  BodyRun result;
  Result<Diagnostics> started = run.start();
  if (!started) {
    return started.error();
  }
  result.diagnostics = *std::move(started);
  reserve(result.track, run.instants.size());
  const int dofs = run.filter.layout().dofs;
  for (std::size_t i = 0; i < run.instants.size(); ++i) {
    run.step(i);
    if (run.wanted[i] != 0) {
      append_pose(run.filter, run.filter.state(), result.track);
      const ErrorCovariance& P = run.filter.covariance();
      append_sigma(pose_sigma(run.filter.tree(), model.skeleton, run.filter.state().joints,
                              joint_covariance(P.row(0), P.stride(), dofs), {}),
                   result.track);
    }
    if (i % 64 == 0 && !progress.report(static_cast<double>(i) / static_cast<double>(run.instants.size()))) {
      return stopped();
    }
  }
  run.finish(result);
  return result;
}

Result<BodyRun> smooth_body(const BodyModel& model, const BodyFilterParameters& parameters,
                            const BodyReadings& readings, double rate_hz, const Progress& progress, double stretch_s,
                            BodyStepHook* hook) {
  Run run(model, parameters, readings, rate_hz, hook);
  if (Status status = run.check(); !status) {
    return status.error();
  }
  BodyRun result;
  Result<Diagnostics> started = run.start();
  if (!started) {
    return started.error();
  }
  result.diagnostics = *std::move(started);
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
    run.step(i);
    if (i % 64 == 0 && !progress.report(0.5 * static_cast<double>(i) / static_cast<double>(count))) {
      return stopped();
    }
  }
  run.finish(result);

  const int size = run.filter.layout().size;
  const int dofs = run.filter.layout().dofs;
  SampledAdjoint adjoint(size);
  struct Kept {
    StepRecord record;
    BodyState state;
    AlignedRows P_theta;  // rows: joint degrees of freedom
  };
  std::vector<Kept> kept;
  BodyTrack reversed;
  std::size_t end = count;
  while (!checkpoints.empty()) {
    const Checkpoint& checkpoint = checkpoints.back();
    run.filter.resume(checkpoint.snapshot);
    if (kept.size() < end - checkpoint.first) {
      kept.resize(end - checkpoint.first);
    }
    for (std::size_t i = checkpoint.first; i < end; ++i) {
      Kept& k = kept[i - checkpoint.first];
      run.step(i, &k.record);
      if (run.wanted[i] != 0) {
        k.state = run.filter.state();
        const ErrorCovariance& P = run.filter.covariance();
        k.P_theta.resize(dofs, P.stride());
        std::copy_n(P.row(0), dofs * P.stride(), k.P_theta.row(0));
      }
    }
    for (std::size_t i = end; i-- > checkpoint.first;) {
      Kept& k = kept[i - checkpoint.first];
      if (run.wanted[i] != 0) {
        const SampledAdjoint::Rows changes = adjoint.changes(k.P_theta);
        run.filter.tree().add(k.state.joints, -changes.col(0));
        append_pose(run.filter, k.state, reversed);
        append_sigma(pose_sigma(run.filter.tree(), model.skeleton, k.state.joints,
                                joint_covariance(k.P_theta.row(0), k.P_theta.columns(), dofs),
                                changes.rightCols<SampledAdjoint::kSamples>()),
                     reversed);
      }
      adjoint.over_step(k.record, run.filter.tree());
    }
    end = checkpoint.first;
    checkpoints.pop_back();
    if (!progress.report(1.0 - 0.5 * static_cast<double>(end) / static_cast<double>(count))) {
      return stopped();
    }
  }
  const auto reverse = [](auto& values) { std::reverse(values.begin(), values.end()); };
  reverse(reversed.times);
  reverse(reversed.R_joint);
  reverse(reversed.root_p_W);
  reverse(reversed.sigma);
  reverse(reversed.point_sigma);
  reverse(reversed.root_sigma);
  result.track = std::move(reversed);
  return result;
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
