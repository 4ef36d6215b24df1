/// Simulated line-in takes: a motion → what five accelerometers feel → voltages → the multiplexed stereo signal.
/// Shares with decoders and estimators only format definitions (rig, skeleton, take, sample formats).
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "acquire/live_source.h"
#include "acquire/sample_format.h"
#include "base/progress.h"
#include "base/result.h"
#include "body/rig.h"
#include "body/skeleton.h"
#include "simulate/driver_box_errors.h"
#include "simulate/errors.h"

namespace limbwave::simulate {

struct SimulateSettings {
  /// Name of a built-in motion, a .bvh file, or recorded accelerations: .csv, .csv.gz or Xsens .txt logs (one for all
  /// sensors, several separated by ';', or a folder).
  std::string motion = "wave";
  double motion_metres_per_unit = 0.0;  ///< Of a BVH file; 0 = guessed from the size of the figure.
  std::string rig = "line-in-arm";
  LineInErrors errors;
  std::string errors_name = "none";
  /// Of a rig with a driver box; empty: the profile called `errors_name`.
  std::optional<DriverBoxErrors> driver_box_errors;
  double temperature_c = 22.0;  ///< Of the air, as the operator entered it; driver box only.
  std::uint64_t seed = 1;
  double seconds = 0.0;  ///< 0 = the motion's own length.
  acquire::StreamFormat format{SampleRate{48000.0}, 2, acquire::SampleType::kInt16};
  bool prologue = true;  ///< Start with the range and limb calibration, as segments of the take.
  /// Of the live simulator: its wearer does what the source is asked for (LiveSource::ask), then goes on.
  bool obliging = false;
};

std::vector<std::string> builtin_motions();

/// The rig with the serials of the sensors that a simulation with this seed has: "SIM-<seed>-<n>", n from 1. What is
/// captured live from the simulator goes by it, so that its calibrations are never taken for a real board's.
body::Rig simulated_rig(body::Rig rig, std::uint64_t seed);

/// Writes a whole take with truth.json; with a rig that has a driver box, of its wires. The folder must not exist.
/// Cancelled or failed: nothing is left.
Status simulate_take(const std::filesystem::path& folder, const SimulateSettings& settings, const Progress& progress);

/// A take of a driver box alone; `simulate_take` calls it for rigs that have one.
Status simulate_driver_box_take(const std::filesystem::path& folder, const SimulateSettings& settings,
                                const Progress& progress);

/// The simulator as a live device, in real time, looping its motion. Runs its own thread.
Result<std::unique_ptr<acquire::LiveSource>> open_simulator(const SimulateSettings& settings);

}  // namespace limbwave::simulate
