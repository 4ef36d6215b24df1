/// Errors of the line-in path against the simulator's truth, measured in one way by the tests and by the table.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/units.h"
#include "calibrate/calibration.h"
#include "geometry/so3.h"
#include "solve/decoded_take.h"
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
  ErrorFigures acceleration_g;
  ErrorFigures inclination_deg;
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
      errors.inclination_deg.add(degrees(geometry::angle_between(measured, real)));
    }
  }
  return errors;
}

}  // namespace limbwave::testing_support
