/// A simulated wearer of the driver box through the body filter, and how far off the result is.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/units.h"
#include "estimate/body_smoother.h"
#include "geometry/so3.h"
#include "simulate/body_readings.h"

namespace limbwave::testing_support {

/// The simulator's rows as the filter takes them; boards and sources have the same order in both.
inline estimate::BodyReadings readings_of(const simulate::SimulatedReadings& simulated) {
  estimate::BodyReadings readings;
  for (const simulate::BoardRow& row : simulated.boards) {
    readings.inertial.push_back({row.time_s, row.board, row.w_S, row.f_S});
  }
  for (const simulate::RangeRow& row : simulated.ranges) {
    readings.ranges.push_back({row.time_s, row.source, row.board, row.range, row.confidence});
  }
  for (const simulate::TruthRow& row : simulated.truth) {
    readings.root.push_back({row.time_s, row.poses.front().R_WL, row.poses.front().p_WL});
  }
  return readings;
}

struct Errors {
  double sum = 0.0, square = 0.0, largest = 0.0;
  double stated = 0.0;  ///< Sum of variances that were stated for these errors.
  int count = 0;
  void add(double e, double sigma = 0.0) {
    sum += e;
    square += e * e;
    stated += sigma * sigma;
    largest = std::max(largest, e);
    ++count;
  }
  [[nodiscard]] double mean() const { return count == 0 ? 0.0 : sum / count; }
  [[nodiscard]] double rms() const { return count == 0 ? 0.0 : std::sqrt(square / count); }
  [[nodiscard]] double sd() const {
    return count == 0 ? 0.0 : std::sqrt(std::max(0.0, square / count - mean() * mean()));
  }
  [[nodiscard]] double sigma() const { return count == 0 ? 0.0 : std::sqrt(stated / count); }
};

/// Geodesic errors of joints (relative to the parent), degrees, by name of the segment; and "all".
class JointErrors {
 public:
  void add(const body::Skeleton& skeleton, const std::vector<Eigen::Quaterniond>& R_joint,
           const std::vector<body::SegmentPose>& truth, const std::vector<float>* sigma = nullptr) {
    for (std::size_t i = 1; i < skeleton.segments.size(); ++i) {
      const body::Segment& segment = skeleton.segments[i];
      const Eigen::Quaterniond R_true =
          truth[static_cast<std::size_t>(segment.parent)].R_WL.conjugate() * truth[i].R_WL;
      const double e = degrees(geometry::geodesic_angle(R_true, segment.R_PL_rest * R_joint[i]));
      const double stated = sigma != nullptr ? degrees((*sigma)[i]) : 0.0;
      by_name[segment.name].add(e, stated);
      all.add(e, stated);
    }
  }
  std::map<std::string, Errors> by_name;
  Errors all;
};

/// A wearer with his rig, and what his boards say.
struct Wearer {
  body::Rig rig;
  body::Skeleton skeleton;  ///< As the filter believes it.
  std::shared_ptr<const simulate::DriverBoxActor> actor;
  estimate::BodyReadings readings;

  [[nodiscard]] std::vector<body::SegmentPose> truth(double time_s) const {
    std::vector<simulate::FrameJet> frames;
    actor->frames(time_s, frames);
    std::vector<body::SegmentPose> poses;
    for (const simulate::FrameJet& frame : frames) {
      poses.push_back({frame.R_W.v, frame.p_W.v});
    }
    return poses;
  }
};

/// `rest_s`: seconds of standing still before the motion. `metres`: of a BVH file's unit; 0: guessed.
inline Result<Wearer> make_wearer(const std::string& motion, const simulate::DriverBoxErrors& errors,
                                  std::uint64_t seed, double rest_s, double seconds = 0.0, double metres = 0.0) {
  auto rig = body::load_rig("driver-box-body");
  if (!rig) {
    return rig.error();
  }
  auto skeleton = body::load_skeleton(rig->skeleton);
  if (!skeleton) {
    return skeleton.error();
  }
  auto actor = simulate::DriverBoxActor::create(motion, metres, *rig, *skeleton, errors, seed, rest_s);
  if (!actor) {
    return actor.error();
  }
  simulate::ReadingSettings settings;
  settings.seconds = seconds;
  Wearer wearer{*rig, *skeleton, *actor, {}};
  wearer.readings = readings_of(simulate::simulate_readings(**actor, *rig, errors, settings, seed));
  return wearer;
}

/// Errors of a track between two times.
inline JointErrors errors_of(const Wearer& wearer, const estimate::BodyTrack& track, double from_s = -1e300,
                             double to_s = 1e300) {
  JointErrors errors;
  for (std::size_t i = 0; i < track.times.size(); ++i) {
    if (track.times[i] >= from_s && track.times[i] <= to_s) {
      errors.add(wearer.skeleton, track.R_joint[i], wearer.truth(track.times[i]), &track.sigma[i]);
    }
  }
  return errors;
}

}  // namespace limbwave::testing_support
