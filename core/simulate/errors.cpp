#include "simulate/errors.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>

#include "base/files.h"
#include "base/json_reader.h"
#include "base/units.h"
#include "body/json_geometry.h"

namespace limbwave::simulate {
namespace {

constexpr double kDegree = kPi / 180.0;
constexpr double kMillimetre = 1e-3;

// One number of the file: its key, where it goes, the unit of the file in SI, and what is possible (in the file's
// unit).
struct NumberKey {
  const char* key;
  double LineInErrors::*member;
  double unit;
  double minimum, maximum;
};
constexpr std::array kNumbers = {
    NumberKey{"accelerometer_noise_m_s2", &LineInErrors::accelerometer_noise, 1.0, 0.0, 10.0},
    NumberKey{"offset_g", &LineInErrors::offset_g, 1.0, 0.0, 1.0},
    NumberKey{"scale", &LineInErrors::scale, 1.0, 0.0, 0.3},
    NumberKey{"cross_axis", &LineInErrors::cross_axis, 1.0, 0.0, 0.1},
    NumberKey{"mount_angle_deg", &LineInErrors::mount_angle, kDegree, 0.0, 60.0},
    NumberKey{"mount_offset_mm", &LineInErrors::mount_offset, kMillimetre, 0.0, 200.0},
    NumberKey{"pose_angle_deg", &LineInErrors::pose_angle, kDegree, 0.0, 45.0},
    NumberKey{"soft_tissue_angle_deg", &LineInErrors::soft_tissue_angle, kDegree, 0.0, 20.0},
    NumberKey{"soft_tissue_offset_mm", &LineInErrors::soft_tissue_offset, kMillimetre, 0.0, 50.0},
    NumberKey{"clock_offset", &LineInErrors::clock_offset, 1.0, -0.5, 0.5},
    NumberKey{"clock_wander", &LineInErrors::clock_wander, 1.0, 0.0, 0.1},
    NumberKey{"clock_jitter", &LineInErrors::clock_jitter, 1.0, 0.0, 0.1},
    NumberKey{"settle_us", &LineInErrors::settle_s, 1e-6, 0.0, 1000.0},
    NumberKey{"coupling_hz", &LineInErrors::coupling_hz, 1.0, 0.0, 1000.0},
    NumberKey{"ringing", &LineInErrors::ringing, 1.0, 0.0, 1.0},
    NumberKey{"ringing_hz", &LineInErrors::ringing_hz, 1.0, 0.0, 100000.0},
    NumberKey{"ringing_decay_us", &LineInErrors::ringing_decay_s, 1e-6, 0.0, 10000.0},
    NumberKey{"noise_db", &LineInErrors::noise_db, 1.0, -300.0, 0.0},
    NumberKey{"hum", &LineInErrors::hum, 1.0, 0.0, 1.0},
    NumberKey{"gain", &LineInErrors::gain, 1.0, 1e-6, 100.0},
    NumberKey{"knob_time_s", &LineInErrors::knob_time_s, 1.0, -1.0, 1e6},
    NumberKey{"knob_factor", &LineInErrors::knob_factor, 1.0, 0.0, 100.0},
    NumberKey{"drop_every_s", &LineInErrors::drop_every_s, 1.0, 0.0, 1e6},
    NumberKey{"silence_time_s", &LineInErrors::silence_time_s, 1.0, -1.0, 1e6},
    NumberKey{"silence_duration_s", &LineInErrors::silence_duration_s, 1.0, 0.0, 1e6},
};

struct SwitchKey {
  const char* key;
  bool LineInErrors::*member;
};
constexpr std::array kSwitches = {
    SwitchKey{"saturates", &LineInErrors::saturates},
    SwitchKey{"anti_alias", &LineInErrors::anti_alias},
    SwitchKey{"dither", &LineInErrors::dither},
    SwitchKey{"left_inverted", &LineInErrors::left_inverted},
    SwitchKey{"right_inverted", &LineInErrors::right_inverted},
    SwitchKey{"swapped", &LineInErrors::swapped},
};

bool known(std::string_view key) {
  const auto is = [&](const auto& entry) { return key == entry.key; };
  return key == "schema" || key == "title" || key == "base" || key == "drop_frames" ||
         std::any_of(kNumbers.begin(), kNumbers.end(), is) || std::any_of(kSwitches.begin(), kSwitches.end(), is);
}

Result<LineInErrors> load(const std::string& name_or_path, const std::filesystem::path& beside,
                          std::set<std::string>& seen);

Result<LineInErrors> read(const nlohmann::json& json, const std::filesystem::path& file, std::set<std::string>& seen) {
  JsonReader::State state{file.string(), {}};
  const JsonReader reader(json, "", state);
  if (!json.is_object()) {
    reader.allow({});
    return *state.error;
  }
  for (const auto& [key, child] : json.items()) {
    if (!known(key)) {
      JsonReader(child, "/" + key, state)
          .fail("is not a known key", "the keys are listed in resources/errors/README.md");
    }
  }
  if (!reader.has("schema") || reader.at("schema").integer(1, 1) != 1) {
    reader.at("schema").fail("is missing or not 1");
  }
  LineInErrors errors;
  if (reader.has("base") && !state.error) {
    const Result<LineInErrors> base = load(reader.at("base").string(), file.parent_path(), seen);
    if (!base) {
      return base.error();
    }
    errors = *base;
  }
  if (reader.has("title") && !reader.at("title").raw().is_string()) {
    reader.at("title").fail("is not a text");
  }
  for (const NumberKey& entry : kNumbers) {
    if (reader.has(entry.key)) {
      errors.*entry.member = reader.at(entry.key).number(entry.minimum, entry.maximum) * entry.unit;
    }
  }
  for (const SwitchKey& entry : kSwitches) {
    errors.*entry.member = reader.boolean_or(entry.key, errors.*entry.member);
  }
  if (reader.has("drop_frames")) {
    errors.drop_frames = reader.at("drop_frames").integer(0, 100000000);
  }
  if (errors.ringing > 0.0 && (errors.ringing_hz <= 0.0 || errors.ringing_decay_s <= 0.0)) {
    reader.fail("has ringing without ringing_hz and ringing_decay_us", "give both a value above 0");
  }
  if (state.error) {
    return *state.error;
  }
  return errors;
}

Result<LineInErrors> load(const std::string& name_or_path, const std::filesystem::path& beside,
                          std::set<std::string>& seen) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const bool is_name = name_or_path.find('/') == std::string::npos && fs::path(name_or_path).extension() != ".json";
  const fs::path file = is_name ? resources_folder() / "errors" / (name_or_path + ".json")
                        : fs::path(name_or_path).is_relative() && !beside.empty() ? beside / name_or_path
                                                                                  : fs::path(name_or_path);
  if (is_name && !fs::exists(file, ignored)) {
    std::string list;
    for (const std::string& name : shipped_errors()) {
      list += list.empty() ? name : ", " + name;
    }
    return Error{"is no error profile", "\"" + name_or_path + "\"", "use one of " + list + ", or a .json file"};
  }
  if (!seen.insert(fs::weakly_canonical(file, ignored).string()).second) {
    return Error{"is its own base", file.string(), "remove the circle of \"base\""};
  }
  const Result<std::string> text = read_file(file, std::size_t{1} << 20U);
  if (!text) {
    return text.error();
  }
  const Result<nlohmann::json> json = parse_json(*text, file.string());
  if (!json) {
    return json.error();
  }
  return read(*json, file, seen);
}

}  // namespace

Result<LineInErrors> load_errors(const std::string& name_or_path) {
  std::set<std::string> seen;
  return load(name_or_path, {}, seen);
}

std::vector<std::string> shipped_errors() {
  return body::shipped_names("errors");
}

nlohmann::json errors_to_json(const LineInErrors& errors) {
  nlohmann::json json;
  json["schema"] = 1;
  for (const NumberKey& entry : kNumbers) {
    json[entry.key] = errors.*entry.member / entry.unit;
  }
  for (const SwitchKey& entry : kSwitches) {
    json[entry.key] = errors.*entry.member;
  }
  json["drop_frames"] = errors.drop_frames;
  return json;
}

}  // namespace limbwave::simulate
