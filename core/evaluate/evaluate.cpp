#include "evaluate/evaluate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/units.h"
#include "geometry/so3.h"

namespace limbwave::evaluate {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

// Times this close are the same sample.
constexpr double kSameTime = 1e-6;
// Samples further apart than so many usual distances have a gap between them.
constexpr double kGap = 1.5;
// Somebody holds still who turns by less than this, and moves by less, in the time before and after. A limb that
// starts to move by 0.2 mm in a quarter of a second is accelerated by 0.6 mg, which looks like 0.04°.
constexpr double kStill_s = 0.25;
constexpr double kStillAngle = radians(0.02);
constexpr double kStillWay_m = 2e-4;

struct Pose {
  Quaterniond R_WL;
  Vector3d p_WL;  // NaN: not known
};

// One segment's truth, asked for at increasing times.
class TruthTrack {
 public:
  explicit TruthTrack(const Truth::SegmentTruth& truth) : truth_(truth) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < truth.times.size(); ++i) {
      steps.push_back(truth.times[i] - truth.times[i - 1]);
    }
    if (!steps.empty()) {
      const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
      std::nth_element(steps.begin(), middle, steps.end());
      longest_step_ = kGap * *middle;
    }
  }

  [[nodiscard]] std::optional<Pose> at(double time_s) const {
    const auto after = std::lower_bound(truth_.times.begin(), truth_.times.end(), time_s - kSameTime);
    if (after == truth_.times.end()) {
      return {};
    }
    const auto b = static_cast<std::size_t>(after - truth_.times.begin());
    if (truth_.times[b] <= time_s + kSameTime) {
      return Pose{truth_.R_WL[b], position(b)};
    }
    if (b == 0 || truth_.times[b] - truth_.times[b - 1] > longest_step_) {
      return {};
    }
    const std::size_t a = b - 1;
    const double u = (time_s - truth_.times[a]) / (truth_.times[b] - truth_.times[a]);
    return Pose{truth_.R_WL[a].slerp(u, truth_.R_WL[b]), position(a) + u * (position(b) - position(a))};
  }

 private:
  [[nodiscard]] Vector3d position(std::size_t i) const {
    return i < truth_.p_WL.size() ? truth_.p_WL[i] : Vector3d(Vector3d::Constant(NAN));
  }

  const Truth::SegmentTruth& truth_;
  double longest_step_ = 0.0;
};

// Whether nobody moves about this time; where the truth tells nothing of before or after, it is not still.
bool is_still(const std::vector<std::optional<TruthTrack>>& tracks, const std::vector<std::optional<Pose>>& now,
              double time_s) {
  constexpr int kSteps = 4;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    if (!tracks[i]) {
      continue;
    }
    if (!now[i]) {
      return false;
    }
    for (int step = -kSteps; step <= kSteps; ++step) {
      const std::optional<Pose> then = tracks[i]->at(time_s + kStill_s * step / kSteps);
      // Positions that are not known compare as near.
      if (!then || geometry::geodesic_angle(then->R_WL, now[i]->R_WL) > kStillAngle ||
          (then->p_WL - now[i]->p_WL).norm() > kStillWay_m) {
        return false;
      }
    }
  }
  return true;
}

struct Errors {
  std::vector<double> angle, inclination, distance;

  void add(const Errors& other) {
    angle.insert(angle.end(), other.angle.begin(), other.angle.end());
    inclination.insert(inclination.end(), other.inclination.begin(), other.inclination.end());
    distance.insert(distance.end(), other.distance.begin(), other.distance.end());
  }
};

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) {
    sum += value;
  }
  return sum / static_cast<double>(values.size());
}

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) {
    sum += value * value;
  }
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double deviation(const std::vector<double>& values, double about) {
  double sum = 0.0;
  for (const double value : values) {
    sum += (value - about) * (value - about);
  }
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double percentile(std::vector<double> values, double fraction) {
  std::sort(values.begin(), values.end());
  const double place = fraction * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(place));
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - std::floor(place)) * (values[above] - values[below]);
}

ErrorStatistics statistics(const Errors& errors) {
  ErrorStatistics s;
  if (!errors.angle.empty()) {
    const double average = mean(errors.angle);
    s.mean_deg = degrees(average);
    s.sd_deg = degrees(deviation(errors.angle, average));
    s.rms_deg = degrees(rms(errors.angle));
    s.p95_deg = degrees(percentile(errors.angle, 0.95));
    s.max_deg = degrees(*std::max_element(errors.angle.begin(), errors.angle.end()));
  }
  if (!errors.distance.empty()) {
    s.position_mean_mm = mean(errors.distance) * 1e3;
  }
  if (!errors.inclination.empty()) {
    s.inclination_mean_deg = degrees(mean(errors.inclination));
    s.inclination_rms_deg = degrees(rms(errors.inclination));
    s.inclination_max_deg = degrees(*std::max_element(errors.inclination.begin(), errors.inclination.end()));
  }
  return s;
}

}  // namespace

