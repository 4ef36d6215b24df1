#include "calibrate/calibration.h"

#include <fmt/format.h>

#include <cmath>

#include "base/json_reader.h"
#include "base/units.h"

namespace limbwave::calibrate {
namespace {

using nlohmann::json;

// Beyond these a file is damaged, whatever the sensor: a volt-scale signal cannot have them.
constexpr double kLargestOffset = 1e3;
constexpr double kLargestScale = 1e6;

json vector_to_json(const Vector3d& v) {
  return json::array({v.x(), v.y(), v.z()});
}

Vector3d vector_from_json(const JsonReader& reader, double limit) {
  const std::vector<double> values = reader.numbers(3);
  Vector3d v = Vector3d::Zero();
  for (int i = 0; i < 3; ++i) {
    v[i] = values[static_cast<std::size_t>(i)];
    if (std::abs(v[i]) > limit) {
      reader.fail("is larger than any sensor can have", "calibrate the sensor again");
    }
  }
  return v;
}

Matrix3d matrix_from_json(const JsonReader& reader) {
  Matrix3d M = Matrix3d::Identity();
  const std::vector<JsonReader> rows = reader.items();
  if (rows.size() != 3) {
    reader.fail("does not have three rows");
    return M;
  }
  for (int row = 0; row < 3; ++row) {
    M.row(row) = vector_from_json(rows[static_cast<std::size_t>(row)], kLargestScale).transpose();
  }
  // M must turn readings of a right-handed sensor into a right-handed frame, and be invertible.
  if (!(M.determinant() > 1e-9)) {
    reader.fail("is singular or mirrors the axes", "calibrate the sensor again");
  }
  return M;
}

}  // namespace

RigCalibration nominal_calibration(const body::Rig& rig) {
  RigCalibration calibration;
  for (const body::Accelerometer& accelerometer : rig.accelerometers) {
    SensorCalibration sensor;
    sensor.serial = accelerometer.serial;
    sensor.method = "nominal";
    sensor.offset = Vector3d::Constant(rig.line_in.zero_g_volts - rig.line_in.reference_volts);
    sensor.M = Matrix3d::Identity() * (kStandardGravity / rig.line_in.volts_per_g);
    calibration.sensors.push_back(sensor);
    MountCalibration mount;
    mount.sensor = accelerometer.name;
    mount.method = "nominal";
    mount.R_LS = accelerometer.R_LS;
    calibration.mounts.push_back(mount);
  }
  return calibration;
}

Status check_calibration(const RigCalibration& calibration, const body::Rig& rig) {
  const std::size_t count = rig.accelerometers.size();
  if (calibration.sensors.size() != count || calibration.mounts.size() != count) {
    return Error{fmt::format("the calibration is of {} sensors with {} mounts, but the rig has {}",
                             calibration.sensors.size(), calibration.mounts.size(), count),
                 rig.name, "calibrate again"};
  }
  for (std::size_t s = 0; s < count; ++s) {
    if (calibration.mounts[s].sensor != rig.accelerometers[s].name) {
      return Error{fmt::format("the calibration has \"{}\" where the rig has \"{}\"", calibration.mounts[s].sensor,
                               rig.accelerometers[s].name),
                   rig.name, "put the entries into the order of the rig, or calibrate again"};
    }
  }
  return {};
}

SensorCalibration sensor_calibration_from_json(const JsonReader& reader) {
  reader.allow({"serial", "method", "date", "offset_volts", "m_s2_per_volt", "residual_g", "coverage"});
  SensorCalibration sensor;
  sensor.serial = reader.string_or("serial", "");
  sensor.method = reader.at("method").string();
  sensor.date = reader.string_or("date", "");
  sensor.offset = vector_from_json(reader.at("offset_volts"), kLargestOffset);
  sensor.M = matrix_from_json(reader.at("m_s2_per_volt"));
  sensor.residual_g = reader.number_or("residual_g", 0.0, 0.0, 1e3);
  sensor.coverage = reader.number_or("coverage", 0.0, 0.0, 1.0);
  return sensor;
}

json sensor_calibration_to_json(const SensorCalibration& sensor) {
  return {{"serial", sensor.serial},
          {"method", sensor.method},
          {"date", sensor.date},
          {"offset_volts", vector_to_json(sensor.offset)},
          {"m_s2_per_volt", json::array({vector_to_json(sensor.M.row(0)), vector_to_json(sensor.M.row(1)),
                                         vector_to_json(sensor.M.row(2))})},
          {"residual_g", sensor.residual_g},
          {"coverage", sensor.coverage}};
}

MountCalibration mount_calibration_from_json(const JsonReader& reader) {
  reader.allow({"sensor", "method", "date", "R_LS", "pose_angle_deg", "stillness_g"});
  MountCalibration mount;
  mount.sensor = reader.at("sensor").string();
  mount.method = reader.at("method").string();
  mount.date = reader.string_or("date", "");
  const std::vector<double> q = reader.at("R_LS").numbers(4);
  const Quaterniond rotation(q[0], q[1], q[2], q[3]);
  if (std::abs(rotation.norm() - 1.0) > 1e-3) {
    reader.at("R_LS").fail("is not a unit quaternion", "four numbers, w first, with squares that add up to 1");
  } else {
    // Within rounding of a unit quaternion the numbers are kept, so that writing gives the same file again.
    mount.R_LS = std::abs(rotation.norm() - 1.0) > 1e-12 ? rotation.normalized() : rotation;
  }
  mount.pose_angle_deg = reader.number_or("pose_angle_deg", 90.0, 0.0, 180.0);
  mount.stillness_g = reader.number_or("stillness_g", 0.0, 0.0, 1e3);
  return mount;
}

json mount_calibration_to_json(const MountCalibration& mount) {
  return {{"sensor", mount.sensor},
          {"method", mount.method},
          {"date", mount.date},
          {"R_LS", json::array({mount.R_LS.w(), mount.R_LS.x(), mount.R_LS.y(), mount.R_LS.z()})},
          {"pose_angle_deg", mount.pose_angle_deg},
          {"stillness_g", mount.stillness_g}};
}

Result<RigCalibration> calibration_from_json(const nlohmann::json& json, const std::string& place) {
  JsonReader::State state{place, {}};
  const JsonReader reader(json, "", state);
  reader.allow({"sensors", "mounts"});
  RigCalibration calibration;
  for (const JsonReader& sensor : reader.at("sensors").items()) {
    calibration.sensors.push_back(sensor_calibration_from_json(sensor));
  }
  for (const JsonReader& mount : reader.at("mounts").items()) {
    calibration.mounts.push_back(mount_calibration_from_json(mount));
  }
  if (calibration.sensors.size() != calibration.mounts.size()) {
    reader.at("mounts").fail("does not have one entry per sensor");
  }
  if (state.error) {
    return *state.error;
  }
  return calibration;
}

json calibration_to_json(const RigCalibration& calibration) {
  json sensors = json::array();
  for (const SensorCalibration& sensor : calibration.sensors) {
    sensors.push_back(sensor_calibration_to_json(sensor));
  }
  json mounts = json::array();
  for (const MountCalibration& mount : calibration.mounts) {
    mounts.push_back(mount_calibration_to_json(mount));
  }
  return {{"sensors", sensors}, {"mounts", mounts}};
}

}  // namespace limbwave::calibrate
