/// The drawn part of the timeline: ruler, markers, lanes with keys, playhead, overview.
#pragma once

#include <QColor>
#include <QPointF>
#include <QPointer>
#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

#include "common/time_model.h"
#include "timeline/key_commands.h"
#include "timeline/timeline_geometry.h"

class QLineEdit;

namespace limbwave::ui {

/// Something that happened at an instant of the clip.
struct TimelineMarker {
  enum class Kind { kMarker, kLoss, kWarning };
  double time_s = 0.0;  ///< In the clip.
  Kind kind = Kind::kMarker;
  QString text;    ///< What it is, for people.
  int number = 0;  ///< Of a marker within its take; 0: it cannot be edited.
};

/// A named stretch of the clip.
struct TimelineStretch {
  double begin_s = 0.0, end_s = 0.0;
  QString name;
};

/// Scrub in the ruler, wheel to zoom, Shift and wheel or middle drag to move, drag keys and markers, double-click a
/// lane to set a key, the row of events to set a marker, a marker to rename it. Shows the lanes that have keys and the
/// current one.
class TimelineCanvas : public QWidget {
  Q_OBJECT
 public:
  TimelineCanvas(TimeModel& time, KeyEditor& keys, QWidget* parent = nullptr);

  void set_markers(std::vector<TimelineMarker> markers);
  /// Whether markers can be set, moved, renamed and deleted here.
  void set_markers_editable(bool editable);
  /// By its number; 0: none.
  void select_marker(int number);
  [[nodiscard]] int selected_marker() const { return selected_marker_; }
  /// Where a marker is drawn; empty when there is none of that number.
  [[nodiscard]] std::optional<QPointF> marker_position(int number) const;
  /// Of a marker that can be edited, in the clip; negative when there is none of that number.
  [[nodiscard]] double marker_time(int number) const;
  /// Opens a field for the marker's name.
  void edit_marker(int number);
  void set_stretches(std::vector<TimelineStretch> stretches);
  /// The lane that new keys go to; -1: none.
  void set_current_lane(int lane);
  [[nodiscard]] int current_lane() const { return current_lane_; }
  /// What stands in the lanes' place while there are none.
  void set_hint(const QString& hint);

  [[nodiscard]] TimeScale scale() const;
  [[nodiscard]] std::vector<int> visible_lanes() const;
  /// Where a key is drawn; its lane must be visible.
  [[nodiscard]] QPointF key_position(int lane, double time_s) const;
  [[nodiscard]] double ruler_middle() const;

  [[nodiscard]] QSize sizeHint() const override { return {800, 124}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {320, 96}; }

 Q_SIGNALS:
  void lane_clicked(int lane);
  void marker_clicked(int number);
  // What the user wants; whoever owns the markers does it. Times in the clip.
  void marker_wanted(double time_s);
  void marker_moved(int number, double time_s);
  void marker_renamed(int number, const QString& text);
  void marker_removed(int number);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  enum class Drag { kNone, kScrub, kPan, kKeys, kMarker, kOverview };
  struct Hit {
    KeyPlace key;
    int marker = -1;
    int lane = -1;
    bool events = false;  ///< In the row of events.
  };
  [[nodiscard]] Hit hit_at(const QPointF& at) const;
  /// Index of the event under a pixel of their row, or -1; markers go before what else happened there.
  [[nodiscard]] int marker_at(double pixel) const;
  [[nodiscard]] double lanes_top() const;
  [[nodiscard]] double lane_middle(int row) const;
  [[nodiscard]] QRectF overview_rect() const;
  void scrub(double pixel);
  void drag_keys(const QMouseEvent& event);
  void drag_marker(const QMouseEvent& event);
  void drop_marker();
  /// Null: none of that number, or it cannot be edited.
  [[nodiscard]] const TimelineMarker* editable_marker(int number) const;
  void press_key(const KeyPlace& place, Qt::KeyboardModifiers modifiers);
  void paint_ruler(QPainter& painter) const;
  void paint_markers(QPainter& painter) const;
  void paint_lanes(QPainter& painter) const;
  void paint_playhead(QPainter& painter) const;
  void paint_overview(QPainter& painter) const;

  TimeModel& time_;
  KeyEditor& keys_;
  std::vector<TimelineMarker> markers_;
  /// The words of a marker as they were drawn last: they can be caught, too.
  struct DrawnWords {
    int marker;
    double left, right;
  };
  mutable std::vector<DrawnWords> drawn_words_;
  std::vector<TimelineStretch> stretches_;
  QString hint_;
  int current_lane_ = -1;
  int first_row_ = 0;
  Drag drag_ = Drag::kNone;
  QPointF pressed_at_, last_at_;
  double drag_from_s_ = 0.0;   ///< Time under the pointer when the drag began.
  double dragged_by_s_ = 0.0;  ///< How far the keys have come.
  bool markers_editable_ = false;
  int selected_marker_ = 0, dragged_marker_ = 0;
  double dragged_to_s_ = -1.0;  ///< Where the dragged marker is now; negative: not moved yet.
  QPointer<QLineEdit> name_;    ///< The open field of a marker's name.
  int gesture_ = kNoGesture;
};

}  // namespace limbwave::ui
