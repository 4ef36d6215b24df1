/// Every source of error of signals.md §4 that the line-in path knows; each switchable by itself.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "base/result.h"

namespace limbwave::simulate {

/// All zero: a perfect world. Files: resources/errors/*.json, schema in the README.md there.
struct LineInErrors {
  // Sensors, per axis; σ of a normal distribution, cut at 3 σ, drawn once per sensor.
  double accelerometer_noise = 0.0;  ///< m/s² RMS per reading, that is per slot.
  double offset_g = 0.0;             ///< σ, fraction of g.
  double scale = 0.0;                ///< σ, relative.
  double cross_axis = 0.0;           ///< σ of every off-diagonal term.
  bool saturates = false;            ///< At the rig's range.
  // Placement and wearer.
  double mount_angle = 0.0;         ///< σ of the mounting's rotation about each axis, radians.
  double mount_offset = 0.0;        ///< σ along each axis, metres.
  double pose_angle = 0.0;          ///< How far off the wearer's calibration poses are, radians, in random directions.
  double soft_tissue_angle = 0.0;   ///< Amplitude of the wobble in step with the motion, radians.
  double soft_tissue_offset = 0.0;  ///< The same of the sensor's position, metres.
  // Electronics.
  double clock_offset = 0.0;  ///< Relative, of the RC clock.
  double clock_wander = 0.0;  ///< Relative RMS of its slow drift (Ornstein–Uhlenbeck, correlation time 5 s).
  double clock_jitter = 0.0;  ///< Relative RMS per slot.
  double settle_s = 0.0;      ///< Time constant with which the multiplexer's output approaches a new slot's value.
  double coupling_hz = 0.0;   ///< Corner of the sound card's high pass; 0 = DC coupled.
  double ringing = 0.0;       ///< Amplitude of the damped oscillation after slot edges, fraction of the step.
  double ringing_hz = 0.0, ringing_decay_s = 0.0;
  bool anti_alias = false;   ///< The card's linear-phase low pass with its pre- and post-ringing.
  double noise_db = -300.0;  ///< White noise, dB relative to full scale, RMS.
  double hum = 0.0;          ///< Mains hum at 50 Hz, amplitude as a fraction of full scale.
  double gain = 0.7;         ///< Full-scale fraction that the larger channel reaches nominally.
  bool dither = false;       ///< Triangular dither of two steps width before rounding to integers.
  bool left_inverted = false, right_inverted = false, swapped = false;
  double knob_time_s = -1.0, knob_factor = 1.0;  ///< The volume is moved at that time of the take by that factor.
  double drop_every_s = 0.0;
  std::int64_t drop_frames = 0;                            ///< Samples lost by the recorder, without notice.
  double silence_time_s = -1.0, silence_duration_s = 0.0;  ///< The plug is out: only noise and hum are left.
};

/// "none", "paper", "electronics", "accurate", or a JSON file whose keys override "none" (or its own "base").
/// Unknown keys and impossible values are refused with the path of the key.
Result<LineInErrors> load_errors(const std::string& name_or_path);
/// Names of the shipped profiles.
std::vector<std::string> shipped_errors();
/// All keys in the units of the files, as truth.json stores them.
nlohmann::json errors_to_json(const LineInErrors& errors);

}  // namespace limbwave::simulate
