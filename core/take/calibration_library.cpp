#include "take/calibration_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <ctime>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/json_reader.h"

namespace limbwave::take {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kRecordLimit = std::size_t{4} << 20;

// Any text as the name of a file: what is not harmless becomes %XX.
std::string file_name(const std::string& text) {
  std::string name;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool harmless =
        std::isalnum(byte) != 0 || c == '-' || c == '_' || (c == ' ' && !name.empty()) || (c == '.' && !name.empty());
    name += harmless ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return name.empty() ? "%" : name;
}

std::string now_text() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm utc{};
  ::gmtime_r(&now, &utc);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z", utc.tm_year + 1900, utc.tm_mon + 1, utc.tm_mday,
                     utc.tm_hour, utc.tm_min, utc.tm_sec);
}

std::string day(const std::string& date) {
  return date.substr(0, 10);
}

Result<fs::path> save_record(const fs::path& folder, const std::string& date, const nlohmann::json& json) {
  std::error_code code;
  fs::create_directories(folder, code);
  if (code) {
    return Error{"cannot be made (" + code.message() + ")", folder.string(), "check that you may write there"};
  }
  std::string stem = date;
  stem.erase(std::remove(stem.begin(), stem.end(), ':'), stem.end());
  fs::path path = folder / (file_name(stem) + ".json");
  for (int number = 2; fs::exists(path, code); ++number) {
    path = folder / fmt::format("{}-{}.json", file_name(stem), number);
  }
  const Status status = write_file(path, json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  if (!status) {
    return status.error();
  }
  return path;
}

Result<nlohmann::json> read_json(const fs::path& path) {
  const Result<std::string> text = read_file(path, kRecordLimit);
  return text ? parse_json(*text, path.string()) : Result<nlohmann::json>(text.error());
}

Result<SensorRecord> read_sensor(const fs::path& path) {
  const Result<nlohmann::json> json = read_json(path);
  if (!json) {
    return json.error();
  }
  JsonReader::State state{path.string(), {}};
  const JsonReader reader(*json, "", state);
  reader.allow({"schema", "key", "calibration"});
  (void)reader.at("schema").integer(1, 1);
  SensorRecord record{reader.at("key").string(), calibrate::sensor_calibration_from_json(reader.at("calibration")),
                      path};
  if (state.error) {
    return *state.error;
  }
  return record;
}

Result<MountRecord> read_mounts(const fs::path& path) {
  const Result<nlohmann::json> json = read_json(path);
  if (!json) {
    return json.error();
  }
  JsonReader::State state{path.string(), {}};
  const JsonReader reader(*json, "", state);
  reader.allow({"schema", "rig", "subject", "date", "mounts", "keys"});
  (void)reader.at("schema").integer(1, 1);
  MountRecord record{
      reader.at("rig").string(), reader.at("subject").string(), reader.at("date").string(), {}, path, {}};
  for (const JsonReader& mount : reader.at("mounts").items()) {
    record.mounts.push_back(calibrate::mount_calibration_from_json(mount));
  }
  if (reader.has("keys")) {
    for (const JsonReader& key : reader.at("keys").items()) {
      record.keys.push_back(key.string());
    }
    record.keys.resize(record.mounts.size());
  }
  if (state.error) {
    return *state.error;
  }
  return record;
}

std::vector<fs::path> record_files(const fs::path& folder, Diagnostics& findings) {
  std::vector<fs::path> files;
  std::error_code code;
  if (!fs::exists(folder, code)) {
    return files;
  }
  for (fs::recursive_directory_iterator it(folder, code), end; !code && it != end; it.increment(code)) {
    if (it->is_regular_file(code) && it->path().extension() == ".json") {
      files.push_back(it->path());
    }
  }
  if (code) {
    findings.push_back({Severity::kWarning, "library.unreadable", "cannot be listed (" + code.message() + ")",
                        "check its permissions", folder.string(), -1.0});
  }
  return files;
}

Diagnostic unreadable(const Error& error) {
  return {Severity::kWarning, "library.unreadable",
          error.message,      "put back a copy, or delete it and calibrate again",
          error.place,        -1.0};
}

bool is_real(const std::string& method) {
  return !method.empty() && method != "nominal";
}

// "of 2026-03-01 to 2026-04-01"
std::string dates_text(const std::vector<std::string>& dates) {
  const auto [first, last] = std::minmax_element(dates.begin(), dates.end());
  return day(*first) == day(*last) ? "of " + day(*first) : "of " + day(*first) + " to " + day(*last);
}

// "range of 2026-03-01, but none of hand and fingers"
std::string part_text(const std::string& what, const std::vector<std::string>& dates,
                      const std::vector<std::string>& without) {
  if (dates.empty()) {
    return "no " + what;
  }
  const std::string found = what + " " + dates_text(dates);
  return without.empty() ? found : fmt::format("{}, but none of {}", found, fmt::join(without, ", "));
}

// The sensor that a mount is of; empty when the rig has none of this name.
std::string mount_key(const body::Rig& rig, const calibrate::MountCalibration& mount) {
  const auto found = std::find_if(rig.accelerometers.begin(), rig.accelerometers.end(),
                                  [&](const body::Accelerometer& one) { return one.name == mount.sensor; });
  return found == rig.accelerometers.end() ? std::string() : sensor_key(rig, *found);
}

// The board's own name of a mount's sensor; empty where the record does not say.
std::string key_of(const MountRecord& record, std::size_t mount) {
  return mount < record.keys.size() ? record.keys[mount] : std::string();
}

// Where the record says which sensor it was, another board's is not taken for it.
bool is_of(const MountRecord& record, std::size_t mount, const std::string& key) {
  const std::string known = key_of(record, mount);
  return known.empty() || known == key;
}

// The newest that this subject's mounting of this sensor has; null where there is none.
const calibrate::MountCalibration* newest_mount(const LibraryListing& listing, const body::Rig& rig, std::size_t sensor,
                                                const std::string& subject) {
  const body::Accelerometer& accelerometer = rig.accelerometers[sensor];
  const std::string key = sensor_key(rig, accelerometer);
  for (const MountRecord& record : listing.mounts) {
    for (std::size_t m = 0; record.rig == rig.name && record.subject == subject && m < record.mounts.size(); ++m) {
      if (record.mounts[m].sensor == accelerometer.name && is_of(record, m, key)) {
        return &record.mounts[m];
      }
    }
  }
  return nullptr;
}

}  // namespace

