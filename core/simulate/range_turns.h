/// How sensors are turned in the hand for their range calibration.
#pragma once

#include "simulate/jets.h"

namespace limbwave::simulate {

/// Length of the range calibration, seconds.
double range_seconds();

/// R_WS of a sensor that starts and ends at rest in `R_WS_rest`: down the whole sphere of directions in a spiral, then
/// along the two great circles through its axes, so that gravity passes through +x, −x, +y, −y, +z and −z exactly.
QuaternionJet range_rotation(double time_s, const Quaterniond& R_WS_rest);

/// Acceleration of the hand, m/s², world: still but for four jerks of about an eighth of a second.
Vector3d range_jerk(double time_s);

}  // namespace limbwave::simulate
