#include "simulate/driver_box_errors.h"

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/json_reader.h"
#include "base/units.h"
#include "body/json_geometry.h"

namespace limbwave::simulate {
namespace {

constexpr double kDegree = kPi / 180.0;
constexpr const char* kFolder = "driver_box_errors";
constexpr int kDeepestBase = 8;

struct NumberKey {
  const char* key;
  double DriverBoxErrors::*member;
  double unit;
  double minimum, maximum;  // in the file's unit
};
using E = DriverBoxErrors;
constexpr std::array kNumbers = {
    NumberKey{"snr_db", &E::snr_db, 1.0, -20.0, 300.0},
    NumberKey{"floor_echo", &E::floor_echo, 1.0, 0.0, 1.0},
    NumberKey{"wall_echo", &E::wall_echo, 1.0, 0.0, 1.0},
    NumberKey{"source_delay_us", &E::source_delay, 1e-6, 0.0, 500.0},
    NumberKey{"phase_off_axis_deg", &E::phase_off_axis, kDegree, 0.0, 180.0},
    NumberKey{"phase_left_deg", &E::phase_left, kDegree, 0.0, 180.0},
    NumberKey{"speed_of_sound", &E::speed_of_sound, 1.0, -0.1, 0.1},
    NumberKey{"source_level_db", &E::source_level_db, 1.0, 0.0, 20.0},
    NumberKey{"keys_per_minute", &E::keys_per_minute, 1.0, 0.0, 600.0},
    NumberKey{"brakes_per_minute", &E::brakes_per_minute, 1.0, 0.0, 600.0},
    NumberKey{"accelerometer_noise_m_s2", &E::accelerometer_noise, 1.0, 0.0, 10.0},
    NumberKey{"accelerometer_offset_m_s2", &E::accelerometer_offset, 1.0, 0.0, 10.0},
    NumberKey{"accelerometer_scale", &E::accelerometer_scale, 1.0, 0.0, 0.3},
    NumberKey{"accelerometer_cross_axis", &E::accelerometer_cross_axis, 1.0, 0.0, 0.1},
    NumberKey{"gyroscope_noise_rad_s", &E::gyroscope_noise, 1.0, 0.0, 10.0},
    NumberKey{"gyroscope_bias_rad_s", &E::gyroscope_bias, 1.0, 0.0, 1.0},
    NumberKey{"gyroscope_bias_walk_rad_s_sqrt_s", &E::gyroscope_bias_walk, 1.0, 0.0, 0.1},
    NumberKey{"gyroscope_scale", &E::gyroscope_scale, 1.0, 0.0, 0.3},
    NumberKey{"gyroscope_g_rad_s_per_g", &E::gyroscope_g, 1.0, 0.0, 0.1},
    NumberKey{"mount_angle_deg", &E::mount_angle, kDegree, 0.0, 60.0},
    NumberKey{"mount_offset_mm", &E::mount_offset, 1e-3, 0.0, 200.0},
    NumberKey{"soft_tissue_angle_deg", &E::soft_tissue_angle, kDegree, 0.0, 20.0},
    NumberKey{"soft_tissue_offset_mm", &E::soft_tissue_offset, 1e-3, 0.0, 50.0},
    NumberKey{"bone_length", &E::bone_length, 1.0, 0.0, 0.2},
    NumberKey{"rest_pose_deg", &E::rest_pose, kDegree, 0.0, 45.0},
    NumberKey{"word_clock_ppm", &E::word_clock, 1e-6, 0.0, 2000.0},
    NumberKey{"word_drift_ppm", &E::word_drift, 1e-6, 0.0, 1000.0},
    NumberKey{"word_bit_errors", &E::word_bit_errors, 1.0, 0.0, 0.5},
};

struct SwitchKey {
  const char* key;
  bool DriverBoxErrors::*member;
};
constexpr std::array kSwitches = {SwitchKey{"occlusion", &E::occlusion}, SwitchKey{"accumulates", &E::accumulates}};

Result<DriverBoxErrors> load(const std::string& name_or_path, int depth) {
  const std::string path = body::shipped_or_path(kFolder, name_or_path);
  if (depth > kDeepestBase) {
    return Error{"is its own base", path, "remove the circle of \"base\""};
  }
  const Result<std::string> text = read_file(path, std::size_t{1} << 20U);
  if (!text) {
    return text.error();
  }
  const Result<nlohmann::json> json = parse_json(*text, path);
  if (!json) {
    return json.error();
  }
  JsonReader::State state{path, {}};
  const JsonReader reader(*json, "", state);
  DriverBoxErrors errors;
  if (!json->is_object()) {
    reader.allow({});
    return *state.error;
  }
  reader.at("schema").integer(1, 1);
  for (const auto& [key, child] : json->items()) {
    bool known = key == "schema" || key == "title" || key == "base";
    for (const NumberKey& entry : kNumbers) {
      known = known || key == entry.key;
    }
    for (const SwitchKey& entry : kSwitches) {
      known = known || key == entry.key;
    }
    if (!known) {
      JsonReader(child, "/" + key, state)
          .fail("is not a known key", "the keys are listed in resources/driver_box_errors/README.md");
    }
  }
  if (reader.has("base") && !state.error) {
    std::string base = reader.at("base").string();
    if (base.find('/') != std::string::npos || base.ends_with(".json")) {
      base = (std::filesystem::path(path).parent_path() / base).string();
    }
    const Result<DriverBoxErrors> below = load(base, depth + 1);
    if (!below) {
      return below.error();
    }
    errors = *below;
  }
  for (const NumberKey& entry : kNumbers) {
    if (reader.has(entry.key)) {
      errors.*entry.member = reader.at(entry.key).number(entry.minimum, entry.maximum) * entry.unit;
    }
  }
  for (const SwitchKey& entry : kSwitches) {
    errors.*entry.member = reader.boolean_or(entry.key, errors.*entry.member);
  }
  if (state.error) {
    return *state.error;
  }
  return errors;
}

}  // namespace

Result<DriverBoxErrors> load_driver_box_errors(const std::string& name_or_path) {
  return load(name_or_path, 0);
}

std::vector<std::string> shipped_driver_box_errors() {
  return body::shipped_names(kFolder);
}

nlohmann::json driver_box_errors_to_json(const DriverBoxErrors& errors) {
  nlohmann::json json;
  json["schema"] = 1;
  for (const NumberKey& entry : kNumbers) {
    json[entry.key] = errors.*entry.member / entry.unit;
  }
  for (const SwitchKey& entry : kSwitches) {
    json[entry.key] = errors.*entry.member;
  }
  return json;
}

}  // namespace limbwave::simulate
