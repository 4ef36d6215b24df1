/// The body filter as a stream: readings in, poses out. Depends on the readings alone, not on how they arrive: the
/// poses are, to the last bit, those of `filter_body` over the same readings.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "estimate/body_watch.h"
#include "estimate/fixed_lag.h"

namespace limbwave::estimate {

struct TrackerSettings {
  double rate_hz = 120.0;  ///< Poses a second at most.
  double lag_s = 0.0;      ///< Of the fixed-lag smoother; 0: none.
};

struct TrackedPose {
  double time_s = 0.0;
  std::vector<Quaterniond> R_joint;  ///< Per segment, away from rest.
  Vector3d root_p_W = Vector3d::Zero();
};

class BodyTracker {
 public:
  BodyTracker(const BodyModel& model, const BodyFilterParameters& parameters, const BodyWatchParameters& watch,
              const TrackerSettings& settings);

  /// The root's path where it is given; before anything else.
  void set_root(std::vector<RootReading> path) { root_ = std::move(path); }
  /// New readings, each list in order of time among itself or not. No reading before `complete_s` will come any more;
  /// those that do are dropped and counted. Fails when the start refuses (StartMode::kRest); then nothing follows.
  Status push(std::span<const InertialReading> inertial, std::span<const RangeReading> ranges, double complete_s);
  /// There is nothing more.
  Status finish();

  /// Poses since the last call, in order of time: the filter's, and those of the fixed-lag smoother.
  std::vector<TrackedPose> take_poses();
  std::vector<TrackedPose> take_smoothed();

  [[nodiscard]] bool started() const { return started_; }
  [[nodiscard]] const BodyFilter& filter() const { return filter_; }
  [[nodiscard]] const BodyWatch& watch() const { return watch_; }
  [[nodiscard]] std::int64_t late() const { return late_; }  ///< Readings that came behind their time.
  /// The start's findings and those since.
  [[nodiscard]] Diagnostics findings() const;

 private:
  Status run(double until_s, bool all);
  void step(const BodyInstant& instant);
  [[nodiscard]] TrackedPose pose(const BodyState& state) const;

  TrackerSettings settings_;
  BodyFilter filter_;
  BodyWatch watch_;
  FixedLag lag_;
  std::vector<RootReading> root_;
  BodyReadings pending_;
  Diagnostics start_findings_;
  double window_s_, complete_s_ = -1e300, next_pose_ = -1e300;
  std::size_t number_ = 0;
  std::int64_t late_ = 0;
  bool started_ = false;
  std::optional<Error> refused_;
  std::vector<TrackedPose> poses_, smoothed_;
};

}  // namespace limbwave::estimate
