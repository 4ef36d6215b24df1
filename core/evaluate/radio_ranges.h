/// Real ranges against optical truth: recordings of radio ranging between fixed anchors and tags on a rigid body.
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "base/result.h"
#include "decode/range_gate.h"

namespace limbwave::evaluate {

/// One recording: all ranges at a time, and where the body really was.
struct RadioRecording {
  std::string name;  ///< "dynamic_exp_mid"
  std::vector<Eigen::Vector3d> anchors_W;
  std::vector<Eigen::Vector3d> tags_B;  ///< In the body's frame.
  struct Row {
    double time_s = 0.0;         ///< Since the recording's first row.
    std::vector<double> ranges;  ///< By anchor, then tag; NaN: none.
  };
  struct Pose {
    double time_s = 0.0;
    Eigen::Vector3d p_WB = Eigen::Vector3d::Zero();
    Eigen::Quaterniond R_WB = Eigen::Quaterniond::Identity();
  };
  std::vector<Row> rows;
  std::vector<Pose> poses;
};

/// All recordings of a folder: UWB_NAME.csv beside motion_capture_NAME.csv, geometry in the tables of
/// README.upstream.md, whose tags have y and z the wrong way round. Fails with file and line.
Result<std::vector<RadioRecording>> load_radio_recordings(const std::filesystem::path& folder);

/// Errors are measured minus true range, in millimetres. "Raw" is as measured, "accepted" what the gate believes,
/// without its estimate of the pair's offset.
struct RadioStatistics {
  std::int64_t count = 0;                                                   ///< Ranges with a truth.
  std::int64_t accepted = 0;                                                ///< Of these.
  double raw_median_mm = 0, raw_sd_mm = 0, raw_p95_mm = 0, raw_max_mm = 0;  ///< Absolute ones; sd of signed ones.
  double median_mm = 0, mean_mm = 0, sd_mm = 0, p95_mm = 0, max_mm = 0;     ///< Of accepted ranges, likewise.
  /// RMS of accepted errors over the standard deviation that the gate gave each; 1 where its variances are true.
  double normalised_rms = 0;
  /// Of ranges that are off by more than half a metre from what their pair usually is off by: how many there are, how
  /// many of these are accepted.
  std::int64_t outliers = 0, outliers_accepted = 0;
  double place_median_mm = 0;  ///< Of the tags, horizontally.
};

/// Rows `first` to `last` (not included) count; the gates begin at `first`.
RadioStatistics evaluate_radio(const RadioRecording& recording, const decode::RangeGateParameters& parameters,
                               std::size_t first, std::size_t last);

/// What is known about a body in a room beforehand: it is among the anchors, about as high as they are.
decode::RangeGateParameters radio_parameters(const RadioRecording& recording);

nlohmann::json radio_to_json(const RadioStatistics& statistics);

}  // namespace limbwave::evaluate
