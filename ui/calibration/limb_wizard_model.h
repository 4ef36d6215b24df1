/// Limb calibration as a sequence of pages, without widgets: choose a limb, get
/// ready, hold two poses without touching the keyboard, look at the verdict,
/// hold a pose again to check it.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <array>
#include <optional>
#include <vector>

#include "calibrate/limb_calibration.h"
#include "calibration/calibration_desk.h"
#include "calibration/movement_meter.h"
#include "calibration/wizard_model.h"

namespace limbwave::ui {

enum class LimbPage { kChoose, kPrepare, kCountdown, kHold, kComputing, kResult, kCheck };

/// One sensor's end.
struct LimbOutcome : Outcome {
  std::optional<calibrate::SensorLimbResult> result;  ///< Empty: refused, `error` says why.
  std::optional<double> before_deg;                   ///< Error of the angle in the attempt that this one replaces.
};

/// One sensor while a pose is held.
struct HolderState {
  int sensor = 0;
  SensorMovement movement;
  bool moves = false;  ///< More than what counts as still.
};

class LimbWizardModel : public WizardModel {
  Q_OBJECT
 public:
  static constexpr double kConfirmS = 1.0;    ///< A still second is followed by this much more, for a longer mean.
  static constexpr double kPatienceS = 10.0;  ///< After which the stillest second so far is offered.
  static constexpr double kForgetS = 60.0;    ///< After which holding starts afresh.

  explicit LimbWizardModel(CalibrationDesk& desk, QObject* parent = nullptr);

  [[nodiscard]] LimbPage page() const { return page_; }

  /// Starts anew with the group that holds `sensor` (−1: the first group that
  /// needs it) and, with `only`, this sensor alone.
  void begin(int sensor, bool only = false);
  [[nodiscard]] int group() const { return group_; }
  void choose_group(int group);
  /// Indices into the rig's accelerometers.
  [[nodiscard]] const std::vector<int>& sensors() const { return sensors_; }
  void choose_sensor(int sensor, bool on);
  [[nodiscard]] const body::LimbPose& pose_text(int pose) const;
  /// Chosen sensors whose range was never calibrated: their directions may be
  /// degrees off.
  [[nodiscard]] QStringList without_range() const;

  [[nodiscard]] QString obstacle() const override;
  void next() override;
  void back() override;
  [[nodiscard]] bool would_lose() const override;
  void cancel() override;

  // Countdown and holding.
  [[nodiscard]] int pose() const { return pose_; }  ///< 0 or 1.
  [[nodiscard]] bool checking() const { return checking_; }
  [[nodiscard]] double countdown_s() const { return countdown_s_; }
  void set_countdown_s(double seconds);
  [[nodiscard]] double countdown_left_s() const { return left_s_; }
  /// Lets wall-clock time pass on the countdown page; the timer calls it, and
  /// so do tests.
  void advance(double elapsed_s);
  [[nodiscard]] const calibrate::PoseProgress& progress() const { return progress_; }
  [[nodiscard]] const std::vector<HolderState>& holders() const { return holders_; }
  [[nodiscard]] double still_threshold_g() const { return calibrate::LimbParameters().good_movement_g; }
  /// 0..1 while the still second is confirmed.
  [[nodiscard]] double captured_fraction() const;
  /// Nobody got still enough, but the stillest second could be used.
  [[nodiscard]] bool can_take_stillest() const;
  void take_stillest();
  /// Goes on without a sensor that gives no signal; at least one other must
  /// remain.
  [[nodiscard]] bool can_leave_out(int sensor) const;
  void leave_out(int sensor);
  /// The device died during the countdown or the pose; it may be back by now.
  [[nodiscard]] bool source_lost() const { return in_pose() && interrupted(); }

  // Result.
  [[nodiscard]] const std::vector<LimbOutcome>& outcomes() const { return outcomes_; }
  /// Why the poses as a whole were refused; empty message: they were not.
  [[nodiscard]] const Error& refusal() const { return refusal_; }
  [[nodiscard]] const Diagnostics& diagnostics() const { return diagnostics_; }
  [[nodiscard]] int count() const override { return static_cast<int>(outcomes_.size()); }
  [[nodiscard]] std::optional<calibrate::Verdict> verdict(int i) const override;
  void repeat(int sensor) override;
  void repeat_both();
  /// Verdicts computed elsewhere: from stretches of a take.
  void show_outcomes(int group, std::vector<LimbOutcome> outcomes, Error refusal,
                     const CalibrationDesk::Target& target);

  // Check.
  void check(int pose);
  [[nodiscard]] const std::vector<calibrate::PoseCheck>& checks() const { return checks_; }

 Q_SIGNALS:
  void counted(int whole_seconds_left);  ///< Once per whole second; 0 when
                                         ///< holding begins.
  void held();                           ///< New readings while holding.
  void captured(int pose);

 protected:
  [[nodiscard]] Outcome& outcome_at(int i) override { return outcomes_.at(static_cast<std::size_t>(i)); }
  void clear_outcomes() override { outcomes_.clear(); }
  [[nodiscard]] CalibrationChange accepted_change() const override;
  void keep_stretch() override;

 private:
  void set_page(LimbPage page);
  [[nodiscard]] bool in_pose() const { return page_ == LimbPage::kCountdown || page_ == LimbPage::kHold; }
  /// Begins anew with the running capture, the choice kept where the rig is the same.
  void take_device();
  void start_poses(const std::vector<int>& sensors);
  void start_countdown(int pose);
  void start_hold();
  void take_frames(const std::vector<decode::AccelerationFrame>& frames);
  void capture();
  void add_pose_segment();
  void compute();
  void compute_check();
  void merge(const Result<calibrate::LimbResult>& result);
  [[nodiscard]] calibrate::RigCalibration with_accepted() const;
  void make_calibrator();

  LimbPage page_ = LimbPage::kChoose;
  int group_ = 0;
  std::vector<int> sensors_;
  std::vector<int> held_by_;  ///< Sensors of the running attempt.
  int pose_ = 0;
  bool checking_ = false;
  double countdown_s_ = 5.0, left_s_ = 0.0;
  QTimer timer_;
  QElapsedTimer clock_;
  std::unique_ptr<calibrate::LimbCalibrator> calibrator_;
  std::array<std::vector<decode::AccelerationFrame>, 2> frames_;
  MovementMeter meter_;
  calibrate::PoseProgress progress_;
  std::vector<HolderState> holders_;
  double ready_since_s_ = -1.0;
  std::vector<LimbOutcome> outcomes_;
  Error refusal_;
  Diagnostics diagnostics_;
  std::vector<calibrate::PoseCheck> checks_;
};

}  // namespace limbwave::ui
