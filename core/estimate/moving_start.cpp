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
  BodyWatch hook(model, watch);
  constexpr double kPoses = 30.0;  // a second; nobody sees them
  Result<BodyOptimum> optimum = optimise_body(model, parameters, first, kPoses, progress, &hook, start.rounds);
  if (!optimum) {
    return optimum.error();
  }
  if (optimum->best == 0) {
    return none;
  }
  return std::optional<BodyState>(std::move(optimum->first));
}

}  // namespace limbwave::estimate