std::string sensor_key(const body::Rig& rig, const body::Accelerometer& accelerometer) {
  return accelerometer.serial.empty() ? rig.name + ": " + accelerometer.name : accelerometer.serial;
}

CalibrationLibrary::CalibrationLibrary() : CalibrationLibrary(user_data_folder() / "calibrations") {}
CalibrationLibrary::CalibrationLibrary(fs::path folder) : folder_(std::move(folder)) {}

Result<fs::path> CalibrationLibrary::save_sensor(const std::string& key,
                                                 calibrate::SensorCalibration calibration) const {
  if (calibration.date.empty()) {
    calibration.date = now_text();
  }
  return save_record(
      folder_ / "sensors" / file_name(key), calibration.date,
      {{"schema", 1}, {"key", key}, {"calibration", calibrate::sensor_calibration_to_json(calibration)}});
}

Result<fs::path> CalibrationLibrary::save_mounts(const body::Rig& rig, const std::string& subject,
                                                 std::vector<calibrate::MountCalibration> mounts) const {
  std::string date;
  for (calibrate::MountCalibration& mount : mounts) {
    if (mount.date.empty()) {
      mount.date = now_text();
    }
    date = std::max(date, mount.date);
  }
  if (mounts.empty()) {
    return Error{"there is no limb calibration to keep", rig.name, "calibrate at least one sensor"};
  }
  nlohmann::json list = nlohmann::json::array();
  nlohmann::json keys = nlohmann::json::array();
  for (const calibrate::MountCalibration& mount : mounts) {
    list.push_back(calibrate::mount_calibration_to_json(mount));
    keys.push_back(mount_key(rig, mount));
  }
  return save_record(folder_ / "mounts" / file_name(rig.name) / file_name(subject), date,
                     {{"schema", 1},
                      {"rig", rig.name},
                      {"subject", subject},
                      {"date", date},
                      {"mounts", std::move(list)},
                      {"keys", std::move(keys)}});
}

Status CalibrationLibrary::save(const body::Rig& rig, const std::string& subject,
                                const calibrate::RigCalibration& calibration) const {
  // What came out of the library, or was saved before, is not a new calibration.
  const LibraryListing known = list();
  const std::size_t count = rig.accelerometers.size();
  for (std::size_t i = 0; i < std::min(count, calibration.sensors.size()); ++i) {
    const calibrate::SensorCalibration& sensor = calibration.sensors[i];
    const std::string key = sensor_key(rig, rig.accelerometers[i]);
    const bool is_known = std::any_of(known.sensors.begin(), known.sensors.end(), [&](const SensorRecord& record) {
      return record.key == key &&
             calibrate::sensor_calibration_to_json(record.calibration) == calibrate::sensor_calibration_to_json(sensor);
    });
    if (is_known || !is_real(sensor.method)) {
      continue;
    }
    if (const Result<fs::path> saved = save_sensor(key, sensor); !saved) {
      return saved.error();
    }
  }
  const auto is_known_mount = [&](const calibrate::MountCalibration& mount) {
    return std::any_of(known.mounts.begin(), known.mounts.end(), [&](const MountRecord& record) {
      return record.rig == rig.name && record.subject == subject && [&] {
        for (std::size_t m = 0; m < record.mounts.size(); ++m) {
          if (is_of(record, m, mount_key(rig, mount)) &&
              calibrate::mount_calibration_to_json(record.mounts[m]) == calibrate::mount_calibration_to_json(mount)) {
            return true;
          }
        }
        return false;
      }();
    });
  };
  std::vector<calibrate::MountCalibration> mounts;
  std::copy_if(
      calibration.mounts.begin(), calibration.mounts.end(), std::back_inserter(mounts),
      [&](const calibrate::MountCalibration& mount) { return is_real(mount.method) && !is_known_mount(mount); });
  if (mounts.empty()) {
    return {};
  }
  const Result<fs::path> saved = save_mounts(rig, subject, std::move(mounts));
  return saved ? Status{} : Status(saved.error());
}

