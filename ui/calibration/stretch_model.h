/// Calibrating from any stretch of a take, without widgets: which take, which
/// procedure, which stretches.
#pragma once

#include <QObject>
#include <array>
#include <memory>
#include <vector>

#include "calibration/take_segments.h"
#include "solve/decoded_take.h"

namespace limbwave::ui {

/// What a verdict is asked for.
struct StretchChoice {
  int procedure = -1;  ///< −1: range; else the mounting of this group of the rig.
  std::array<Stretch, 2> stretches{};
  bool operator==(const StretchChoice&) const = default;
};

class StretchModel : public QObject {
  Q_OBJECT
 public:
  explicit StretchModel(CalibrationDesk& desk, QObject* parent = nullptr);

  [[nodiscard]] CalibrationDesk& desk() { return desk_; }
  /// The open take; null: none.
  [[nodiscard]] const std::shared_ptr<const take::Take>& take() const { return take_; }
  /// Its readings; null while they are being decoded, or when that failed.
  [[nodiscard]] const std::shared_ptr<const solve::DecodedTake>& decoded() const { return decoded_; }
  [[nodiscard]] bool decoding() const { return decoding_; }
  /// Why the take has no readings, with what to do; empty: it has, or will
  /// have.
  [[nodiscard]] const QString& problem() const { return problem_; }
  [[nodiscard]] double duration_s() const;

  /// Starts to follow the open take and reads its signals when that was not
  /// done yet.
  void begin();

  /// −1: range; else the mounting of this group of the rig.
  [[nodiscard]] int procedure() const { return choice_.procedure; }
  /// One step of undo. Its stretches are those that the take suggests.
  void set_procedure(int procedure);
  /// How many stretches the procedure needs: 1, or 2 for the two poses.
  [[nodiscard]] int count() const { return procedure() < 0 ? 1 : 2; }
  /// "Sensors are turned", "Pose 1: horizontal"
  [[nodiscard]] QString title(int i) const;
  /// Named segments of the take, those that the stretch is for first.
  [[nodiscard]] std::vector<NamedStretch> suggestions(int i) const;
  [[nodiscard]] const Stretch& stretch(int i) const { return choice_.stretches.at(static_cast<std::size_t>(i)); }
  /// One step of undo; those of one `gesture` (≥ 0) are one together. Kept within the take; a begin behind the end
  /// pushes the end, and the other way round.
  void set_stretch(int i, Stretch wanted, int gesture = -1);
  /// A number for the edits of a new gesture.
  int begin_gesture() { return ++gestures_; }
  [[nodiscard]] const StretchChoice& choice() const { return choice_; }
  /// Without undo. Nothing when the open take has no such group.
  void put_choice(const StretchChoice& choice);

  /// What the verdicts are for: the take.
  [[nodiscard]] CalibrationDesk::Target target() const;
  /// Why no verdict can be computed, with what to do; empty: it can.
  [[nodiscard]] QString obstacle() const;
  /// Ends in `range_found`, `limb_found` or `failed`.
  void compute();

 Q_SIGNALS:
  void changed();          ///< Take, readings or procedure.
  void stretch_changed();  ///< Where a stretch is.
  void range_found(const std::vector<limbwave::ui::RangeOutcome>& outcomes);
  void limb_found(const limbwave::ui::LimbFromTake& found);
  void failed(const limbwave::Error& error);

 private:
  void follow();
  void decode();
  [[nodiscard]] StretchChoice suggested(int procedure) const;
  [[nodiscard]] std::vector<NamedStretch> suggestions(int procedure, int i) const;

  CalibrationDesk& desk_;
  std::shared_ptr<const take::Take> take_;
  int opening_ = -1;  ///< Of that take.
  std::shared_ptr<const solve::DecodedTake> decoded_;
  bool active_ = false, decoding_ = false, computing_ = false;
  QString problem_;
  StretchChoice choice_;
  int gestures_ = 0;
  Job* job_ = nullptr;
};

}  // namespace limbwave::ui