Result<Evaluation> evaluate(const motion::Clip& clip, double clip_start_s, const Truth& truth) {
  const std::vector<body::Segment>& segments = clip.skeleton.segments;
  std::vector<std::optional<TruthTrack>> tracks(segments.size());
  bool matched = false;
  for (const Truth::SegmentTruth& segment : truth.segments) {
    const int found = clip.skeleton.find(segment.name);
    if (found >= 0) {
      tracks[static_cast<std::size_t>(found)].emplace(segment);
      matched = true;
    }
  }
  if (!matched) {
    return Error{"the truth has none of the clip's segments", clip.name, "check that their names are the same"};
  }

  std::vector<Errors> joints(segments.size());
  std::vector<Errors> world(segments.size());
  std::vector<std::optional<Pose>> real(segments.size());
  std::vector<body::SegmentPose> poses;
  bool covered = false;
  Errors still;
  std::size_t instants = 0;
  std::size_t still_instants = 0;
  std::vector<double> times = motion::key_times(clip);
  if (times.empty()) {
    times.push_back(0.0);
  }
  for (const double time : times) {
    motion::pose_at(clip, time, poses);
    for (std::size_t i = 0; i < segments.size(); ++i) {
      real[i] = tracks[i] ? tracks[i]->at(clip_start_s + time) : std::nullopt;
    }
    const bool holds_still = is_still(tracks, real, clip_start_s + time);
    instants += std::any_of(real.begin(), real.end(), [](const auto& pose) { return pose.has_value(); }) ? 1 : 0;
    still_instants += holds_still ? 1 : 0;
    Vector3d shift = Vector3d::Zero();
    if (clip.root_position.empty()) {
      shift = real[0] ? Vector3d(real[0]->p_WL - poses[0].p_WL) : Vector3d(Vector3d::Constant(NAN));
    }
    for (std::size_t i = 0; i < segments.size(); ++i) {
      if (!real[i]) {
        continue;
      }
      covered = true;
      const Quaterniond& R = poses[i].R_WL;
      world[i].angle.push_back(geometry::geodesic_angle(R, real[i]->R_WL));
      world[i].inclination.push_back(
          geometry::angle_between(R.conjugate() * Vector3d::UnitZ(), real[i]->R_WL.conjugate() * Vector3d::UnitZ()));
      const double distance = (poses[i].p_WL + shift - real[i]->p_WL).norm();
      if (std::isfinite(distance)) {
        world[i].distance.push_back(distance);
      }
      if (holds_still) {
        still.angle.push_back(world[i].angle.back());
        still.inclination.push_back(world[i].inclination.back());
        if (std::isfinite(distance)) {
          still.distance.push_back(distance);
        }
      }
      const int parent = segments[i].parent;
      if (parent >= 0 && real[static_cast<std::size_t>(parent)]) {
        const auto p = static_cast<std::size_t>(parent);
        joints[i].angle.push_back(
            geometry::geodesic_angle(poses[p].R_WL.conjugate() * R, real[p]->R_WL.conjugate() * real[i]->R_WL));
        if (std::isfinite(distance)) {
          joints[i].distance.push_back(distance);
        }
      }
    }
  }
  if (!covered) {
    return Error{"the truth covers none of the clip's keys", clip.name, "check that both belong to the same take"};
  }

  Evaluation evaluation;
  Errors all;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (!joints[i].angle.empty()) {
      evaluation.joints[segments[i].name] = statistics(joints[i]);
    }
    if (!world[i].angle.empty()) {
      evaluation.segments[segments[i].name] = statistics(world[i]);
      all.add(world[i]);
    }
  }
  evaluation.all = statistics(all);
  evaluation.still = statistics(still);
  evaluation.still_fraction = static_cast<double>(still_instants) / static_cast<double>(instants);
  return evaluation;
}

nlohmann::json evaluation_to_json(const Evaluation& evaluation) {
  using Json = nlohmann::json;
  const auto put = [](Json& json, const char* key, double value) {
    if (!std::isnan(value)) {
      json[key] = value;
    }
  };
  const auto angles = [&](const ErrorStatistics& s, bool everything) {
    Json json = Json::object();
    put(json, "mean_deg", s.mean_deg);
    put(json, "sd_deg", s.sd_deg);
    if (everything) {
      put(json, "rms_deg", s.rms_deg);
      put(json, "p95_deg", s.p95_deg);
      put(json, "max_deg", s.max_deg);
    }
    put(json, "position_mean_mm", s.position_mean_mm);
    put(json, "inclination_mean_deg", s.inclination_mean_deg);
    put(json, "inclination_rms_deg", s.inclination_rms_deg);
    put(json, "inclination_max_deg", s.inclination_max_deg);
    return json;
  };
  Json json = Json::object();
  for (const auto& [name, s] : evaluation.joints) {
    json["joints"][name] = angles(s, true);
  }
  for (const auto& [name, s] : evaluation.segments) {
    json["segments"][name] = angles(s, true);
  }
  json["all"] = angles(evaluation.all, false);
  if (evaluation.still_fraction > 0.0) {
    json["still"] = angles(evaluation.still, false);
    json["still"]["fraction"] = evaluation.still_fraction;
  }
  const auto seconds = [&](const char* key, double value) {
    if (value > 0.0) {
      json["seconds"][key] = value;
    }
  };
  seconds("take", evaluation.take_seconds);
  seconds("decode", evaluation.decode_seconds);
  seconds("solve", evaluation.solve_seconds);
  return json;
}

}  // namespace limbwave::evaluate
