/// What a simulated take gives the estimators, beside the true inclinations; for tests and tables of smoothing.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "base/units.h"
#include "estimate/inclination.h"
#include "evaluate/evaluate.h"
#include "geometry/so3.h"
#include "solve/compose.h"
#include "solve/decoded_take.h"
#include "solve/limb_forces.h"
#include "solve/take_calibration.h"
#include "support/simulated_take.h"

namespace limbwave::testing_support {

/// Everything by sensor and frame.
struct LimbReadings {
  body::Rig rig;
  body::Skeleton skeleton;
  std::vector<std::vector<estimate::ForceSample>> samples;
  std::vector<std::vector<std::optional<Eigen::Vector3d>>> up_L;  ///< The truth, where there is one.
  std::vector<std::vector<bool>> moving;  ///< The segment or one that it hangs on turns by more than 10°/s.
};

/// Decodes and calibrates a take as a solve does, and looks up its truth.
inline LimbReadings limb_readings(const take::Take& take) {
  LimbReadings readings;
  readings.rig = take.info.rig;
  readings.skeleton = take.info.skeleton;
  const solve::DecodedTake decoded = require(solve::decode_take(take, {}, {}));
  const solve::ChosenCalibration chosen = require(solve::choose_calibration(take, decoded, "auto"));
  const evaluate::Truth truth = require(evaluate::load_truth(take.folder / "truth.json"));
  const auto frames = decoded.of(take, take.info.capture());
  const auto at = [&](std::size_t segment, double time_s) -> std::optional<Eigen::Quaterniond> {
    const evaluate::Truth::SegmentTruth& one = truth.segments.at(segment);
    const auto after =
        static_cast<std::size_t>(std::lower_bound(one.times.begin(), one.times.end(), time_s) - one.times.begin());
    if (after == 0 || after >= one.times.size() || one.times[after] - one.times[after - 1] > 0.02) {
      return {};
    }
    const double u = (time_s - one.times[after - 1]) / (one.times[after] - one.times[after - 1]);
    return one.R_WL[after - 1].slerp(u, one.R_WL[after]);
  };
  const auto turning = [&](std::size_t segment, double time_s) {
    const auto before = at(segment, time_s - 0.05);
    const auto after = at(segment, time_s + 0.05);
    return before && after && geometry::geodesic_angle(*before, *after) > 0.1 * radians(10.0);
  };
  const std::vector<int> segments = solve::sensor_segments(readings.rig, readings.skeleton);
  for (std::size_t s = 0; s < segments.size(); ++s) {
    readings.samples.push_back(solve::limb_forces(frames, s, readings.rig.line_in, chosen.calibration));
    auto& up_L = readings.up_L.emplace_back();
    std::vector<bool>& moving = readings.moving.emplace_back();
    for (const decode::AccelerationFrame& frame : frames) {
      const auto R_WL = at(static_cast<std::size_t>(segments[s]), frame.time_s);
      up_L.push_back(R_WL ? std::optional<Eigen::Vector3d>(R_WL->conjugate() * Eigen::Vector3d::UnitZ())
                          : std::nullopt);
      bool any = false;
      for (int i = segments[s]; i >= 0 && !any; i = readings.skeleton.segments[static_cast<std::size_t>(i)].parent) {
        any = turning(static_cast<std::size_t>(i), frame.time_s);
      }
      moving.push_back(any);
    }
  }
  return readings;
}

/// Errors of inclination, degrees.
struct InclinationFigures {
  std::vector<double> errors;

  void add(const InclinationFigures& other) { errors.insert(errors.end(), other.errors.begin(), other.errors.end()); }
  [[nodiscard]] double mean() const {
    double sum = 0.0;
    for (const double error : errors) {
      sum += error;
    }
    return errors.empty() ? 0.0 : sum / static_cast<double>(errors.size());
  }
  [[nodiscard]] double quantile(double fraction) const {
    if (errors.empty()) {
      return 0.0;
    }
    std::vector<double> sorted = errors;
    const auto place = static_cast<std::ptrdiff_t>(fraction * static_cast<double>(sorted.size() - 1));
    std::nth_element(sorted.begin(), sorted.begin() + place, sorted.end());
    return sorted[static_cast<std::size_t>(place)];
  }
};

/// Over all sensors; `within`: fraction of moving samples within two standard deviations (0.86 for two normal axes).
struct StillAndMoving {
  InclinationFigures still, moving;
  double within = 0.0;

  void add(const StillAndMoving& other) {
    const auto count = static_cast<double>(moving.errors.size());
    const auto more = static_cast<double>(other.moving.errors.size());
    within = count + more > 0.0 ? (within * count + other.within * more) / (count + more) : 0.0;
    still.add(other.still);
    moving.add(other.moving);
  }
};

/// `estimates` by sensor and frame. The first and last quarter second of a take do not count.
inline StillAndMoving errors_of(const LimbReadings& readings,
                                const std::vector<std::vector<estimate::Inclination>>& estimates) {
  StillAndMoving figures;
  double within = 0.0;
  for (std::size_t s = 0; s < estimates.size(); ++s) {
    for (std::size_t i = 15; i + 15 < estimates[s].size(); ++i) {
      if (!readings.up_L[s][i] || !estimates[s][i].known) {
        continue;
      }
      const double error = geometry::angle_between(*readings.up_L[s][i], estimates[s][i].up_L);
      if (readings.moving[s][i]) {
        figures.moving.errors.push_back(degrees(error));
        within += error <= 2.0 * estimates[s][i].sd_rad ? 1.0 : 0.0;
      } else {
        figures.still.errors.push_back(degrees(error));
      }
    }
  }
  figures.within = figures.moving.errors.empty() ? 0.0 : within / static_cast<double>(figures.moving.errors.size());
  return figures;
}

}  // namespace limbwave::testing_support
