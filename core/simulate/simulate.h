/// Simulated line-in takes: a motion → what five accelerometers feel → voltages → the multiplexed stereo signal.
/// Shares with decoders and estimators only format definitions (rig, skeleton, take, sample formats).
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "acquire/live_source.h"
#include "acquire/sample_format.h"
#include "base/progress.h"
#include "base/result.h"
#include "body/rig.h"
#include "body/skeleton.h"

namespace limbwave::simulate {

/// Every source of error of signals.md §4 that the line-in path knows; each switchable. Files: resources/errors/*.json.
struct LineInErrors {
  // Sensors, per axis; σ of a normal distribution drawn once per sensor.
  double accelerometer_noise = 0.0;  ///< m/s² RMS per reading.
  double offset_g = 0.0;             ///< σ, fraction of g.
  double scale = 0.0;                ///< σ, relative.
  double cross_axis = 0.0;           ///< σ of every off-diagonal term.
  bool saturates = false;            ///< At the rig's range.
  // Placement and wearer.
  double mount_angle = 0.0;        ///< σ of the mounting's rotation, radians.
  double mount_offset = 0.0;       ///< σ, metres.
  double pose_angle = 0.0;         ///< How far off the wearer's calibration poses are, radians.
  double soft_tissue_angle = 0.0;  ///< Amplitude of the wobble in step with the motion, radians.
  // Electronics.
  double clock_offset = 0.0;  ///< Relative, of the RC clock.
  double clock_wander = 0.0;  ///< Relative RMS of its slow drift.
  double clock_jitter = 0.0;  ///< Relative RMS per slot.
  double coupling_hz = 0.0;   ///< Corner of the sound card's high pass; 0 = DC coupled.
  double ringing = 0.0;       ///< Overshoot at slot edges, fraction of the step.
  double ringing_hz = 0.0, ringing_decay_s = 0.0;
  bool anti_alias = false;   ///< The card's linear-phase low pass with its pre- and post-ringing.
  double noise_db = -300.0;  ///< White noise, dB relative to full scale, RMS.
  double hum = 0.0;          ///< Mains hum at 50 Hz, fraction of full scale.
  double gain = 0.7;         ///< Full-scale fraction that the larger channel reaches nominally.
  bool left_inverted = false, right_inverted = false, swapped = false;
  double knob_time_s = -1.0, knob_factor = 1.0;  ///< The volume is moved at that time of the take by that factor.
  double drop_every_s = 0.0;
  std::int64_t drop_frames = 0;  ///< Samples lost by the recorder, without notice.
};

/// "none", "paper", or a JSON file whose keys override "none" (or its own "base").
Result<LineInErrors> load_errors(const std::string& name_or_path);

struct SimulateSettings {
  std::string motion = "wave";  ///< Name of a built-in motion, a .bvh file, or a .csv[.gz] acceleration log.
  std::string rig = "line-in-arm";
  LineInErrors errors;
  std::string errors_name = "none";
  std::uint64_t seed = 1;
  double seconds = 0.0;  ///< 0 = the motion's own length.
  acquire::StreamFormat format{SampleRate{48000.0}, 2, acquire::SampleType::kInt16};
  bool prologue = true;  ///< Start with the range and limb calibration, as segments of the take.
};

std::vector<std::string> builtin_motions();

/// Writes a whole take with truth.json. The folder must not exist. Cancelled or failed: nothing is left.
Status simulate_take(const std::filesystem::path& folder, const SimulateSettings& settings, const Progress& progress);

/// The simulator as a live device, in real time, looping its motion. Runs its own thread.
Result<std::unique_ptr<acquire::LiveSource>> open_simulator(const SimulateSettings& settings);

}  // namespace limbwave::simulate
