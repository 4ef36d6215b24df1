/// The timeline that Solve and Export share: transport, ruler, events, keys.
#pragma once

#include <QWidget>

#include "common/time_model.h"
#include "timeline/key_commands.h"
#include "timeline/timeline_canvas.h"

class QAction;
class QComboBox;
class QLabel;
class QToolButton;

namespace limbwave::ui {

/// Keys of the keyboard work in the whole window while the timeline is shown (but never take a letter from a text
/// field): Space, J, K, L, arrows, Home, End, I sets a key, Del removes keys or the marker, F2
/// renames the marker, Alt and arrows nudge.
class TimelineWidget : public QWidget {
  Q_OBJECT
 public:
  TimelineWidget(TimeModel& time, KeyEditor& keys, QWidget* parent = nullptr);

  [[nodiscard]] TimelineCanvas& canvas() { return *canvas_; }
  /// The lane that new keys go to; -1: none.
  void set_current_lane(int lane);
  /// By its number; 0: none.
  void select_marker(int number);
  /// Goes on with the speed chosen in the box, after J or L.
  void toggle_playing();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void build_transport();
  void show_state();
  void shuttle(int direction);
  /// -1 / 1: the key before / after the playhead on the visible lanes.
  void go_to_key(int direction);
  /// Of the selected marker.
  bool handle_marker_key(int key, bool alt, bool plain);
  bool handle_key(int key, Qt::KeyboardModifiers modifiers);

  TimeModel& time_;
  KeyEditor& keys_;
  TimelineCanvas* canvas_;
  bool had_any_ = true;  ///< Something to play when it was last looked at.
  QToolButton *play_ = nullptr, *loop_ = nullptr, *add_ = nullptr, *remove_ = nullptr;
  QComboBox* speed_ = nullptr;
  QLabel *now_ = nullptr, *length_ = nullptr;
};

}  // namespace limbwave::ui
