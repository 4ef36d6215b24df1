/// Recordings of real accelerations, played back as what the sensors of a rig feel.
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"

namespace limbwave::simulate {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// One sensor's log.
struct ForceLog {
  std::string name;                              ///< Of the sensor, where the file names several; else empty.
  std::vector<double> times;                     ///< Seconds, strictly increasing.
  std::vector<Vector3d> f_S;                     ///< Specific force, m/s², sensor frame.
  std::vector<std::optional<Quaterniond>> R_WS;  ///< True orientation, z up, where the file has it.
  [[nodiscard]] double duration() const { return times.back() - times.front(); }
};

/// Reads a comma-separated log (.csv, .csv.gz) with the columns time_s, ax_m_s2, ay_m_s2, az_m_s2, where it has them
/// `sensor` (its name: one log each) and the truth truth_qw .. truth_qz, empty where unknown; or the Xsens MTw text
/// form
/// (.txt: comment lines with the update rate, tab-separated PacketCounter, Acc_X .. Acc_Z, Mat[r][c]), whose lost
/// packets become gaps. At least one log of at least two seconds. Errors name the line.
Result<std::vector<ForceLog>> read_force_file(const std::filesystem::path& path);

/// Every sensor of a rig plays one log, or a stretch of one: of n logs, sensor s plays log s mod n. Where several
/// share a log, they start at evenly spaced places of it and wrap around (blended over half a second, without truth).
class RecordedForces {
 public:
  RecordedForces(std::vector<ForceLog> logs, int sensors);
  /// The shortest log's length, seconds.
  [[nodiscard]] double duration() const { return duration_; }
  /// Specific force, m/s², sensor frame; cubic between samples. Periodic beyond the duration of the sensor's log.
  [[nodiscard]] Vector3d force(int sensor, double time_s) const;
  /// R_WS where it is known at both neighbouring samples.
  [[nodiscard]] std::optional<Quaterniond> orientation(int sensor, double time_s) const;

 private:
  struct Place {
    const ForceLog* log;
    double time;
  };
  [[nodiscard]] Place place(int sensor, double time_s) const;
  std::vector<ForceLog> logs_;
  std::vector<double> starts_;
  double duration_ = 0.0;
};

/// A file, several separated by ';', or a folder of logs (in the order of their names).
Result<std::vector<ForceLog>> read_force_logs(const std::string& source, int sensors);

}  // namespace limbwave::simulate
