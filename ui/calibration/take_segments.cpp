#include "calibration/take_segments.h"

#include <QCoreApplication>
#include <algorithm>

#include "common/shown_names.h"
#include "solve/decoded_take.h"
#include "solve/take_calibration.h"

namespace limbwave::ui {
namespace {

const take::TakeSegment* find_segment(const take::Take& take, const std::string& name) {
  const auto found = std::find_if(take.info.segments.begin(), take.info.segments.end(),
                                  [&](const take::TakeSegment& segment) { return segment.name == name; });
  return found == take.info.segments.end() ? nullptr : &*found;
}

/// lupdate knows this as the context "TakeSegments".
struct TakeSegments {
  Q_DECLARE_TR_FUNCTIONS(TakeSegments)
};

QString segment_title(const take::TakeInfo& info, const std::string& name) {
  if (name == solve::kRangeSegment) {
    return TakeSegments::tr("Sensors are turned");
  }
  for (const body::CalibrationGroup& group : info.rig.groups) {
    for (const int pose : {0, 1}) {
      if (name == solve::pose_segment(group, pose)) {
        return TakeSegments::tr("%1: %2").arg(shown_name(group.name),
                                              shown_name(pose == 0 ? group.first.name : group.second.name));
      }
    }
  }
  return name == "capture" ? TakeSegments::tr("Capture") : QString::fromStdString(name);
}

}  // namespace

std::vector<NamedStretch> named_stretches(const take::TakeInfo& info, const std::vector<std::string>& first) {
  std::vector<NamedStretch> list;
  for (const take::TakeSegment& segment : info.segments) {
    NamedStretch named;
    named.name = segment.name;
    named.title = segment_title(info, segment.name);
    named.stretch.begin_s = info.format.rate.seconds(segment.first).value;
    named.stretch.end_s = named.stretch.begin_s + info.format.rate.seconds(segment.count).value;
    if (segment.count.value > 0) {
      list.push_back(std::move(named));
    }
  }
  const auto rank = [&first](const NamedStretch& stretch) {
    return std::find(first.begin(), first.end(), stretch.name) - first.begin();
  };
  std::stable_sort(list.begin(), list.end(), [&rank](const NamedStretch& a, const NamedStretch& b) {
    return std::pair(rank(a), a.stretch.begin_s) < std::pair(rank(b), b.stretch.begin_s);
  });
  return list;
}

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

Result<std::vector<RangeOutcome>> range_outcomes(const take::TakeInfo& info,
                                                 std::span<const decode::AccelerationFrame> frames,
                                                 const Progress& progress) {
  std::vector<RangeOutcome> outcomes;
  const std::size_t count = info.rig.accelerometers.size();
  for (std::size_t s = 0; s < count; ++s) {
    if (!progress.report(static_cast<double>(s) / static_cast<double>(count), "range")) {
      return cancelled();
    }
    calibrate::RangeCalibrator calibrator(info.rig.line_in, info.rig.accelerometers[s].serial);
    calibrator.push(calibrate::sensor_series(frames, static_cast<int>(s)));
    RangeOutcome outcome;
    outcome.sensor = static_cast<int>(s);
    outcome.visited = visited_cells(calibrator.progress());
    Result<calibrate::RangeResult> result = calibrator.finish(info.created);
    if (result) {
      outcome.result = std::move(result).value();
    } else {
      outcome.error = result.error();
    }
    outcomes.push_back(std::move(outcome));
  }
  return outcomes;
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
  return range_outcomes(take.info, decoded->of(take, *segment), progress.part(0.8, 1.0));
}

LimbFromTake limb_outcomes(const take::Take& take, int group, std::span<const decode::AccelerationFrame> first,
                           std::span<const decode::AccelerationFrame> second, const calibrate::RigCalibration& range) {
  const body::CalibrationGroup& limb = take.info.rig.groups.at(static_cast<std::size_t>(group));
  const Result<calibrate::LimbResult> result = solve::calibrate_limb(take, group, first, second, range);
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
  return limb_outcomes(take, group, decoded->of(take, *first), decoded->of(take, *second), range);
}

}  // namespace limbwave::ui
