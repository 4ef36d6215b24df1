/// A solve against the truth: geodesic, inclination and position errors (overview.md, "What evaluate --json says").
#pragma once

#include <filesystem>
#include <limits>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
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
    std::vector<double> times;             ///< Strictly increasing; samples without orientation are left out.
    std::vector<Eigen::Quaterniond> R_WL;  ///< One per time, unit.
    std::vector<Eigen::Vector3d> p_WL;     ///< One per time, metres; NaN where it is not known.
  };
  std::vector<SegmentTruth> segments;
};

/// truth.json of a simulated take:
/// {"schema": 1, "rate_hz": R, "segments": [{"name", "q_WL": [[w,x,y,z] | null, ...], "p_WL": [[x,y,z] | null, ...]}]}.
/// Sample i lies at i / R seconds; null where it is not known; "p_WL" may be missing; other keys are ignored.
Result<Truth> load_truth(const std::filesystem::path& file);
Result<Truth> truth_from_json(std::string_view text, const std::string& place);
/// The CSV form of overview.md: time_s,segment,qw,qx,qy,qz,px_m,py_m,pz_m. Columns in any order, others ignored,
/// positions may be missing, empty cells are not known; rows in time order for each segment.
Result<Truth> load_truth_csv(const std::filesystem::path& file);
Result<Truth> truth_from_csv(std::string_view text, const std::string& place);

/// Angles are geodesic, in degrees; sd about the mean; p95 with linear interpolation between samples. What there are no
/// data for is NaN and missing in the JSON form.
struct ErrorStatistics {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  double mean_deg = kNone, sd_deg = kNone, rms_deg = kNone, p95_deg = kNone, max_deg = kNone;
  double position_mean_mm = kNone;  ///< Euclidean, of the segment's joint.
  /// Angle between the vertical as the estimate and as the truth have it in the segment's frame: what gravity can tell.
  double inclination_mean_deg = kNone, inclination_rms_deg = kNone, inclination_max_deg = kNone;
};

struct Evaluation {
  std::map<std::string, ErrorStatistics> joints;    ///< Orientation relative to the parent; without the root.
  std::map<std::string, ErrorStatistics> segments;  ///< World orientation, with inclination.
  ErrorStatistics all;                              ///< World orientation of all segments at all times.
  /// As `all`, but only while every segment of the truth stands still: it turns by less than 0.02° and moves by less
  /// than 0.2 mm in the quarter of a second before and after. There gravity is all that accelerometers feel.
  ErrorStatistics still;
  double still_fraction = 0;  ///< Of the instants that were compared, how many were still; 0: none, `still` is NaN.
  double take_seconds = 0, decode_seconds = 0, solve_seconds = 0;  ///< 0: not known, missing in the JSON form.
};

/// `clip_start_s`: where the clip's time 0 lies in the take. Compares at the clip's keys that the truth covers: on a
/// sample, or between two that are no further apart than one and a half times their usual distance, interpolated.
/// A clip without root motion is moved so that its root joint lies on the truth's at every instant; where the truth's
/// root is not known, its positions are not compared. Segments are matched by name. Fails when nothing is in common.
Result<Evaluation> evaluate(const motion::Clip& clip, double clip_start_s, const Truth& truth);
nlohmann::json evaluation_to_json(const Evaluation& evaluation);

}  // namespace limbwave::evaluate
