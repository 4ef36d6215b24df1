/// Limb calibration, once per mounting: from two poses to R_LS, how every sensor sits on its limb (line-in paper §4).
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/result.h"
#include "body/rig.h"
#include "calibrate/calibration.h"
#include "calibrate/reading.h"
#include "calibrate/stillness.h"
#include "decode/slot_alignment.h"

namespace limbwave::calibrate {

/// R_LS from the directions of gravity seen by a sensor in two poses, and what they are in the limb frame.
/// The measured pair is made perpendicular by turning both directions by the same angle (as is the pair of the rig),
/// which is the nearest perpendicular pair in the least-squares sense; then
///   R_LS = g1_L a_Sᵀ + g2_L b_Sᵀ + (g1_L × g2_L)(a_S × b_S)ᵀ.
/// With g1_L = (0,0,−1) and g2_L = (1,0,0) this is equation (1) of the line-in paper, [b, −a×b, −a]ᵀ.
/// Fails when one of the pairs is within 30° of parallel or opposite: the third direction would be noise.
Result<Quaterniond> mounting_from_gravity(const Vector3d& first_S, const Vector3d& second_S, const Vector3d& first_L,
                                          const Vector3d& second_L);

struct LimbParameters {
  double good_angle_deg = 3.0;    ///< Deviation from 90° between the poses up to which the verdict is good.
  double usable_angle_deg = 8.0;  ///< Up to which it is usable.
  double good_movement_g = 0.02;  ///< RMS movement while holding; 0.02 g sways the direction by about 1°.
  double usable_movement_g = 0.06;
  double good_norm_g = 0.03;  ///< | |f|/g − 1 | while holding.
  double usable_norm_g = 0.10;
  bool any_mounting = false;  ///< The sensors are mounted unlike the rig: do not compare with its R_LS.
  StillnessParameters stillness;
};

/// Where holding one pose stands.
struct PoseProgress {
  double seconds = 0.0;          ///< Of readings so far.
  double movement_now_g = 0.0;   ///< RMS over the newest second; infinite before that.
  bool still_now = false;        ///< It is usable.
  double best_movement_g = 0.0;  ///< Of the stillest second so far; infinite before there is one.
  double best_seconds = 0.0;     ///< Length of that still stretch.
  bool ready = false;            ///< A good still stretch was found.
};

/// One sensor's part of a limb calibration.
struct SensorLimbResult {
  int sensor = 0;          ///< Index into Rig::accelerometers.
  MountCalibration mount;  ///< Method "nominal", as in the rig, when the poses gave none.
  Verdict verdict = Verdict::kRepeat;
  std::string text;               ///< Verdict with its number and reason, for people.
  double angle_error_deg = 0.0;   ///< Measured angle between the poses minus 90°.
  double movement_g = 0.0;        ///< Larger of the two poses.
  double norm_error_g = 0.0;      ///< |f|/g − 1 while holding, the larger of the two poses.
  double from_nominal_deg = 0.0;  ///< Rotation between the found and the rig's R_LS.
};

struct LimbResult {
  std::vector<SensorLimbResult> sensors;
  Verdict verdict = Verdict::kRepeat;  ///< The worst of the sensors.
  std::array<StillWindow, 2> windows;  ///< Where the poses were found; indices into what was pushed for each.
  Diagnostics diagnostics;
};

/// What holding a pose again says about a calibration.
struct PoseCheck {
  int sensor = 0;
  double error_deg = 0.0;  ///< Angle between measured and expected direction of gravity.
  double movement_g = 0.0;
  Verdict verdict = Verdict::kRepeat;  ///< With the limits of the angle between poses.
};

/// Both poses of one calibration group. Readings may be pushed live or from a stretch of a take.
class LimbCalibrator {
 public:
  /// `sensors`: indices into the rig's accelerometers to calibrate, the group's own when empty (so that one sensor can
  /// be repeated alone). `range` supplies the range calibrations of all sensors of the rig.
  LimbCalibrator(const body::Rig& rig, const RigCalibration& range, int group, std::vector<int> sensors = {},
                 const LimbParameters& parameters = {});

  /// A frame during pose 0 or 1.
  void push(int pose, const decode::AccelerationFrame& frame);
  void push(int pose, std::span<const decode::AccelerationFrame> frames);
  /// Forgets a pose, to hold it again.
  void clear(int pose);

  [[nodiscard]] PoseProgress progress(int pose) const;
  [[nodiscard]] const std::vector<int>& sensors() const { return sensors_; }

  /// The mounting of every sensor. Fails when a pose has no still second, both poses are the same or opposite, or they
  /// were held in the wrong order; a sensor that alone is bad gets the verdict kRepeat instead.
  [[nodiscard]] Result<LimbResult> finish(const std::string& date = "") const;

  /// Holds pose `index` again, after a calibration: how far every sensor's gravity is from where it should be.
  /// `calibration` has the mountings; fails when there is no still second.
  [[nodiscard]] Result<std::vector<PoseCheck>> check(int index, const RigCalibration& calibration) const;

 private:
  [[nodiscard]] const body::LimbPose& pose(int index) const;
  Status find_window(int index, StillWindow& out) const;
  [[nodiscard]] Status check_poses(const std::array<StillWindow, 2>& windows) const;
  [[nodiscard]] SensorLimbResult judge(std::size_t index, const std::array<StillWindow, 2>& windows,
                                       const std::string& date) const;

  body::Rig rig_;
  body::CalibrationGroup group_;
  std::vector<int> sensors_;
  std::vector<SensorCalibration> calibrations_;  ///< Of `sensors_`.
  LimbParameters parameters_;
  std::array<std::vector<SensorSeries>, 2> series_;
};

}  // namespace limbwave::calibrate
