/// The accelerometers as they really are: where each really sits and what it really reads.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "body/rig.h"
#include "body/skeleton.h"
#include "simulate/errors.h"

namespace limbwave::simulate {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

/// One drawn sensor. Its reading in g is M · f_S / g + offset_g.
struct ActualSensor {
  std::string name, serial;
  int segment = 0;
  Quaterniond R_LS = Quaterniond::Identity();
  Vector3d p_LS = Vector3d::Zero();
  Vector3d offset_g = Vector3d::Zero();
  Matrix3d M = Matrix3d::Identity();
  /// The skin slides with the limb's inclination: the rotation vector is wobble_angle · sin(2 u + phase) by component,
  /// u being the upward direction in the limb's frame; the position likewise.
  double wobble_angle = 0.0, wobble_offset = 0.0;
  Vector3d angle_phase = Vector3d::Zero(), offset_phase = Vector3d::Zero();

  /// Reading in g from specific force in m/s², before noise and saturation.
  [[nodiscard]] Vector3d reading_g(const Vector3d& f_S) const;
};

/// "SIM-<seed>-<n>", n from 1.
std::string simulated_serial(std::uint64_t seed, std::size_t sensor);

/// One per accelerometer of the rig; the same for the same seed.
std::vector<ActualSensor> draw_sensors(const body::Rig& rig, const body::Skeleton& skeleton, const LineInErrors& errors,
                                       std::uint64_t seed);

}  // namespace limbwave::simulate
