/// Range calibration of one accelerometer, once in its life: the user slowly turns it about all its axes (line-in
/// paper §4). Finds offset and scale from gravity; takes readings one by one, so that a wizard can show how far it is.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/result.h"
#include "body/rig.h"
#include "calibrate/calibration.h"
#include "calibrate/range_fit.h"
#include "calibrate/reading.h"
#include "calibrate/sphere_coverage.h"
#include "calibrate/steadiness.h"

namespace limbwave::calibrate {

struct RangeParameters {
  double required_coverage = 0.65;  ///< Fraction of the sphere; below it the calibration is refused.
  double largest_hole = 0.96;       ///< Radians (55°); no direction may be further from a visited one.
  double required_steady_s = 8.0;   ///< Seconds of steady readings.
  double good_residual_g = 0.01;    ///< Held-out RMS of |f|/g − 1 up to which the verdict is good.
  double usable_residual_g = 0.03;  ///< Up to which it is usable.
  SteadinessParameters steadiness;  ///< In nominal g.
};

/// Where a running range calibration stands.
struct RangeProgress {
  double seconds = 0.0;              ///< Since the first reading.
  double steady_s = 0.0;             ///< Of which steady.
  double coverage = 0.0;             ///< Fraction of the sphere, 0..1 (with the nominal calibration).
  bool steady_now = false;           ///< The newest reading that is judged (0.3 s old).
  double unsteadiness_g = 0.0;       ///< There.
  double rate_g_per_s = 0.0;         ///< There; 1 g/s is 57°/s of turning.
  Vector3d up_S = Vector3d::Zero();  ///< There: direction that points up now, sensor frame.
  std::vector<Vector3d> missing;     ///< Directions that should still point up, the most wanted first.
  bool enough = false;               ///< Coverage and time suffice for `finish`.
  std::string hint;                  ///< What to do now: "turn it until −z is up", "turn it more slowly".
};

/// What a range calibration found.
struct RangeResult {
  SensorCalibration calibration;  ///< The better of the two.
  SensorCalibration extremes;     ///< The paper's way; residual_g of all steady readings, hardly any of which made it.
  SensorCalibration ellipsoid;    ///< residual_g of held-out readings.
  Verdict verdict = Verdict::kRepeat;
  std::string text;          ///< The verdict with its number and reason, for people.
  double offset_sd_g = 0.0;  ///< Standard error of the ellipsoid's offset.
  double steady_s = 0.0;
  Diagnostics diagnostics;
};

/// Pushed with the readings of one sensor. Results do not depend on how they are cut into blocks.
class RangeCalibrator {
 public:
  /// `signal` gives the nominal zero and sensitivity; `serial` is written into the result and its messages.
  RangeCalibrator(const body::LineInSignal& signal, std::string serial, const RangeParameters& parameters = {});

  void push(double time_s, const Vector3d& volts, bool usable);
  void push(const SensorSeries& series);

  [[nodiscard]] RangeProgress progress() const;

  /// The calibration from everything pushed so far; may be asked at any time and again later. `date` is ISO 8601, UTC.
  /// Fails, with what to do, when the sensor was never steady, its signal was lost or clipped, an axis is stuck or
  /// doubled, the volume was moved meanwhile, or too little of the sphere was covered.
  [[nodiscard]] Result<RangeResult> finish(const std::string& date = "") const;

 private:
  void consume(const std::vector<SteadySample>& samples);
  [[nodiscard]] Status check_signal(const std::vector<RangeObservation>& steady, Diagnostics& diagnostics) const;
  [[nodiscard]] Status check_axes(const std::vector<RangeObservation>& steady) const;
  [[nodiscard]] Status check_gain(const std::vector<RangeObservation>& few, const EllipsoidFit& fit) const;
  [[nodiscard]] Error refuse(const std::string& message, const std::string& remedy) const;
  [[nodiscard]] SensorCalibration in_volts(const RangeModel& model, const char* method) const;

  body::LineInSignal signal_;
  std::string serial_;
  RangeParameters parameters_;
  SteadinessFilter filter_;
  SphereCoverage live_;
  std::vector<RangeObservation> steady_;
  SteadySample newest_;
  double first_time_s_ = 0.0, last_time_s_ = 0.0;
  std::int64_t readings_ = 0, unusable_ = 0, saturated_ = 0;
  double steady_s_ = 0.0;
  double last_judged_s_ = -1.0;
};

/// Root mean square of |f|/g − 1 over readings that were left out of an ellipsoid fit, five folds of whole 2 s
/// stretches; NaN where a fit failed. (For the extremes this would be no measure: a fold may take the only stretch away
/// in which an axis was upright.)
double held_out_residual(const std::vector<RangeObservation>& steady);

/// Root mean square of |f|/g − 1.
double rms_residual(const std::vector<RangeObservation>& steady, const RangeModel& model);

}  // namespace limbwave::calibrate
