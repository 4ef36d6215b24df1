/// Every source of error of signals.md §4 that the driver box knows; each switchable by itself.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "base/result.h"

namespace limbwave::simulate {

/// All at their defaults: a perfect world, in which sound still spreads, is absorbed, radiated with a pattern and takes
/// its time. Files: resources/driver_box_errors/*.json, schema in the README.md there.
struct DriverBoxErrors {
  // Sound.
  double snr_db = 300.0;           ///< In-band (5 kHz) peak SNR on a source's axis at 0.6 m; 300: no noise.
  bool occlusion = false;          ///< The body's capsules are in the way of sound.
  double floor_echo = 0.0;         ///< Reflected amplitude, 0..1.
  double wall_echo = 0.0;          ///< Of each of two walls.
  double source_delay = 0.0;       ///< Half range of the sources' own delays, seconds.
  double phase_off_axis = 0.0;     ///< Largest turn of the phase at 60° off a source's normal, radians.
  double phase_left = 0.0;         ///< What calibration leaves of it, radians at 60°.
  double speed_of_sound = 0.0;     ///< Relative, of what the operator entered.
  double source_level_db = 0.0;    ///< σ of the sources' levels.
  double keys_per_minute = 0.0;    ///< Bursts of ultrasound from jingling keys.
  double brakes_per_minute = 0.0;  ///< Whistles near the carrier.
  // Chips, after calibration.
  double accelerometer_noise = 0.0;   ///< m/s² RMS per reading.
  double accelerometer_offset = 0.0;  ///< σ, m/s².
  double accelerometer_scale = 0.0;   ///< σ, relative.
  double accelerometer_cross_axis = 0.0;
  double gyroscope_noise = 0.0;      ///< rad/s RMS per reading.
  double gyroscope_bias = 0.0;       ///< σ, rad/s.
  double gyroscope_bias_walk = 0.0;  ///< rad/s/√s.
  double gyroscope_scale = 0.0;      ///< σ, relative.
  double gyroscope_g = 0.0;          ///< σ of g-sensitivity, rad/s per g.
  bool accumulates = false;          ///< Readings are sums of four 10-bit samples instead of one of 12.
  // Placement and body.
  double mount_angle = 0.0, mount_offset = 0.0;              ///< σ per axis, radians and metres.
  double soft_tissue_angle = 0.0, soft_tissue_offset = 0.0;  ///< Amplitudes of the wobble, radians and metres.
  double bone_length = 0.0;                                  ///< σ, relative.
  double rest_pose = 0.0;                                    ///< Radians per joint, in random directions.
  // Words.
  double word_clock = 0.0;       ///< Half range of the boards' clock offsets, relative.
  double word_drift = 0.0;       ///< Relative RMS of their slow drift (correlation time 10 s).
  double word_bit_errors = 0.0;  ///< Probability that a bit is sent wrong.
};

/// "none", "paper", "calibrated", or a JSON file whose keys override "none" (or its own "base").
Result<DriverBoxErrors> load_driver_box_errors(const std::string& name_or_path);
std::vector<std::string> shipped_driver_box_errors();
/// All keys in the units of the files, as truth.json stores them.
nlohmann::json driver_box_errors_to_json(const DriverBoxErrors& errors);

}  // namespace limbwave::simulate
