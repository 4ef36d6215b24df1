/// Range calibration as a sequence of pages, without widgets: choose sensors, read how, turn them, look at the verdict.
#pragma once

#include <QObject>
#include <QTimer>
#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "calibrate/range_calibration.h"
#include "calibration/calibration_desk.h"

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

enum class Decision { kOpen, kAccepted, kDiscarded };

/// One sensor's end.
struct RangeOutcome {
  int sensor = 0;
  std::optional<calibrate::RangeResult> result;  ///< Empty: refused, `error` says why.
  Error error;
  Decision decision = Decision::kOpen;
  std::optional<double> before_g;  ///< Residual of the attempt that this one replaces.
  std::array<bool, calibrate::SphereCoverage::kCells> visited{};
};

/// Which cells of the sphere a running calibration has visited.
std::array<bool, calibrate::SphereCoverage::kCells> visited_cells(const calibrate::RangeProgress& progress);

class RangeWizardModel : public QObject {
  Q_OBJECT
 public:
  static constexpr double kSignalSeconds = 8.0;  ///< Kept for the live picture.

  explicit RangeWizardModel(CalibrationDesk& desk, QObject* parent = nullptr);

  [[nodiscard]] RangePage page() const { return page_; }
  [[nodiscard]] const body::Rig& rig() const { return rig_; }
  [[nodiscard]] const CalibrationDesk::Target& target() const { return target_; }
  [[nodiscard]] CalibrationDesk& desk() { return desk_; }
  [[nodiscard]] const std::vector<int>& chosen() const { return chosen_; }

  /// Starts anew with these sensors chosen (empty: all that were never calibrated, or all).
  void begin(std::vector<int> sensors);
  void choose(int sensor, bool on);
  /// Why "next" is not possible now, with what to do; empty: it is.
  [[nodiscard]] QString obstacle() const;
  /// Enter: goes on from every page; on the turning page it ends the turning; on the result page it saves.
  void next();
  void back();
  /// Whether leaving now would lose turning or verdicts.
  [[nodiscard]] bool would_lose() const;
  void cancel();

  // Turning.
  [[nodiscard]] const std::vector<RangeSensorState>& states() const { return states_; }
  /// The sensor that the page shows: the chosen one, or the one in most need.
  [[nodiscard]] const RangeSensorState* shown() const;
  void show_sensor(int sensor);
  [[nodiscard]] bool all_enough() const;
  [[nodiscard]] double turning_s() const { return turning_s_; }
  /// Newest readings, times in seconds and nominal g, of the sensor shown.
  [[nodiscard]] const std::deque<decode::AccelerationFrame>& recent() const { return recent_; }
  [[nodiscard]] bool source_lost() const { return page_ == RangePage::kTurn && !desk_.source().running(); }
  /// Forgets what was turned so far.
  void start_over();

  // Result.
  [[nodiscard]] const std::vector<RangeOutcome>& outcomes() const { return outcomes_; }
  void decide(int sensor, Decision decision);
  /// Turns this sensor alone once more; the others' verdicts stay.
  void repeat(int sensor);
  [[nodiscard]] int accepted() const;
  /// Puts accepted ones into the library and into use; ends in `saved` or `save_failed`.
  void save();
  /// Verdicts computed elsewhere: from a take's segment.
  void show_outcomes(std::vector<RangeOutcome> outcomes);

 Q_SIGNALS:
  void page_changed();
  void choice_changed();
  void turned();    ///< New readings on the turning page.
  void sufficed();  ///< Every sensor has enough: once.
  void outcomes_changed();
  void saved(int sensors);
  void save_failed(const QString& text);
  void left();  ///< Cancelled, or done.

 private:
  void set_page(RangePage page);
  void start_turning(const std::vector<int>& sensors);
  void take_frames(const std::vector<decode::AccelerationFrame>& frames);
  void update_states();
  void compute();
  void merge(std::vector<RangeOutcome> outcomes);

  CalibrationDesk& desk_;
  CalibrationDesk::Target target_;
  body::Rig rig_;
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
  bool saving_ = false;
  std::uint64_t attempt_ = 0;
};

}  // namespace limbwave::ui
