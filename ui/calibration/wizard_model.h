/// What both calibrations share behind their pages: where verdicts are kept,
/// accepted and saved, and what happens when the device dies. No widgets.
#pragma once

#include <QObject>
#include <optional>
#include <vector>

#include "calibrate/reading.h"
#include "calibration/calibration_desk.h"

namespace limbwave::ui {

enum class Decision { kOpen, kAccepted, kDiscarded };

/// One sensor's end, whatever the procedure.
struct Outcome {
  int sensor = 0;
  Error error;  ///< Why there is no result.
  Decision decision = Decision::kOpen;
};

class WizardModel : public QObject {
  Q_OBJECT
 public:
  explicit WizardModel(CalibrationDesk& desk, QObject* parent = nullptr);

  [[nodiscard]] CalibrationDesk& desk() { return desk_; }
  /// What is calibrated, from the first page to the verdict.
  [[nodiscard]] const CalibrationDesk::Target& target() const { return target_; }
  [[nodiscard]] const body::Rig& rig() const { return target_.rig; }
  [[nodiscard]] const body::Skeleton& skeleton() const { return target_.skeleton; }

  /// Why "next" is not possible now, with what to do; empty: it is.
  [[nodiscard]] virtual QString obstacle() const = 0;
  virtual void next() = 0;
  virtual void back() = 0;
  /// Whether leaving now would lose a movement or verdicts.
  [[nodiscard]] virtual bool would_lose() const = 0;
  virtual void cancel() = 0;

  /// The device died during the movement. What came until then is in the take;
  /// readings that come later do not count.
  [[nodiscard]] bool interrupted() const { return interrupted_; }
  /// Verdicts came out of a take: there is nobody who could repeat them.
  [[nodiscard]] bool from_take() const { return from_take_; }
  /// One sensor can be repeated alone.
  [[nodiscard]] bool repeatable() const { return !from_take() && desk_.source().running(); }

  /// Number of verdicts, of accepted ones, of those that say "repeat" or
  /// refuse.
  [[nodiscard]] virtual int count() const = 0;
  [[nodiscard]] int accepted() const;
  [[nodiscard]] int bad() const;
  [[nodiscard]] const Outcome& outcome(int i) const { return const_cast<WizardModel*>(this)->outcome_at(i); }
  /// Empty: refused.
  [[nodiscard]] virtual std::optional<calibrate::Verdict> verdict(int i) const = 0;
  void decide(int sensor, Decision decision);
  /// This sensor alone once more; the others' verdicts stay.
  virtual void repeat(int sensor) = 0;
  /// Puts accepted ones into the library and into use; ends in `saved` or
  /// `save_failed`.
  void save();

 Q_SIGNALS:
  void page_changed();
  void choice_changed();
  void outcomes_changed();
  void device_lost();  ///< During the movement: once.
  void saved(int sensors);
  void save_failed(const QString& text);
  void left();  ///< Cancelled, or done.

 protected:
  [[nodiscard]] virtual Outcome& outcome_at(int i) = 0;
  virtual void clear_outcomes() = 0;
  /// What saving the accepted ones changes.
  [[nodiscard]] virtual CalibrationChange accepted_change() const = 0;
  /// Good and usable ones are accepted unless the technician says otherwise.
  void accept_good();
  /// Some verdict is there that leaving would lose.
  [[nodiscard]] bool has_open_verdicts() const;
  /// Begins with this target.
  void take_on(CalibrationDesk::Target target);
  /// Readings that come now are of the movement: of the device that it began
  /// with, which did not die in between.
  [[nodiscard]] bool listens() const {
    return !interrupted_ && target_.subject == CalibrationDesk::Subject::kLive && desk_.is_current(target_);
  }
  /// A device was opened for a wizard that began with the open take.
  [[nodiscard]] bool device_came() const {
    return target_.subject == CalibrationDesk::Subject::kTake && desk_.subject() == CalibrationDesk::Subject::kLive;
  }
  /// The movement is running and its device is gone: keeps its take. Call on
  /// every change of the source.
  void notice_loss(bool moving);
  /// Ends the recording with the stretch as far as it got.
  virtual void keep_stretch() = 0;

  CalibrationDesk& desk_;
  CalibrationDesk::Target target_;
  bool from_take_ = false;
  bool saving_ = false;
  bool interrupted_ = false;
  std::uint64_t attempt_ = 0;  ///< Counts computations, so that one that was overtaken is dropped.
};

}  // namespace limbwave::ui
