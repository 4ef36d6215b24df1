/// The calibrations that outlive a take: per physical sensor (once in its life) and per mounting on a subject.
/// On disk: FOLDER/sensors/KEY/DATE.json and FOLDER/mounts/RIG/SUBJECT/DATE.json; nothing is overwritten, so that the
/// history with dates and residuals stays.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/result.h"
#include "body/rig.h"
#include "calibrate/calibration.h"

namespace limbwave::take {

/// What a sensor is known by: its serial or, without one, its place on its board ("line-in-arm: forearm").
std::string sensor_key(const body::Rig& rig, const body::Accelerometer& accelerometer);

struct SensorRecord {
  std::string key;
  calibrate::SensorCalibration calibration;
  std::filesystem::path file;
};

/// The sensors that were calibrated in one go; other sensors of the rig may be in other records.
struct MountRecord {
  std::string rig;
  std::string subject;
  std::string date;
  std::vector<calibrate::MountCalibration> mounts;
  std::filesystem::path file;
  /// `sensor_key` of each mount's sensor, so that another board's mounting is not taken for this one's; empty in
  /// records that were written without.
  std::vector<std::string> keys;
};

/// Everything in the library, newest first; files that could not be read are findings, not failures.
struct LibraryListing {
  std::vector<SensorRecord> sensors;
  std::vector<MountRecord> mounts;
  Diagnostics diagnostics;
};

/// What the library knows about one rig on one subject.
struct LibraryLookup {
  /// One entry per accelerometer: the newest of each, the data sheet's where there is none. Empty only when the library
  /// has nothing at all for this rig.
  std::optional<calibrate::RigCalibration> calibration;
  std::vector<std::string> missing;  ///< One line each: "forearm: no range calibration".
  std::string explanation;           ///< Where it came from, and what is missing; one line for people.
  Diagnostics diagnostics;           ///< Files that could not be read.
};

/// What the listing of a library knows about one rig on one subject. Ranges are found by sensor alone: they hold on
/// whoever wears it. Mounts are the subject's.
LibraryLookup lookup(const LibraryListing& listing, const body::Rig& rig, const std::string& subject);

class CalibrationLibrary {
 public:
  /// The user's own: user_data_folder()/calibrations.
  CalibrationLibrary();
  explicit CalibrationLibrary(std::filesystem::path folder);

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  /// Adds a range calibration; its `date` is set to now when empty. Returns the file.
  Result<std::filesystem::path> save_sensor(const std::string& key, calibrate::SensorCalibration calibration) const;
  /// Adds a limb calibration of some or all sensors of a rig. Returns the file.
  Result<std::filesystem::path> save_mounts(const body::Rig& rig, const std::string& subject,
                                            std::vector<calibrate::MountCalibration> mounts) const;
  /// Both for all sensors of a rig that were really calibrated (method other than "nominal") and are not in the library
  /// already.
  Status save(const body::Rig& rig, const std::string& subject, const calibrate::RigCalibration& calibration) const;

  [[nodiscard]] LibraryListing list() const;
  [[nodiscard]] LibraryLookup lookup(const body::Rig& rig, const std::string& subject) const;
  /// Takes out one record by the file that `list` or `save_*` gave; refuses files that are not in the library. Nobody
  /// calibrates for nothing: the file stays beside the others as NAME.json.removed-1.
  Status remove(const std::filesystem::path& file) const;

 private:
  std::filesystem::path folder_;
};

/// `lookup` in the user's own library.
LibraryLookup library_calibration(const body::Rig& rig, const std::string& subject);

}  // namespace limbwave::take
