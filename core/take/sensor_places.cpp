#include "take/sensor_places.h"

#include <algorithm>
#include <set>

#include "take/calibration_library.h"

namespace limbwave::take {
namespace {

// The calibration group of a sensor; -1: none.
int group_of(const body::Rig& rig, int sensor) {
  for (std::size_t g = 0; g < rig.groups.size(); ++g) {
    const std::vector<int>& members = rig.groups[g].sensors;
    if (std::find(members.begin(), members.end(), sensor) != members.end()) {
      return static_cast<int>(g);
    }
  }
  return -1;
}

// The range of the sensor that is now in socket `s`, as far as the take knows it.
calibrate::SensorCalibration range_of(const body::Accelerometer& sensor, std::size_t s, const body::Rig& before,
                                      const calibrate::RigCalibration& old, const calibrate::RigCalibration& nominal) {
  const auto named = [&](calibrate::SensorCalibration range) {
    range.serial = sensor.serial;
    return range;
  };
  const auto same = std::find_if(before.accelerometers.begin(), before.accelerometers.end(), [&](const auto& other) {
    return !sensor.serial.empty() && sensor_key(before, other) == sensor.serial;
  });
  if (same != before.accelerometers.end()) {
    return named(old.sensors[static_cast<std::size_t>(same - before.accelerometers.begin())]);
  }
  // A sensor that is named for the first time is still the same one.
  const bool kept = sensor.serial == before.accelerometers[s].serial || before.accelerometers[s].serial.empty();
  return kept ? named(old.sensors[s]) : nominal.sensors[s];
}

}  // namespace

std::vector<std::string> places_of(const body::Rig& rig) {
  std::vector<std::string> places;
  for (const body::Accelerometer& sensor : rig.accelerometers) {
    places.push_back(sensor.name);
  }
  return places;
}

Result<body::Rig> with_places(body::Rig rig, const std::vector<std::string>& places) {
  const std::vector<std::string> before = places_of(rig);
  if (places == before) {
    return rig;
  }
  if (!std::is_permutation(places.begin(), places.end(), before.begin(), before.end())) {
    return Error{"does not name every place of the rig once", "the sensors' places", "give every sensor its own place"};
  }
  const std::vector<body::Accelerometer> old = rig.accelerometers;
  std::vector<int> socket_of(old.size());  // by old index
  for (std::size_t s = 0; s < places.size(); ++s) {
    const auto from = static_cast<std::size_t>(std::find(before.begin(), before.end(), places[s]) - before.begin());
    const std::string key = sensor_key(rig, old[s]);
    rig.accelerometers[s] = old[from];
    rig.accelerometers[s].serial = old[s].serial.empty() && from != s ? key : old[s].serial;
    socket_of[from] = static_cast<int>(s);
  }
  for (body::CalibrationGroup& group : rig.groups) {
    for (int& sensor : group.sensors) {
      sensor = socket_of.at(static_cast<std::size_t>(sensor));
    }
  }
  return rig;
}

Result<TakeInfo> with_sensors(TakeInfo info, const std::vector<std::string>& places,
                              const std::vector<std::string>& serials) {
  std::set<std::string> seen;
  for (const std::string& serial : serials) {
    if (!serial.empty() && !seen.insert(serial).second) {
      return Error{"is entered for two sensors", "serial \"" + serial + "\"", "give each sensor its own"};
    }
  }
  const body::Rig before = info.rig;
  body::Rig named = before;
  for (std::size_t s = 0; s < serials.size() && s < named.accelerometers.size(); ++s) {
    named.accelerometers[s].serial = serials[s];
  }
  Result<body::Rig> after = with_places(std::move(named), places);
  if (!after) {
    return after.error();
  }
  info.rig = std::move(after).value();
  if (!info.calibration) {
    return info;
  }
  const calibrate::RigCalibration nominal = calibrate::nominal_calibration(info.rig);
  const calibrate::RigCalibration old = *info.calibration;
  calibrate::RigCalibration& calibration = *info.calibration;
  for (std::size_t s = 0; s < info.rig.accelerometers.size(); ++s) {
    calibration.sensors[s] = range_of(info.rig.accelerometers[s], s, before, old, nominal);
    calibrate::MountCalibration& mount = calibration.mounts[s];
    const bool measured = !mount.method.empty() && mount.method != "nominal";
    const int index = static_cast<int>(s);
    if (measured && group_of(before, index) == group_of(info.rig, index)) {
      mount.sensor = info.rig.accelerometers[s].name;  // held in the same poses
    } else if (places[s] != before.accelerometers[s].name || !measured) {
      mount = nominal.mounts[s];
    }
  }
  return info;
}

}  // namespace limbwave::take
