/// Errors of the line-in path against the simulator's truth, measured in one way by the tests and by the table.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/units.h"
#include "calibrate/calibration.h"
#include "evaluate/evaluate.h"
#include "geometry/so3.h"
#include "solve/compose.h"
#include "solve/decoded_take.h"
#include "solve/solve.h"
#include "support/simulated_take.h"

namespace limbwave::testing_support {

struct ErrorFigures {
  double mean = 0.0, max = 0.0;
  std::size_t count = 0;
  void add(double value) {
    sum_ += value;
    ++count;
    mean = sum_ / static_cast<double>(count);
    max = std::max(max, value);
  }

 private:
  double sum_ = 0.0;
};

/// What the wire and the decoder add: decoded specific force against what the sensors felt, per frame and sensor, with
/// no smoothing. For simulations without sensor errors, whose nominal calibration is exact.
struct WireErrors {
  ErrorFigures acceleration_g;   ///< Of all usable readings.
  ErrorFigures inclination_deg;  ///< Of those whose force has a direction: at least half of g.
  double usable = 0.0;           ///< Readings that were usable, of all cycles that the board really made.
};

inline WireErrors wire_errors(const take::Take& take, const solve::DecodedTake& decoded) {
  const SensorTruth truth(take.folder);
  const calibrate::RigCalibration nominal = calibrate::nominal_calibration(take.info.rig);
  WireErrors errors;
  const SampleRate rate = take.info.format.rate;
  const take::TakeSegment capture = take.info.capture();
  const double begin = rate.seconds(capture.first).value + 0.25;
  const double end = rate.seconds(capture.first + capture.count).value - 0.25;
  for (const decode::AccelerationFrame& frame : decoded.between(begin, end)) {
    for (std::size_t s = 0; s < truth.sensors(); ++s) {
      if ((frame.usable >> s & 1U) == 0) {
        continue;
      }
      const Eigen::Vector3d measured = nominal.sensors[s].apply(frame.volts[s]);
      const Eigen::Vector3d real = truth.force(s, frame.time_s);
      errors.acceleration_g.add((measured - real).cwiseAbs().maxCoeff() / kStandardGravity);
      // Near free fall there is no direction of gravity to be wrong about.
      if (real.norm() < 0.5 * kStandardGravity) {
        continue;
      }
      errors.inclination_deg.add(degrees(geometry::angle_between(measured, real)));
    }
  }
  errors.usable = static_cast<double>(errors.acceleration_g.count) /
                  static_cast<double>(truth.sensors() * truth.cycles(begin, end));
  return errors;
}

/// Readings of the worst sensor that were usable, of all cycles that the board really made in the capture.
inline double usable_share(const take::Take& take, const solve::Solve& solve) {
  const SensorTruth truth(take.folder);
  const SampleRate rate = take.info.format.rate;
  const take::TakeSegment capture = take.info.capture();
  const std::size_t cycles =
      truth.cycles(rate.seconds(capture.first).value, rate.seconds(capture.first + capture.count).value);
  double least = 1.0;
  for (const solve::SensorQuality& sensor : solve.report.sensors) {
    least = std::min(least, sensor.usable);
  }
  return least * static_cast<double>(solve.trust.front().size()) / static_cast<double>(cycles);
}

/// Inclination of every sensor's segment while poses are held, against the truth.
inline ErrorFigures still_pose_errors(const take::Take& take, const solve::Solve& solve) {
  const evaluate::Truth truth = require(evaluate::load_truth(take.folder / "truth.json"));
  const SensorTruth felt(take.folder);
  const double origin = take.info.format.rate.seconds(take.info.capture().first).value;
  ErrorFigures figures;
  const std::vector<std::vector<Eigen::Quaterniond>> R_WL = solve::world_orientations(solve.clip);
  const std::vector<double>& times = solve.clip.joints.front().rotation.times;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double time = origin + times[i];
    if (!felt.holding(time)) {
      continue;
    }
    for (std::size_t s = 0; s < solve.clip.skeleton.segments.size(); ++s) {
      const auto& segment = truth.segments.at(s);
      const auto nearest = static_cast<std::size_t>(std::lower_bound(segment.times.begin(), segment.times.end(), time) -
                                                    segment.times.begin());
      const Eigen::Vector3d up_true = segment.R_WL.at(nearest).conjugate() * Eigen::Vector3d::UnitZ();
      const Eigen::Vector3d up_found = R_WL[i][s].conjugate() * Eigen::Vector3d::UnitZ();
      figures.add(degrees(geometry::angle_between(up_true, up_found)));
    }
  }
  return figures;
}

}  // namespace limbwave::testing_support
