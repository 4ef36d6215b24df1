#include "estimate/body_tracker.h"

#include <algorithm>
#include <cmath>

namespace limbwave::estimate {
namespace {

constexpr double kSameInstant = 1e-6;  // as in instants_of

template <typename T>
void take_in(std::span<const T> fresh, double complete_s, std::vector<T>& pending, std::int64_t& late) {
  for (const T& reading : fresh) {
    if (reading.time_s < complete_s) {
      ++late;
    } else {
      pending.push_back(reading);
    }
  }
  std::stable_sort(pending.begin(), pending.end(), [](const T& a, const T& b) { return a.time_s < b.time_s; });
}

}  // namespace

BodyTracker::BodyTracker(const BodyModel& model, const BodyFilterParameters& parameters,
                         const BodyWatchParameters& watch, const TrackerSettings& settings)
    : settings_(settings),
      filter_(model, parameters),
      watch_(model, watch),
      lag_(settings.lag_s),
      window_s_(std::max(1.0, watch.rest.window_s)) {}

Status BodyTracker::push(std::span<const InertialReading> inertial, std::span<const RangeReading> ranges,
                         double complete_s) {
  if (refused_) {
    return *refused_;
  }
  take_in(inertial, complete_s_, pending_.inertial, late_);
  take_in(ranges, complete_s_, pending_.ranges, late_);
  complete_s_ = std::max(complete_s_, complete_s);
  return run(complete_s_, false);
}

Status BodyTracker::finish() {
  if (refused_) {
    return *refused_;
  }
  return run(INFINITY, true);
}

Status BodyTracker::run(double until_s, bool all) {
  const bool nothing = pending_.inertial.empty() && pending_.ranges.empty();
  if (nothing && !all) {
    return {};
  }
  if (!started_ && !nothing) {
    const double first = std::min(pending_.inertial.empty() ? INFINITY : pending_.inertial.front().time_s,
                                  pending_.ranges.empty() ? INFINITY : pending_.ranges.front().time_s);
    if (!all && until_s <= first + window_s_ + kSameInstant) {
      return {};
    }
    pending_.root = root_;
    Result<Diagnostics> found = watch_.start(filter_, pending_);
    pending_.root.clear();
    if (!found) {
      refused_ = found.error();
      return found.error();
    }
    start_findings_ = *std::move(found);
    started_ = true;
  }
  const std::vector<BodyInstant> instants = instants_of(pending_);
  const BodyFilterParameters& p = filter_.parameters();
  std::size_t inertials = 0;
  std::size_t ranges = 0;
  for (const BodyInstant& instant : instants) {
    if (instant.time_s + kSameInstant >= until_s) {
      break;
    }
    inertials += instant.inertials;
    ranges += instant.range_count;
    if ((instant.inertials > 0 && (p.use_gyroscopes || p.use_accelerometers)) ||
        (instant.range_count > 0 && p.use_ranges)) {
      step(instant);
    }
  }
  pending_.inertial.erase(pending_.inertial.begin(),
                          pending_.inertial.begin() + static_cast<std::ptrdiff_t>(inertials));
  pending_.ranges.erase(pending_.ranges.begin(), pending_.ranges.begin() + static_cast<std::ptrdiff_t>(ranges));
  if (settings_.lag_s > 0.0 && all) {
    while (const std::optional<BodyState> state = lag_.next(filter_, true)) {
      smoothed_.push_back(pose(*state));
    }
  }
  return {};
}

void BodyTracker::step(const BodyInstant& instant) {
  const BodyFilterParameters& p = filter_.parameters();
  const bool inertial = p.use_gyroscopes || p.use_accelerometers;
  StepRecord record;
  StepRecord* kept = settings_.lag_s > 0.0 ? &record : nullptr;
  const BodyInstant used = watch_.before(filter_, instant, number_, kept);
  const bool with_root = p.root == RootMode::kGiven && !root_.empty() && (instant.inertials > 0 || !inertial);
  if (with_root) {
    const RootReading root = root_at(root_, instant.time_s);
    filter_.step(used, &root, kept);
  } else {
    filter_.step(used, nullptr, kept);
  }
  watch_.after(filter_, used, number_, kept);
  ++number_;
  const bool wanted = (instant.inertials > 0 || !inertial) && instant.time_s >= next_pose_ - 1e-4 / settings_.rate_hz;
  if (wanted) {
    next_pose_ = std::max(next_pose_ + 1.0 / settings_.rate_hz, instant.time_s + 0.5 / settings_.rate_hz);
    poses_.push_back(pose(filter_.state()));
  }
  if (kept != nullptr) {
    lag_.push(filter_, std::move(record), wanted);
    while (const std::optional<BodyState> state = lag_.next(filter_)) {
      smoothed_.push_back(pose(*state));
    }
  }
}

TrackedPose BodyTracker::pose(const BodyState& state) const {
  const double delay = filter_.parameters().reading_delay_s;
  if (delay <= 0.0) {
    const FootContacts* feet = watch_.feet();
    return {state.time_s, filter_.tree().segment_rotations(state.joints),
            feet != nullptr ? feet->place(state.time_s).p : filter_.tree().root_position(state.joints)};
  }
  body::TreeState now = state.joints;
  filter_.tree().add(now, delay * now.qd + 0.5 * delay * delay * now.qdd);
  return {state.time_s, filter_.tree().segment_rotations(now), filter_.tree().root_position(now)};
}

std::vector<TrackedPose> BodyTracker::take_poses() {
  return std::exchange(poses_, {});
}

std::vector<TrackedPose> BodyTracker::take_smoothed() {
  return std::exchange(smoothed_, {});
}

Diagnostics BodyTracker::findings() const {
  Diagnostics found = start_findings_;
  const Diagnostics since = watch_.findings();
  found.insert(found.end(), since.begin(), since.end());
  return found;
}

}  // namespace limbwave::estimate
