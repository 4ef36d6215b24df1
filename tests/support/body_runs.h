/// A simulated wearer of the driver box through the body filter, and how far off the result is.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/units.h"
#include "estimate/body_filter.h"
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
  int count = 0;
  void add(double e) {
    sum += e;
    square += e * e;
    largest = std::max(largest, e);
    ++count;
  }
  [[nodiscard]] double mean() const { return count == 0 ? 0.0 : sum / count; }
  [[nodiscard]] double sd() const {
    return count == 0 ? 0.0 : std::sqrt(std::max(0.0, square / count - mean() * mean()));
  }
};

/// Geodesic errors of joints (relative to the parent), degrees, by name of the segment; and "all".
class JointErrors {
 public:
  void add(const body::Skeleton& skeleton, const std::vector<Eigen::Quaterniond>& R_joint,
           const std::vector<body::SegmentPose>& truth) {
    for (std::size_t i = 1; i < skeleton.segments.size(); ++i) {
      const body::Segment& segment = skeleton.segments[i];
      const Eigen::Quaterniond R_true =
          truth[static_cast<std::size_t>(segment.parent)].R_WL.conjugate() * truth[i].R_WL;
      const double e = degrees(geometry::geodesic_angle(R_true, segment.R_PL_rest * R_joint[i]));
      by_name[segment.name].add(e);
      all.add(e);
    }
  }
  std::map<std::string, Errors> by_name;
  Errors all;
};

}  // namespace limbwave::testing_support
