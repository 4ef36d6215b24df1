/// A solve against the truth: geodesic, inclination and position errors (overview.md, "What evaluate --json says").
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "base/result.h"
#include "motion/clip.h"
#include "solve/solve.h"
#include "take/take.h"

namespace limbwave::evaluate {

/// What was really done: world poses of segments over time, seconds since the start of the take.
struct Truth {
  struct SegmentTruth {
    std::string name;
    std::vector<double> times;
    std::vector<Eigen::Quaterniond> R_WL;
    std::vector<Eigen::Vector3d> p_WL;
  };
  std::vector<SegmentTruth> segments;
};

/// truth.json of a simulated take.
Result<Truth> load_truth(const std::filesystem::path& file);
/// The CSV form of overview.md: time_s,segment,qw,qx,qy,qz,px_m,py_m,pz_m.
Result<Truth> load_truth_csv(const std::filesystem::path& file);

struct ErrorStatistics {
  double mean_deg = 0, sd_deg = 0, rms_deg = 0, p95_deg = 0, max_deg = 0, position_mean_mm = 0;
  double inclination_mean_deg = 0, inclination_rms_deg = 0, inclination_max_deg = 0;
};

struct Evaluation {
  std::map<std::string, ErrorStatistics> joints;    ///< Joint-relative orientation.
  std::map<std::string, ErrorStatistics> segments;  ///< World orientation, with inclination.
  ErrorStatistics all;
  double take_seconds = 0, decode_seconds = 0, solve_seconds = 0;
};

/// `clip_start_s`: where the clip's time 0 lies in the take. Compares at the clip's keys that the truth covers.
Result<Evaluation> evaluate(const motion::Clip& clip, double clip_start_s, const Truth& truth);
nlohmann::json evaluation_to_json(const Evaluation& evaluation);

}  // namespace limbwave::evaluate
