#include "take/calibration_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <ctime>
#include <map>
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
  reader.allow({"schema", "rig", "subject", "date", "mounts"});
  (void)reader.at("schema").integer(1, 1);
  MountRecord record{reader.at("rig").string(), reader.at("subject").string(), reader.at("date").string(), {}, path};
  for (const JsonReader& mount : reader.at("mounts").items()) {
    record.mounts.push_back(calibrate::mount_calibration_from_json(mount));
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

std::string dates_text(std::string first, std::string last) {
  first = day(first);
  last = day(last);
  return first == last ? "of " + first : "of " + first + " to " + last;
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

Result<fs::path> CalibrationLibrary::save_mounts(const std::string& rig, const std::string& subject,
                                                 std::vector<calibrate::MountCalibration> mounts) const {
  std::string date;
  for (calibrate::MountCalibration& mount : mounts) {
    if (mount.date.empty()) {
      mount.date = now_text();
    }
    date = std::max(date, mount.date);
  }
  if (mounts.empty()) {
    return Error{"there is no limb calibration to keep", rig, "calibrate at least one sensor"};
  }
  nlohmann::json list = nlohmann::json::array();
  for (const calibrate::MountCalibration& mount : mounts) {
    list.push_back(calibrate::mount_calibration_to_json(mount));
  }
  return save_record(folder_ / "mounts" / file_name(rig) / file_name(subject), date,
                     {{"schema", 1}, {"rig", rig}, {"subject", subject}, {"date", date}, {"mounts", std::move(list)}});
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
      return record.rig == rig.name && record.subject == subject &&
             std::any_of(record.mounts.begin(), record.mounts.end(), [&](const calibrate::MountCalibration& other) {
               return calibrate::mount_calibration_to_json(other) == calibrate::mount_calibration_to_json(mount);
             });
    });
  };
  std::vector<calibrate::MountCalibration> mounts;
  std::copy_if(
      calibration.mounts.begin(), calibration.mounts.end(), std::back_inserter(mounts),
      [&](const calibrate::MountCalibration& mount) { return is_real(mount.method) && !is_known_mount(mount); });
  if (mounts.empty()) {
    return {};
  }
  const Result<fs::path> saved = save_mounts(rig.name, subject, std::move(mounts));
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
  const LibraryListing listing = list();
  LibraryLookup result;
  result.diagnostics = listing.diagnostics;
  // Newest first, so that the first one of each stays.
  std::map<std::string, const calibrate::SensorCalibration*> sensors;
  for (const SensorRecord& record : listing.sensors) {
    sensors.emplace(record.key, &record.calibration);
  }
  std::map<std::string, const calibrate::MountCalibration*> mounts;
  for (const MountRecord& record : listing.mounts) {
    if (record.rig == rig.name && record.subject == subject) {
      for (const calibrate::MountCalibration& mount : record.mounts) {
        mounts.emplace(mount.sensor, &mount);
      }
    }
  }
  calibrate::RigCalibration calibration;
  std::vector<std::string> sensor_dates, mount_dates;
  for (const body::Accelerometer& accelerometer : rig.accelerometers) {
    const auto sensor = sensors.find(sensor_key(rig, accelerometer));
    const auto mount = mounts.find(accelerometer.name);
    if (sensor == sensors.end()) {
      result.missing.push_back(accelerometer.name + ": no range calibration");
    } else {
      calibration.sensors.push_back(*sensor->second);
      sensor_dates.push_back(sensor->second->date);
    }
    if (mount == mounts.end()) {
      result.missing.push_back(accelerometer.name + ": no limb calibration");
    } else {
      calibration.mounts.push_back(*mount->second);
      mount_dates.push_back(mount->second->date);
    }
  }
  const std::string whose = subject.empty() ? "no named subject" : "\"" + subject + "\"";
  if (!result.missing.empty() || rig.accelerometers.empty()) {
    result.explanation =
        fmt::format("the calibration library lacks {} of {} entries for rig \"{}\" on {} ({})", result.missing.size(),
                    2 * rig.accelerometers.size(), rig.name, whose, fmt::join(result.missing, "; "));
    return result;
  }
  const auto [sensor_first, sensor_last] = std::minmax_element(sensor_dates.begin(), sensor_dates.end());
  const auto [mount_first, mount_last] = std::minmax_element(mount_dates.begin(), mount_dates.end());
  result.explanation =
      fmt::format("calibration library: range {}, limbs of {} {}", dates_text(*sensor_first, *sensor_last), whose,
                  dates_text(*mount_first, *mount_last));
  result.calibration = std::move(calibration);
  return result;
}

Status CalibrationLibrary::remove(const fs::path& file) const {
  std::error_code code;
  const fs::path inside = fs::weakly_canonical(file, code).lexically_relative(fs::weakly_canonical(folder_, code));
  if (inside.empty() || *inside.begin() == ".." || inside.extension() != ".json") {
    return Error{"is not in the calibration library", file.string(), "name a file that the library lists"};
  }
  if (!fs::remove(file, code)) {
    return Error{code ? "cannot be deleted (" + code.message() + ")" : "does not exist", file.string(),
                 "check its permissions"};
  }
  return {};
}

LibraryLookup library_calibration(const body::Rig& rig, const std::string& subject) {
  return CalibrationLibrary().lookup(rig, subject);
}

}  // namespace limbwave::take
