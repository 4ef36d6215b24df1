/// Range calibration as a sequence of pages, without widgets: choose sensors,
/// read how, turn them, look at the verdict.
#pragma once

#include <QObject>
#include <QTimer>
#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "calibrate/range_calibration.h"
#include "calibration/calibration_desk.h"
#include "calibration/wizard_model.h"

namespace limbwave::ui {

enum class RangePage { kChoose, kInstructions, kTurn, kComputing, kResult };

/// What the person who turns the sensors is told.
enum class RangeAdvice { kWaiting, kNoSignal, kSlower, kSmoother, kTurnTo, kEnough, kComplete };

/// One sensor while it is turned.
struct RangeSensorState {
  int sensor = 0;
  calibrate::RangeProgress progress;
  bool lost = false;  ///< No usable reading for half a second: a cable.
  RangeAdvice advice = RangeAdvice::kWaiting;
  std::array<bool, calibrate::SphereCoverage::kCells> visited{};
};

/// One sensor's end.
struct RangeOutcome : Outcome {
  std::optional<calibrate::RangeResult> result;  ///< Empty: refused, `error` says why.
  std::optional<double> before_g;                ///< Residual of the attempt that this one replaces.
  std::array<bool, calibrate::SphereCoverage::kCells> visited{};
};

/// Which cells of the sphere a running calibration has visited.
std::array<bool, calibrate::SphereCoverage::kCells> visited_cells(const calibrate::RangeProgress& progress);

class RangeWizardModel : public WizardModel {
  Q_OBJECT
 public:
  static constexpr double kSignalSeconds = 8.0;  ///< Kept for the live picture.

  explicit RangeWizardModel(CalibrationDesk& desk, QObject* parent = nullptr);

  [[nodiscard]] RangePage page() const { return page_; }
  [[nodiscard]] const std::vector<int>& chosen() const { return chosen_; }

  /// Starts anew with these sensors chosen (empty: all that were never
  /// calibrated, or all).
  void begin(std::vector<int> sensors);
  void choose(int sensor, bool on);
  [[nodiscard]] QString obstacle() const override;
  /// Enter: goes on from every page; on the turning page it ends the turning;
  /// on the result page it saves.
  void next() override;
  void back() override;
  [[nodiscard]] bool would_lose() const override;
  void cancel() override;

  // Turning.
  [[nodiscard]] const std::vector<RangeSensorState>& states() const { return states_; }
  /// The sensor that the page shows: the chosen one, or the one in most need.
  [[nodiscard]] const RangeSensorState* shown() const;
  void show_sensor(int sensor);
  [[nodiscard]] bool all_enough() const;
  [[nodiscard]] double turning_s() const { return turning_s_; }
  /// Newest readings, times in seconds and nominal g, of the sensor shown.
  [[nodiscard]] const std::deque<decode::AccelerationFrame>& recent() const { return recent_; }
  /// The device died while the sensors were turned; it may be back by now.
  [[nodiscard]] bool source_lost() const { return page_ == RangePage::kTurn && interrupted(); }
  /// Forgets what was turned so far. After the device died: begins again, when
  /// it is back.
  void start_over();
  [[nodiscard]] bool can_start_over() const { return !interrupted() || desk_.source().running(); }

  // Result.
  [[nodiscard]] const std::vector<RangeOutcome>& outcomes() const { return outcomes_; }
  [[nodiscard]] int count() const override { return static_cast<int>(outcomes_.size()); }
  [[nodiscard]] std::optional<calibrate::Verdict> verdict(int i) const override;
  void repeat(int sensor) override;
  /// Verdicts computed elsewhere: from a stretch of a take.
  void show_outcomes(std::vector<RangeOutcome> outcomes, const CalibrationDesk::Target& target);

 Q_SIGNALS:
  void turned();    ///< New readings on the turning page.
  void sufficed();  ///< Every sensor has enough: once.

 protected:
  [[nodiscard]] Outcome& outcome_at(int i) override { return outcomes_.at(static_cast<std::size_t>(i)); }
  void clear_outcomes() override { outcomes_.clear(); }
  [[nodiscard]] CalibrationChange accepted_change() const override;
  void keep_stretch() override;

 private:
  void set_page(RangePage page);
  void start_turning(const std::vector<int>& sensors);
  void take_frames(const std::vector<decode::AccelerationFrame>& frames);
  void update_states();
  void compute();
  void merge(std::vector<RangeOutcome> outcomes);

  RangePage page_ = RangePage::kChoose;
  std::vector<int> chosen_;
  std::vector<int> turning_;
  std::vector<calibrate::RangeCalibrator> calibrators_;
  std::vector<double> last_usable_s_;
  std::vector<RangeSensorState> states_;
  std::vector<RangeOutcome> outcomes_;
  std::deque<decode::AccelerationFrame> recent_;
  int shown_ = -1;
  double first_s_ = -1.0, newest_s_ = 0.0, turning_s_ = 0.0;
  bool told_enough_ = false;
};

}  // namespace limbwave::ui
