/// Rotations about the vertical of the live figure, as the user sets them while watching. Gravity cannot tell them;
/// what is set holds from then on. While a take is being recorded every turn becomes keys of that take, at the moment
/// at which it was made.
#pragma once

#include <QObject>
#include <QTimer>
#include <filesystem>
#include <string>
#include <vector>

#include "common/studio_context.h"
#include "solve/solve.h"
#include "timeline/key_commands.h"

namespace limbwave::ui {

class LiveHeadings : public QObject {
  Q_OBJECT
 public:
  /// The context's own, made when first asked for.
  static LiveHeadings& of(StudioContext& context);
  explicit LiveHeadings(StudioContext& context);

  /// Of a segment of the running capture's skeleton, radians.
  [[nodiscard]] double value(int segment) const;
  /// Undoable; edits of one gesture are one step, and in a recording one turn from its begin to its end. False when
  /// nothing runs, or nothing changes.
  bool set(int segment, double heading, int gesture = kNoGesture);
  /// A number for the edits of a new gesture.
  int begin_gesture() { return ++gestures_; }

  /// Keys in the time of the last recording, one list per segment, when it is the take in this folder; else none.
  [[nodiscard]] std::vector<std::vector<solve::HeadingKey>> keys_of(const std::filesystem::path& folder) const;

 Q_SIGNALS:
  void changed();

 private:
  friend class TurnLiveCommand;
  /// One turn within the recording; times in the recording, seconds.
  struct Turn {
    int id = 0;
    int segment = 0;
    double begin_s = 0.0, end_s = 0.0;
    double before = 0.0, after = 0.0;
  };
  void follow_state();
  void follow_recording();
  /// Turns a segment now. False when it does not exist any more.
  bool apply(int segment, double heading);
  [[nodiscard]] double recorded_s() const;
  /// Puts the recording's keys into its take, soon: whatever happens to this program, they are with the samples.
  void keep_soon();
  void keep();

  StudioContext& context_;
  std::vector<std::string> names_;  ///< Of the segments that `values_` belong to.
  std::vector<double> values_;
  bool recording_ = false;
  std::filesystem::path folder_;  ///< Of the running or the last recording.
  std::vector<double> start_;     ///< When it began.
  std::vector<Turn> turns_;       ///< In it, in order.
  int gestures_ = 0, turn_ids_ = 0;
  QTimer keep_;
};

}  // namespace limbwave::ui