LibraryListing CalibrationLibrary::list() const {
  LibraryListing listing;
  for (const fs::path& path : record_files(folder_ / "sensors", listing.diagnostics)) {
    Result<SensorRecord> record = read_sensor(path);
    if (record) {
      listing.sensors.push_back(*std::move(record));
    } else {
      listing.diagnostics.push_back(unreadable(record.error()));
    }
  }
  for (const fs::path& path : record_files(folder_ / "mounts", listing.diagnostics)) {
    Result<MountRecord> record = read_mounts(path);
    if (record) {
      listing.mounts.push_back(*std::move(record));
    } else {
      listing.diagnostics.push_back(unreadable(record.error()));
    }
  }
  // Dates are ISO 8601 in UTC, so that text order is time order; within a second the later file has the longer name.
  const auto newer = [](const std::string& date_a, const fs::path& file_a, const std::string& date_b,
                        const fs::path& file_b) {
    const auto age = [](const fs::path& file) { return std::pair(file.string().size(), file.string()); };
    return date_a != date_b ? date_a > date_b : age(file_a) > age(file_b);
  };
  std::sort(listing.sensors.begin(), listing.sensors.end(), [&](const SensorRecord& a, const SensorRecord& b) {
    return newer(a.calibration.date, a.file, b.calibration.date, b.file);
  });
  std::sort(listing.mounts.begin(), listing.mounts.end(),
            [&](const MountRecord& a, const MountRecord& b) { return newer(a.date, a.file, b.date, b.file); });
  return listing;
}

LibraryLookup CalibrationLibrary::lookup(const body::Rig& rig, const std::string& subject) const {
  return take::lookup(list(), rig, subject);
}

LibraryLookup lookup(const LibraryListing& listing, const body::Rig& rig, const std::string& subject) {
  LibraryLookup result;
  result.diagnostics = listing.diagnostics;
  // Newest first, so that the first one of each stays.
  calibrate::RigCalibration calibration = calibrate::nominal_calibration(rig);
  std::vector<std::string> range_dates, mount_dates, without_range, without_mount;
  for (std::size_t s = 0; s < rig.accelerometers.size(); ++s) {
    const std::string& name = rig.accelerometers[s].name;
    const std::string key = sensor_key(rig, rig.accelerometers[s]);
    const auto sensor = std::find_if(listing.sensors.begin(), listing.sensors.end(),
                                     [&](const SensorRecord& record) { return record.key == key; });
    if (sensor != listing.sensors.end()) {
      calibration.sensors[s] = sensor->calibration;
      range_dates.push_back(sensor->calibration.date);
    } else {
      without_range.push_back(name);
      result.missing.push_back(name + ": no range calibration");
    }
    if (const calibrate::MountCalibration* mount = newest_mount(listing, rig, s, subject)) {
      calibration.mounts[s] = *mount;
      mount_dates.push_back(mount->date);
    } else {
      without_mount.push_back(name);
      result.missing.push_back(name + ": no limb calibration");
    }
  }
  const std::string whose = subject.empty() ? "no named subject" : "\"" + subject + "\"";
  if (range_dates.empty() && mount_dates.empty()) {
    result.explanation = fmt::format("the calibration library has nothing for rig \"{}\" on {}", rig.name, whose);
    return result;
  }
  result.explanation =
      fmt::format("calibration library: {}{} {}", part_text("range", range_dates, without_range),
                  without_range.empty() ? "," : ";", part_text("limbs of " + whose, mount_dates, without_mount));
  result.calibration = std::move(calibration);
  return result;
}

Status CalibrationLibrary::remove(const fs::path& file) const {
  std::error_code code;
  const fs::path inside = fs::weakly_canonical(file, code).lexically_relative(fs::weakly_canonical(folder_, code));
  if (inside.empty() || *inside.begin() == ".." || inside.extension() != ".json") {
    return Error{"is not in the calibration library", file.string(), "name a file that the library lists"};
  }
  if (!fs::exists(file, code)) {
    return Error{"does not exist", file.string(), "name a file that the library lists"};
  }
  fs::path aside = file;
  for (int number = 1; number == 1 || fs::exists(aside, code); ++number) {
    aside = file.string() + ".removed-" + std::to_string(number);
  }
  fs::rename(file, aside, code);
  if (code) {
    return Error{"cannot be taken out (" + code.message() + ")", file.string(), "check its permissions"};
  }
  return {};
}

LibraryLookup library_calibration(const body::Rig& rig, const std::string& subject) {
  return CalibrationLibrary().lookup(rig, subject);
}

}  // namespace limbwave::take
