/// What calibrations find out, and how it is applied and stored.
#pragma once

#include <Eigen/Geometry>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "base/result.h"
#include "body/rig.h"

namespace limbwave {
class JsonReader;
}

namespace limbwave::calibrate {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

/// Range calibration of one accelerometer, once in its life: specific force f_S = M · (volts − offset), m/s².
struct SensorCalibration {
  std::string serial;
  std::string method;                  ///< "nominal", "extremes", "ellipsoid"
  std::string date;                    ///< ISO 8601, UTC; empty for nominal.
  Vector3d offset = Vector3d::Zero();  ///< Reading at 0 g, volts relative to the reference.
  Matrix3d M = Matrix3d::Identity();   ///< m/s² per volt.
  double residual_g = 0.0;             ///< RMS of |f|/g − 1 on still samples that were not used for the fit.
  double coverage = 0.0;               ///< Fraction of the sphere of directions that was visited, 0..1.
  [[nodiscard]] Vector3d apply(const Vector3d& volts) const { return M * (volts - offset); }
};

/// Limb calibration of one mounted sensor, once per mounting.
struct MountCalibration {
  std::string sensor;  ///< Name in the rig.
  std::string method;  ///< "nominal", "two poses"
  std::string date;
  Quaterniond R_LS = Quaterniond::Identity();
  double pose_angle_deg = 90.0;  ///< Measured between the two poses; 90° when the wearer was exact.
  double stillness_g = 0.0;      ///< RMS of movement within the poses.
};

/// One entry per accelerometer of the rig, in its order.
struct RigCalibration {
  std::vector<SensorCalibration> sensors;
  std::vector<MountCalibration> mounts;
};

/// From the rig's data sheet alone.
RigCalibration nominal_calibration(const body::Rig& rig);

/// Fails when `calibration` is not of this rig: one entry per accelerometer, in its order, mounts by its names.
Status check_calibration(const RigCalibration& calibration, const body::Rig& rig);

Result<RigCalibration> calibration_from_json(const nlohmann::json& json, const std::string& place);
nlohmann::json calibration_to_json(const RigCalibration& calibration);

// The entries alone, as the calibration library stores them. Reading leaves what is wrong in the reader's state.
SensorCalibration sensor_calibration_from_json(const JsonReader& reader);
nlohmann::json sensor_calibration_to_json(const SensorCalibration& sensor);
MountCalibration mount_calibration_from_json(const JsonReader& reader);
nlohmann::json mount_calibration_to_json(const MountCalibration& mount);

}  // namespace limbwave::calibrate
