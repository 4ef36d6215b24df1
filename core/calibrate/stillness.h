/// Finds when sensors are held still, and how still.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "calibrate/calibration.h"
#include "calibrate/reading.h"

namespace limbwave::calibrate {

/// A stretch in which sensors were still together.
struct StillWindow {
  std::size_t begin = 0, end = 0;  ///< Readings [begin, end).
  double begin_s = 0.0, end_s = 0.0;
  double movement_g = 0.0;           ///< RMS about the mean over all sensors of the window, g.
  std::vector<double> sensor_g;      ///< The same per sensor, g.
  std::vector<Vector3d> mean_volts;  ///< Mean reading per sensor.
};

struct StillnessParameters {
  double window_s = 1.0;       ///< Shortest stretch that is taken.
  double largest_gap_s = 0.1;  ///< Readings further apart do not belong to one window.
  double cap_g = 0.2;          ///< One sensor's movement counts at most this much, so that a loose one does not decide.
  double extend_factor = 1.25;  ///< A best window grows while its movement stays below this factor of its own.
};

/// The stretch of at least window_s in which the sensors moved least, extended while it stays as still: a longer mean
/// is a better one. All series share their times; `calibrations` (one per series) turn volts into specific force.
/// Empty when no stretch without gaps and unusable readings is long enough.
std::optional<StillWindow> stillest_window(std::span<const SensorSeries> series,
                                           std::span<const SensorCalibration> calibrations,
                                           const StillnessParameters& parameters = {});

/// All disjoint stretches of at least window_s in which the movement stays below `threshold_g`, in order of time.
std::vector<StillWindow> still_windows(std::span<const SensorSeries> series,
                                       std::span<const SensorCalibration> calibrations, double threshold_g,
                                       const StillnessParameters& parameters = {});

}  // namespace limbwave::calibrate
