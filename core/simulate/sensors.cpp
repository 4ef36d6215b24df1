#include "simulate/sensors.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/units.h"
#include "geometry/so3.h"
#include "simulate/part_tolerance.h"
#include "simulate/random.h"

namespace limbwave::simulate {

Vector3d ActualSensor::reading_g(const Vector3d& f_S) const {
  return M * (f_S / kStandardGravity) + offset_g;
}

std::string simulated_serial(std::uint64_t seed, std::size_t sensor) {
  return fmt::format("SIM-{}-{}", seed, sensor + 1);
}

std::vector<ActualSensor> draw_sensors(const body::Rig& rig, const body::Skeleton& skeleton, const LineInErrors& errors,
                                       std::uint64_t seed) {
  Random offsets(seed, "sensor offset");
  Random scales(seed, "sensor scale");
  Random crosses(seed, "sensor cross-axis");
  Random angles(seed, "mount angle");
  Random positions(seed, "mount offset");
  Random phases(seed, "soft tissue");
  std::vector<ActualSensor> sensors;
  for (std::size_t i = 0; i < rig.accelerometers.size(); ++i) {
    const body::Accelerometer& nominal = rig.accelerometers[i];
    ActualSensor sensor;
    sensor.name = nominal.name;
    sensor.serial = simulated_serial(seed, i);
    sensor.segment = skeleton.find(nominal.segment);
    sensor.R_LS = nominal.R_LS * geometry::exp_so3(drawn_vector(angles, errors.mount_angle));
    sensor.p_LS = nominal.p_LS + drawn_vector(positions, errors.mount_offset);
    sensor.offset_g = drawn_vector(offsets, errors.offset_g);
    const Vector3d gains = drawn_vector(scales, errors.scale);
    for (Eigen::Index row = 0; row < 3; ++row) {
      for (Eigen::Index column = 0; column < 3; ++column) {
        sensor.M(row, column) = row == column ? 1.0 + gains[row] : drawn(crosses, errors.cross_axis);
      }
    }
    sensor.wobble_angle = errors.soft_tissue_angle;
    sensor.wobble_offset = errors.soft_tissue_offset;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      sensor.angle_phase[axis] = phases.uniform(0.0, 2.0 * kPi);
      sensor.offset_phase[axis] = phases.uniform(0.0, 2.0 * kPi);
    }
    sensors.push_back(std::move(sensor));
  }
  return sensors;
}

}  // namespace limbwave::simulate
