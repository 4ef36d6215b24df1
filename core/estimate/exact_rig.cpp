#include "estimate/exact_rig.h"

#include <algorithm>
#include <cmath>

#include "estimate/body_smoother.h"

namespace limbwave::estimate {
namespace {

constexpr double kLookedAt = 4.0;  // seconds
constexpr double kSettled = 2.0;   // of these, until the start is forgotten
constexpr double kMostNis = 2.0;   // per scalar, on average over that time; 1 where there is only white noise
constexpr std::int64_t kLeast = 50;
constexpr std::int64_t kLeastRanges = 200;

// Mean of what was added to a count.
bool contradicted(const ReadingCount& before, const ReadingCount& after) {
  const std::int64_t count = after.used + after.gated - before.used - before.gated;
  return count >= kLeast && (after.nis_sum - before.nis_sum) / static_cast<double>(count) > kMostNis;
}

bool contradicted(const std::vector<ReadingCount>& before, const std::vector<ReadingCount>& after) {
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (contradicted(before[i], after[i])) {
      return true;
    }
  }
  return false;
}

}  // namespace

BodyFilterParameters exact_parameters(const BodyFilterParameters& parameters) {
  BodyFilterParameters p = parameters;
  for (double* constant : {&p.gyroscope_bias, &p.accelerometer_bias, &p.mount_rotation, &p.mount_place, &p.source_place,
                           &p.tissue_angle, &p.range_offset, &p.sound_scale, &p.bone_scale, &p.gyroscope_relative,
                           &p.accelerometer_relative, &p.limit_softness}) {
    *constant = 0.0;
  }
  p.range_model = 0.0005;
  p.acceleration_walk = 500.0;
  p.root_acceleration_walk = 300.0;
  return p;
}

bool rig_is_exact(const BodyModel& model, const BodyFilterParameters& parameters, const BodyReadings& readings) {
  // Inertial readings alone cannot tell: whatever one board says of its mounting, free limbs can have done.
  if (!parameters.use_ranges || readings.ranges.size() < kLeastRanges || !parameters.use_gyroscopes ||
      !parameters.use_accelerometers || parameters.root == RootMode::kFree || model.boards.size() < 2 ||
      readings.inertial.empty() || (parameters.root == RootMode::kGiven && readings.root.empty())) {
    return false;
  }
  BodyFilter filter(model, exact_parameters(parameters));
  start_from_rest(filter, readings);
  const double begin = readings.inertial.front().time_s;
  std::vector<ReadingCount> gyroscopes;
  std::vector<ReadingCount> accelerometers;
  std::vector<ReadingCount> ranges;
  bool settled = false;
  for (const BodyInstant& instant : instants_of(readings)) {
    if (instant.time_s > begin + kLookedAt) {
      break;
    }
    if (!settled && instant.time_s > begin + kSettled) {
      settled = true;
      gyroscopes = filter.gyroscope_counts();
      accelerometers = filter.accelerometer_counts();
      ranges = filter.range_counts();
    }
    if (instant.inertials > 0 && parameters.root == RootMode::kGiven) {
      const RootReading root = root_at(readings.root, instant.time_s);
      filter.step(instant, &root);
    } else {
      filter.step(instant, nullptr);
    }
  }
  std::int64_t compared = 0;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const ReadingCount& after = filter.range_counts()[i];
    compared += after.used + after.gated - ranges[i].used - ranges[i].gated;
  }
  return settled && compared >= kLeastRanges && !contradicted(gyroscopes, filter.gyroscope_counts()) &&
         !contradicted(accelerometers, filter.accelerometer_counts()) && !contradicted(ranges, filter.range_counts());
}

}  // namespace limbwave::estimate
