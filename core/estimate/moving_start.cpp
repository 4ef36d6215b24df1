#include "estimate/moving_start.h"

#include <algorithm>
#include <cmath>

#include "estimate/body_batch.h"

namespace limbwave::estimate {
namespace {

template <typename T>
std::vector<T> until(const std::vector<T>& readings, double time_s) {
  std::vector<T> first;
  std::copy_if(readings.begin(), readings.end(), std::back_inserter(first),
               [&](const T& reading) { return reading.time_s < time_s; });
  return first;
}

// A state whose boards feel gravity as they felt it on average, as far as a moving body tells; the rest as it was.
BodyState inclined(const BodyFilter& filter, std::vector<BoardAtRest> boards) {
  constexpr double kMovingForce = 1.5;  // m/s², of a mean over a second
  constexpr double kAnyPose = 0.8;      // rad
  for (BoardAtRest& board : boards) {
    board.moved = board.turned = false;
  }
  Eigen::VectorXd prior(filter.layout().size);
  for (int i = 0; i < filter.layout().size; ++i) {
    prior[i] = std::sqrt(filter.covariance()(i, i));
  }
  const bool free = filter.tree().root_motion() == body::RootMotion::kFree;
  for (int i = free ? 6 : 0; i < filter.layout().dofs; ++i) {
    prior[i] = kAnyPose;
  }
  BodyState state = filter.state();
  refine_at_rest(filter, boards, prior, kMovingForce, state);
  return state;
}

}  // namespace

Result<std::optional<BodyState>> find_moving_start(const BodyModel& model, const BodyFilterParameters& parameters,
                                                   const BodyWatchParameters& watch, const BodyReadings& readings,
                                                   const Progress& progress, const MovingStartParameters& start) {
  const std::optional<BodyState> none;
  if (watch.rest.mode == StartMode::kRest || !parameters.use_ranges || readings.ranges.empty() ||
      readings.inertial.empty() || model.boards.size() < 2) {
    return none;
  }
  BodyFilter probe(model, parameters);
  const bool given = parameters.root == RootMode::kGiven && !readings.root.empty();
  RootReading root;
  if (given) {
    root = root_at(readings.root, std::min(readings.inertial.front().time_s, readings.ranges.front().time_s));
  }
  const Result<RestStart> rest = start_at_rest(probe, readings, watch.rest, given ? &root : nullptr);
  if (!rest) {
    return rest.error();
  }
  if (!rest->moving && !rest->strange) {
    return none;
  }
  const double end = std::min(readings.inertial.front().time_s, readings.ranges.front().time_s) + start.seconds;
  const BodyReadings first{until(readings.inertial, end), until(readings.ranges, end), readings.root};
  // From the rest pose, and from limbs that are inclined as gravity was felt on average.
  const BodyState by_gravity = inclined(probe, rest->boards);
  std::optional<BodyState> found;
  double plain = 0.0;
  double least = 0.0;
  for (int candidate = 0; candidate < 2; ++candidate) {
    BodyWatchParameters wide = watch;
    wide.rest.found_pose = wide.rest.moving_pose;
    wide.rest.found_rate = wide.rest.moving_rate;
    wide.rest.found_acceleration = wide.rest.moving_acceleration;
    BodyWatch hook(model, wide);
    if (candidate == 1) {
      hook.start_near(by_gravity);
    }
    constexpr double kPoses = 30.0;  // a second; nobody sees them
    Result<BodyOptimum> optimum = optimise_body(
        model, parameters, first, kPoses, progress.part(0.5 * candidate, 0.5 * (candidate + 1)), &hook, start.rounds);
    if (!optimum) {
      return optimum.error();
    }
    const double cost = optimum->costs[optimum->best];
    plain = candidate == 0 ? optimum->costs.front() : plain;
    if (candidate == 0 || cost < least) {
      least = cost;
      found = std::move(optimum->first);
    }
  }
  // Σ ν²/σ² of what fits is about the number of readings; more says that nothing was found.
  const double count = 6.0 * static_cast<double>(first.inertial.size()) + static_cast<double>(first.ranges.size());
  return least < start.worthwhile * plain && least < count ? found : none;
}

}  // namespace limbwave::estimate
