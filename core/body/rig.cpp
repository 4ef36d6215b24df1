#include "body/rig.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/files.h"
#include "base/json_reader.h"
#include "body/json_geometry.h"
#include "body/rig_sensors.h"

namespace limbwave::body {
namespace {

LineInSignal read_line_in(const JsonReader& reader) {
  reader.allow({"cycle_rate_hz", "cycle_rate_tolerance", "slots", "supply_volts", "reference_volts", "zero_g_volts",
                "volts_per_g", "range_g"});
  LineInSignal signal;
  signal.cycle_rate_hz = reader.number_or("cycle_rate_hz", signal.cycle_rate_hz, 10.0, 1000.0);
  signal.cycle_rate_tolerance = reader.number_or("cycle_rate_tolerance", signal.cycle_rate_tolerance, 0.001, 0.3);
  signal.slots = reader.has("slots") ? static_cast<int>(reader.at("slots").integer(4, 32)) : signal.slots;
  signal.supply_volts = reader.number_or("supply_volts", signal.supply_volts, 0.1, 48.0);
  signal.reference_volts = reader.number_or("reference_volts", signal.reference_volts, -48.0, 48.0);
  signal.zero_g_volts = reader.number_or("zero_g_volts", signal.zero_g_volts, -48.0, 48.0);
  signal.volts_per_g = reader.number_or("volts_per_g", signal.volts_per_g, 1e-3, 10.0);
  signal.range_g = reader.number_or("range_g", signal.range_g, 1.0, 1000.0);
  if (signal.slots % 2 != 0 || (signal.slots - 1) % 3 != 0) {
    reader.at("slots").fail(fmt::format("is {}", signal.slots),
                            "it is even and one more than three times the number of sensors: 4, 10, 16, 22 or 28");
  }
  return signal;
}

LimbPose read_pose(const JsonReader& reader) {
  reader.allow({"name", "instruction", "gravity"});
  return {reader.at("name").string(), reader.at("instruction").string(), read_direction(reader.at("gravity"))};
}

int find_sensor(const Rig& rig, const std::string& name) {
  const auto found = std::find_if(rig.accelerometers.begin(), rig.accelerometers.end(),
                                  [&](const Accelerometer& sensor) { return sensor.name == name; });
  return found == rig.accelerometers.end() ? -1 : static_cast<int>(found - rig.accelerometers.begin());
}

CalibrationGroup read_group(const JsonReader& reader, const Rig& rig) {
  reader.allow({"name", "sensors", "first", "second"});
  CalibrationGroup group;
  group.name = reader.at("name").string();
  for (const JsonReader& entry : reader.at("sensors").items()) {
    const std::string name = entry.string();
    const int sensor = find_sensor(rig, name);
    if (sensor < 0) {
      entry.fail("is \"" + name + "\", which is no accelerometer of this rig");
    }
    group.sensors.push_back(sensor);
  }
  if (group.sensors.empty()) {
    reader.at("sensors").fail("is empty");
  }
  group.first = read_pose(reader.at("first"));
  group.second = read_pose(reader.at("second"));
  if (std::abs(group.first.gravity_L.dot(group.second.gravity_L)) > 1e-6) {
    reader.at("second").at("gravity").fail("is not perpendicular to that of the first pose");
  }
  return group;
}

}  // namespace

Result<Rig> rig_from_json(const nlohmann::json& json, const std::string& place) {
  JsonReader::State state{place, {}};
  const JsonReader reader(json, "", state);
  reader.allow({"schema", "name", "title", "skeleton", "line_in", "driver_box", "accelerometers", "gyroscopes",
                "microphones", "sources", "calibration_groups"});
  reader.at("schema").integer(1, 1);
  Rig rig;
  rig.name = reader.at("name").string();
  rig.title = reader.string_or("title", rig.name);
  rig.skeleton = reader.at("skeleton").string();
  rig.has_line_in = reader.has("line_in");
  if (rig.has_line_in) {
    rig.line_in = read_line_in(reader.at("line_in"));
  }
  read_sensors(reader, rig);
  const int expected = (rig.line_in.slots - 1) / 3;
  if (rig.has_line_in && static_cast<int>(rig.accelerometers.size()) != expected) {
    reader.at("accelerometers")
        .fail(fmt::format("has {} entries, but {} slots carry {} sensors", rig.accelerometers.size(), rig.line_in.slots,
                          expected));
  }
  if (reader.has("calibration_groups")) {
    for (const JsonReader& entry : reader.at("calibration_groups").items()) {
      rig.groups.push_back(read_group(entry, rig));
    }
  }
  if (state.error) {
    return *state.error;
  }
  return rig;
}

nlohmann::json rig_to_json(const Rig& rig) {
  const LineInSignal& s = rig.line_in;
  nlohmann::json groups = nlohmann::json::array();
  const auto pose = [](const LimbPose& p) {
    return nlohmann::json{{"name", p.name}, {"instruction", p.instruction}, {"gravity", to_json(p.gravity_L)}};
  };
  for (const CalibrationGroup& group : rig.groups) {
    nlohmann::json names = nlohmann::json::array();
    for (const int sensor : group.sensors) {
      names.push_back(rig.accelerometers.at(static_cast<std::size_t>(sensor)).name);
    }
    groups.push_back(
        {{"name", group.name}, {"sensors", names}, {"first", pose(group.first)}, {"second", pose(group.second)}});
  }
  nlohmann::json json = {{"schema", 1},
                         {"name", rig.name},
                         {"title", rig.title},
                         {"skeleton", rig.skeleton},
                         {"calibration_groups", groups}};
  if (rig.has_line_in) {
    json["line_in"] = {{"cycle_rate_hz", s.cycle_rate_hz},
                       {"cycle_rate_tolerance", s.cycle_rate_tolerance},
                       {"slots", s.slots},
                       {"supply_volts", s.supply_volts},
                       {"reference_volts", s.reference_volts},
                       {"zero_g_volts", s.zero_g_volts},
                       {"volts_per_g", s.volts_per_g},
                       {"range_g", s.range_g}};
  }
  write_sensors(rig, json);
  return json;
}

Rig scaled(Rig rig, double factor) {
  const auto all = [&](auto& things) {
    for (auto& thing : things) {
      thing.p_LS *= factor;
    }
  };
  all(rig.accelerometers);
  all(rig.gyroscopes);
  all(rig.microphones);
  all(rig.sources);
  return rig;
}

Result<Rig> load_rig(const std::string& name_or_path) {
  const std::string path = shipped_or_path("rigs", name_or_path);
  const Result<std::string> text = read_file(path, std::size_t{16} << 20);
  if (!text) {
    return text.error();
  }
  const Result<nlohmann::json> json = parse_json(*text, path);
  if (!json) {
    return json.error();
  }
  Result<Rig> rig = rig_from_json(*json, path);
  if (!rig) {
    return rig;
  }
  const Result<Skeleton> skeleton = load_skeleton(rig->skeleton);
  if (!skeleton) {
    return skeleton.error();
  }
  if (const Status fits = check_segments(*rig, *skeleton, path); !fits) {
    return fits.error();
  }
  return rig;
}

std::vector<std::string> shipped_rigs() {
  return shipped_names("rigs");
}

}  // namespace limbwave::body
