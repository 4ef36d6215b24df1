/// The newest inertial readings of one board, at any time between them.
#pragma once

#include <Eigen/Core>
#include <deque>

#include "decode/inertial_reading.h"

namespace limbwave::decode {

/// What a board felt over a stretch of time, in its own axes S.
struct FeltMotion {
  Eigen::Vector3d w_S = Eigen::Vector3d::Zero();  ///< Angular velocity, rad/s, mean.
  Eigen::Vector3d f_S = Eigen::Vector3d::Zero();  ///< Specific force, m/s², mean.
  bool known = false;                             ///< False: words are missing.
  bool saturated = false;                         ///< A channel was at the end of its range.
};

class InertialTrace {
 public:
  /// Readings at most `longest_s` apart are joined; between others nothing is known.
  explicit InertialTrace(double longest_s = 0.030) : longest_s_(longest_s) {}
  /// Readings in order of time; those that are not valid are left out.
  void add(const InertialReading& reading);
  /// Mean over a stretch, by Simpson's rule between readings joined by straight lines.
  [[nodiscard]] FeltMotion over(double from_s, double to_s) const;
  /// What lies before is not asked for any more.
  void forget(double before_s);

 private:
  struct Sample {
    double time_s;
    Eigen::Vector3d w_S, f_S;
    bool saturated;
  };
  [[nodiscard]] FeltMotion at(double time_s) const;
  double longest_s_;
  std::deque<Sample> samples_;
};

}  // namespace limbwave::decode
