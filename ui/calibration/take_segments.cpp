#include "calibration/take_segments.h"

#include <algorithm>

#include "solve/decoded_take.h"
#include "solve/take_calibration.h"

namespace limbwave::ui {
namespace {

const take::TakeSegment* find_segment(const take::Take& take, const std::string& name) {
  const auto found = std::find_if(take.info.segments.begin(), take.info.segments.end(),
                                  [&](const take::TakeSegment& segment) { return segment.name == name; });
  return found == take.info.segments.end() ? nullptr : &*found;
}

}  // namespace

bool has_range_segment(const take::Take& take) {
  return find_segment(take, solve::kRangeSegment) != nullptr;
}

std::vector<int> groups_in_take(const take::Take& take) {
  std::vector<int> groups;
  for (std::size_t g = 0; g < take.info.rig.groups.size(); ++g) {
    const body::CalibrationGroup& group = take.info.rig.groups[g];
    if (find_segment(take, solve::pose_segment(group, 0)) != nullptr &&
        find_segment(take, solve::pose_segment(group, 1)) != nullptr) {
      groups.push_back(static_cast<int>(g));
    }
  }
  return groups;
}

Result<std::vector<RangeOutcome>> range_from_take(const take::Take& take, const Progress& progress) {
  const take::TakeSegment* segment = find_segment(take, solve::kRangeSegment);
  if (segment == nullptr) {
    return Error{"has no stretch in which sensors are turned", take.folder.string(),
                 "calibrate with a running capture"};
  }
  const Result<solve::DecodedTake> decoded = solve::decode_take(take, {}, progress.part(0.0, 0.8));
  if (!decoded) {
    return decoded.error();
  }
  const auto frames = decoded->of(take, *segment);
  std::vector<RangeOutcome> outcomes;
  const std::size_t count = take.info.rig.accelerometers.size();
  for (std::size_t s = 0; s < count; ++s) {
    if (!progress.report(0.8 + 0.2 * static_cast<double>(s) / static_cast<double>(count), "range")) {
      return cancelled();
    }
    calibrate::RangeCalibrator calibrator(take.info.rig.line_in, take.info.rig.accelerometers[s].serial);
    calibrator.push(calibrate::sensor_series(frames, static_cast<int>(s)));
    RangeOutcome outcome;
    outcome.sensor = static_cast<int>(s);
    outcome.visited = visited_cells(calibrator.progress());
    Result<calibrate::RangeResult> result = calibrator.finish(take.info.created);
    if (result) {
      outcome.result = std::move(result).value();
    } else {
      outcome.error = result.error();
    }
    outcomes.push_back(std::move(outcome));
  }
  return outcomes;
}

Result<LimbFromTake> limb_from_take(const take::Take& take, int group, const calibrate::RigCalibration& range,
                                    const Progress& progress) {
  const body::CalibrationGroup& limb = take.info.rig.groups.at(static_cast<std::size_t>(group));
  const take::TakeSegment* first = find_segment(take, solve::pose_segment(limb, 0));
  const take::TakeSegment* second = find_segment(take, solve::pose_segment(limb, 1));
  if (first == nullptr || second == nullptr) {
    return Error{"does not hold both poses of " + limb.name, take.folder.string(), "calibrate with a running capture"};
  }
  const Result<solve::DecodedTake> decoded = solve::decode_take(take, {}, progress);
  if (!decoded) {
    return decoded.error();
  }
  const Result<calibrate::LimbResult> result =
      solve::calibrate_limb(take, group, decoded->of(take, *first), decoded->of(take, *second), range);
  LimbFromTake found;
  found.group = group;
  found.refusal = result ? Error{} : result.error();
  for (const int sensor : limb.sensors) {
    LimbOutcome outcome;
    outcome.sensor = sensor;
    if (!result) {
      outcome.error = result.error();
    }
    found.outcomes.push_back(outcome);
  }
  for (std::size_t i = 0; result && i < result->sensors.size(); ++i) {
    found.outcomes.at(i).result = result->sensors[i];
  }
  return found;
}

}  // namespace limbwave::ui
