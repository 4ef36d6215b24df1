#include "body/rig_sensors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "body/json_geometry.h"

namespace limbwave::body {
namespace {

constexpr double kPpm = 1e-6;

// Without what conversion of units has left, so that a file read and written again is the same.
double rounded(double value) {
  return std::round(value * 1e9) / 1e9;
}

// What all kinds of sensors have in common.
template <typename Sensor>
Sensor read_worn(const JsonReader& reader) {
  Sensor sensor;
  sensor.name = reader.at("name").string();
  sensor.serial = reader.string_or("serial", "");
  sensor.segment = reader.at("segment").string();
  if (reader.has("position_m")) {
    sensor.p_LS = read_vector(reader.at("position_m"));
    if (sensor.p_LS.norm() > 10.0) {
      reader.at("position_m").fail("is more than 10 m off", "lengths are in metres");
    }
  }
  return sensor;
}

template <typename Sensor>
Sensor read_mounted(const JsonReader& reader) {
  reader.allow({"name", "serial", "segment", "mount", "position_m"});
  Sensor sensor = read_worn<Sensor>(reader);
  if (reader.has("mount")) {
    sensor.R_LS = read_quaternion(reader.at("mount"));
  }
  return sensor;
}

Microphone read_microphone(const JsonReader& reader) {
  reader.allow({"name", "serial", "segment", "position_m"});
  return read_worn<Microphone>(reader);
}

Source read_source(const JsonReader& reader) {
  reader.allow({"name", "serial", "segment", "position_m", "normal"});
  Source source = read_worn<Source>(reader);
  source.normal_L = read_direction(reader.at("normal"));
  return source;
}

template <typename Sensor, typename Read>
void read_list(const JsonReader& reader, const char* key, const char* what, std::vector<Sensor>& list,
               const Read& read) {
  if (!reader.has(key)) {
    return;
  }
  for (const JsonReader& entry : reader.at(key).items()) {
    Sensor sensor = read(entry);
    if (std::any_of(list.begin(), list.end(), [&](const Sensor& other) { return other.name == sensor.name; })) {
      entry.at("name").fail("is \"" + sensor.name + "\", which another " + what + " has already");
    }
    list.push_back(std::move(sensor));
  }
}

int read_count(const JsonReader& reader, const char* key, int otherwise, int minimum, int maximum) {
  return reader.has(key) ? static_cast<int>(reader.at(key).integer(minimum, maximum)) : otherwise;
}

DriverBoxSignal read_driver_box(const JsonReader& reader) {
  reader.allow({"rate_hz", "bits", "slot_samples", "pulse_hz", "pulse_cycles", "transducer_q",
                "microphone_bandwidth_hz", "source_level_m", "absorption_db_m", "radiation", "word_amplitude",
                "word_rate_hz", "word_clock_tolerance_ppm", "gyroscope_range_deg_s", "accelerometer_range_g"});
  DriverBoxSignal box;
  box.rate_hz = reader.number_or("rate_hz", box.rate_hz, 96000.0, 768000.0);
  box.bits = read_count(reader, "bits", box.bits, 12, 16);
  box.slot_samples = read_count(reader, "slot_samples", box.slot_samples, 256, 65536);
  box.pulse_hz = reader.number_or("pulse_hz", box.pulse_hz, 20000.0, 200000.0);
  box.pulse_cycles = read_count(reader, "pulse_cycles", box.pulse_cycles, 1, 100);
  box.transducer_q = reader.number_or("transducer_q", box.transducer_q, 0.5, 200.0);
  box.microphone_bandwidth_hz = reader.number_or("microphone_bandwidth_hz", box.microphone_bandwidth_hz, 1000.0, 1e5);
  box.source_level_m = reader.number_or("source_level_m", box.source_level_m, 1e-5, 10.0);
  box.absorption_db_m = reader.number_or("absorption_db_m", box.absorption_db_m, 0.0, 20.0);
  if (reader.has("radiation")) {
    box.radiation = reader.at("radiation").numbers(19);
    if (std::any_of(box.radiation.begin(), box.radiation.end(),
                    [](double gain) { return !(gain > 0.0 && gain <= 2.0); })) {
      reader.at("radiation")
          .fail("has an entry that is not above 0 and up to 2", "amplitudes at 0, 10, ... 180 degrees");
    }
  }
  box.word_amplitude = reader.number_or("word_amplitude", box.word_amplitude, 1e-4, 0.5);
  box.word_rate_hz = reader.number_or("word_rate_hz", box.word_rate_hz, 20.0, 1000.0);
  box.word_clock_tolerance =
      reader.number_or("word_clock_tolerance_ppm", box.word_clock_tolerance / kPpm, 1.0, 2000.0) * kPpm;
  box.gyroscope_range_rad_s =
      radians(reader.number_or("gyroscope_range_deg_s", degrees(box.gyroscope_range_rad_s), 1.0, 1e5));
  box.accelerometer_range_g = reader.number_or("accelerometer_range_g", box.accelerometer_range_g, 0.1, 1000.0);
  if (box.pulse_hz > 0.4 * box.rate_hz) {
    reader.fail(fmt::format("has a pulse_hz of {:g}, too close to half the sample rate", box.pulse_hz),
                "use a rate_hz of at least 2.5 times pulse_hz");
  }
  if (box.pulse_cycles * box.rate_hz / box.pulse_hz > 0.5 * box.slot_samples) {
    reader.fail("has pulses longer than half a slot", "use fewer pulse_cycles or more slot_samples");
  }
  return box;
}

// A wire carries one board: its microphone, and its gyroscope and accelerometer as words.
template <typename Sensor>
void check_wires(const JsonReader& reader, const char* key, const Rig& rig, const std::vector<Sensor>& sensors) {
  if (sensors.size() != rig.microphones.size()) {
    reader.at(key).fail(
        fmt::format("has {} entries, but {} microphones have a wire each", sensors.size(), rig.microphones.size()));
    return;
  }
  for (std::size_t w = 0; w < sensors.size(); ++w) {
    if (sensors[w].name != rig.microphones[w].name) {
      reader.at(key).items()[w].at("name").fail(
          "is \"" + sensors[w].name + "\", but the microphone of this wire is \"" + rig.microphones[w].name + "\"");
    }
  }
}

template <typename Sensor>
nlohmann::json worn_json(const Sensor& sensor) {
  return {{"name", sensor.name},
          {"serial", sensor.serial},
          {"segment", sensor.segment},
          {"position_m", to_json(sensor.p_LS)}};
}

template <typename Sensor>
nlohmann::json mounted_json(const Sensor& sensor) {
  nlohmann::json json = worn_json(sensor);
  json["mount"] = to_json(sensor.R_LS);
  return json;
}

template <typename Sensor, typename Write>
void write_list(nlohmann::json& json, const char* key, const std::vector<Sensor>& list, const Write& write) {
  for (const Sensor& sensor : list) {
    json[key].push_back(write(sensor));
  }
}

template <typename Sensor>
void check_list(const std::vector<Sensor>& list, const char* key, const Rig& rig, const Skeleton& skeleton,
                const std::string& place, Status& status) {
  for (std::size_t i = 0; i < list.size() && status; ++i) {
    if (skeleton.find(list[i].segment) < 0) {
      status = Error{fmt::format("is \"{}\", which is no segment of skeleton \"{}\"", list[i].segment, rig.skeleton),
                     fmt::format("{}: /{}/{}/segment", place, key, i), "name one of its segments"};
    }
  }
}

}  // namespace

std::vector<double> default_radiation() {
  return {1.0,  0.98, 0.92, 0.82, 0.69, 0.54, 0.38, 0.23, 0.11, 0.04,
          0.03, 0.02, 0.02, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01};
}

void read_sensors(const JsonReader& reader, Rig& rig) {
  read_list(reader, "accelerometers", "accelerometer", rig.accelerometers, read_mounted<Accelerometer>);
  read_list(reader, "gyroscopes", "gyroscope", rig.gyroscopes, read_mounted<Gyroscope>);
  read_list(reader, "microphones", "microphone", rig.microphones, read_microphone);
  read_list(reader, "sources", "source", rig.sources, read_source);
  if (!reader.has("driver_box")) {
    return;
  }
  rig.driver_box = read_driver_box(reader.at("driver_box"));
  if (rig.has_line_in) {
    reader.at("driver_box").fail("stands beside line_in", "a rig has one or the other");
  }
  if (rig.microphones.empty() || rig.microphones.size() > 64) {
    reader.at("microphones")
        .fail(fmt::format("has {} entries", rig.microphones.size()), "a driver box has 1 to 64 wires");
  }
  if (rig.sources.size() > 64) {
    reader.at("sources").fail(fmt::format("has {} entries", rig.sources.size()), "a driver box has up to 64 sources");
  }
  check_wires(reader, "gyroscopes", rig, rig.gyroscopes);
  check_wires(reader, "accelerometers", rig, rig.accelerometers);
}

void write_sensors(const Rig& rig, nlohmann::json& json) {
  json["accelerometers"] = nlohmann::json::array();
  write_list(json, "accelerometers", rig.accelerometers, mounted_json<Accelerometer>);
  write_list(json, "gyroscopes", rig.gyroscopes, mounted_json<Gyroscope>);
  write_list(json, "microphones", rig.microphones, worn_json<Microphone>);
  write_list(json, "sources", rig.sources, [](const Source& source) {
    nlohmann::json entry = worn_json(source);
    entry["normal"] = to_json(source.normal_L);
    return entry;
  });
  if (rig.driver_box) {
    const DriverBoxSignal& box = *rig.driver_box;
    json["driver_box"] = {{"rate_hz", box.rate_hz},
                          {"bits", box.bits},
                          {"slot_samples", box.slot_samples},
                          {"pulse_hz", box.pulse_hz},
                          {"pulse_cycles", box.pulse_cycles},
                          {"transducer_q", box.transducer_q},
                          {"microphone_bandwidth_hz", box.microphone_bandwidth_hz},
                          {"source_level_m", box.source_level_m},
                          {"absorption_db_m", box.absorption_db_m},
                          {"radiation", box.radiation},
                          {"word_amplitude", box.word_amplitude},
                          {"word_rate_hz", box.word_rate_hz},
                          {"word_clock_tolerance_ppm", rounded(box.word_clock_tolerance / kPpm)},
                          {"gyroscope_range_deg_s", rounded(degrees(box.gyroscope_range_rad_s))},
                          {"accelerometer_range_g", box.accelerometer_range_g}};
  }
}

Status check_segments(const Rig& rig, const Skeleton& skeleton, const std::string& place) {
  Status status;
  check_list(rig.accelerometers, "accelerometers", rig, skeleton, place, status);
  check_list(rig.gyroscopes, "gyroscopes", rig, skeleton, place, status);
  check_list(rig.microphones, "microphones", rig, skeleton, place, status);
  check_list(rig.sources, "sources", rig, skeleton, place, status);
  return status;
}

}  // namespace limbwave::body
