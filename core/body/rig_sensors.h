/// What is worn, as rig files list it: accelerometers, gyroscopes, microphones, sources, and the driver box.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "base/json_reader.h"
#include "body/rig.h"

namespace limbwave::body {

/// Reads "driver_box" and all lists of sensors that the rig has into `rig`.
void read_sensors(const JsonReader& reader, Rig& rig);
/// The inverse; lists that are empty are left out, but "accelerometers" is always there.
void write_sensors(const Rig& rig, nlohmann::json& json);
/// Every sensor is worn on a segment of the skeleton.
Status check_segments(const Rig& rig, const Skeleton& skeleton, const std::string& place);

}  // namespace limbwave::body
