/// What running a body filter forward, and both ways, have in common. Internal to body_smoother.cpp, body_batch.cpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "estimate/body_smoother.h"

namespace limbwave::estimate {

inline void append_pose(const BodyFilter& filter, const BodyState& state, BodyTrack& track) {
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

// The root by its feet.
inline void place_root(const RootPlace& place, BodyTrack& track, std::size_t at) {
  track.root_p_W[at] = place.p;
  track.root_sigma[at] = place.sigma;
}

inline void append_sigma(PoseSigma sigma, BodyTrack& track) {
  track.sigma.push_back(std::move(sigma.joints));
  track.point_sigma.push_back(std::move(sigma.points));
  track.root_sigma.push_back(sigma.root);
}

// The covariance of the joints' degrees of freedom.
inline Eigen::MatrixXd joint_covariance(const double* rows, long stride, int dofs) {
  return Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>(rows, dofs, dofs, Eigen::OuterStride<>(stride));
}

inline void reserve(BodyTrack& track, std::size_t count) {
  track.times.reserve(count);
  track.R_joint.reserve(count);
  track.root_p_W.reserve(count);
  track.sigma.reserve(count);
  track.point_sigma.reserve(count);
  track.root_sigma.reserve(count);
}

// Which instants get a pose.
inline std::vector<char> chosen(const std::vector<BodyInstant>& instants, double rate_hz) {
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
class BodyRunner {
 public:
  BodyRunner(const BodyModel& model, const BodyFilterParameters& parameters, const BodyReadings& readings,
             double rate_hz, BodyStepHook* hook)
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

  void step(std::size_t i, StepRecord* record = nullptr, const BodyState* about = nullptr) {
    const bool with_root = filter.parameters().root == RootMode::kGiven && !readings_.root.empty() &&
                           (instants[i].inertials > 0 || !any_inertial_);
    const BodyInstant used = hook_ != nullptr ? hook_->before(filter, instants[i], i, record) : instants[i];
    if (with_root) {
      const RootReading root = root_at(readings_.root, instants[i].time_s);
      filter.step(used, &root, record, about);
    } else {
      filter.step(used, nullptr, record, about);
    }
    if (hook_ != nullptr) {
      hook_->after(filter, used, i, record);
    }
  }

  /// Checks and starts: what every run begins with. Findings of the start go to `run`.
  Status begin(BodyRun& run) {
    if (Status status = check(); !status) {
      return status;
    }
    Result<Diagnostics> started = start();
    if (!started) {
      return started.error();
    }
    run.diagnostics = *std::move(started);
    return {};
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

  [[nodiscard]] const FootContacts* feet() const { return hook_ != nullptr ? hook_->feet() : nullptr; }

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

}  // namespace limbwave::estimate
