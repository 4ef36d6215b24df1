/// The way from a take to a clip: decode, align, calibrate, estimate, with a quality report. Live and offline run the
/// same stages (solve/front_end.h).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/progress.h"
#include "base/result.h"
#include "calibrate/calibration.h"
#include "decode/line_in.h"
#include "estimate/inclination.h"
#include "motion/clip.h"
#include "take/take.h"

namespace limbwave::solve {

using estimate::Smoothing;

/// A user's key of a segment's rotation about the vertical, interpolated linearly between keys.
struct HeadingKey {
  double time_s = 0.0;   ///< In the clip.
  double heading = 0.0;  ///< Radians.
};

/// How the body filter solves (solve/body_solve.h).
struct BodyChoice {
  std::string method = "smoother";  ///< "filter", "smoother" or "batch".
  std::string sensors = "AGD";      ///< Any of A, G and D; of these what the take has.
  std::string root = {};            ///< "contacts", "free", "fixed", "truth" or a file; empty: what suits the take.
  bool tune = false;                ///< Noises are found from the take's first seconds.
  bool operator==(const BodyChoice&) const = default;
};

struct SolveSettings {
  std::string name = "default";
  Smoothing smoothing = Smoothing::kChain;
  double smoothing_s = 0.08;                      ///< Time scale; longer is smoother.
  std::vector<std::vector<HeadingKey>> headings;  ///< One list per segment; may be empty.
  decode::LineInParameters line_in;
  /// "auto": the take's snapshot, completed from its own calibration segments where a part of it was never measured;
  /// the source is then "segments". Else the user's library, else the data sheet. Or one source by name: "snapshot" (in
  /// the take), "segments" (alone), "library" or "nominal" (data sheet).
  std::string calibration = "auto";
  /// Of a solve by the body filter; none: by inclination, or nothing was chosen yet.
  std::optional<BodyChoice> body = {};
};

struct SensorQuality {
  std::string sensor;
  double usable = 0.0;       ///< Fraction of frames.
  double trusted = 0.0;      ///< Fraction of frames whose | |f| − g | is small.
  double mean_norm_g = 0.0;  ///< Over still stretches; 1 when calibrated, 0 when it never was at rest.
};

struct QualityReport {
  std::string calibration;  ///< Where it came from, for people.
  /// What was used, before the gain was corrected; none in solves that were stored without it.
  std::optional<calibrate::RigCalibration> used_calibration;
  std::vector<SensorQuality> sensors;
  decode::LineInStatus line;
  Diagnostics diagnostics;
  double take_seconds = 0.0, decode_seconds = 0.0, solve_seconds = 0.0;  ///< Length; wall-clock of the two stages.
};

struct Solve {
  SolveSettings settings;
  motion::Clip clip;
  /// Per accelerometer and frame of the clip: 0..1, how far gravity alone explains the reading. Empty for one that sits
  /// on no segment of the skeleton.
  std::vector<std::vector<float>> trust;
  /// How sure the poses are, where the method tells; stored ten times a second (solve/uncertainty.h).
  struct Uncertainty {
    std::vector<double> times;
    std::vector<std::vector<float>> joint, point;  ///< Per time and segment: σ of its joint, rad, and its end, m.
  } uncertainty;
  QualityReport report;
};

Result<Solve> solve_take(const take::Take& take, const SolveSettings& settings, const Progress& progress);

/// Stores under TAKE/solves/NAME/: killed at any instant, the old solve of that name or the new one is there.
Status save_solve(const take::Take& take, const Solve& solve);
/// Reads it back. Fails when another program has left the clip's joints with keys at different times.
Result<Solve> load_solve(const take::Take& take, const std::string& name);
/// The settings of a stored solve alone, with the user's heading keys: they may be whole where the clip is not.
Result<SolveSettings> load_solve_settings(const take::Take& take, const std::string& name);
/// Keeps headings that were set while the take was being recorded beside its samples, until a solve carries them.
Status save_live_headings(const std::filesystem::path& take_folder,
                          const std::vector<std::vector<HeadingKey>>& headings);
/// The user's headings that a new solve of that name begins with: of the stored one, else those set while it was
/// recorded, else none.
std::vector<std::vector<HeadingKey>> known_headings(const take::Take& take, const std::string& name);
/// Renames a stored solve that cannot be read to "NAME.damaged-1" (or the next free number) beside it, so that nothing
/// overwrites it; `list_solves` passes it over. Returns its new folder.
Result<std::filesystem::path> set_solve_aside(const take::Take& take, const std::string& name);
std::vector<std::string> list_solves(const take::Take& take);

}  // namespace limbwave::solve
