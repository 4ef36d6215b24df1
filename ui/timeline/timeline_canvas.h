/// The drawn part of the timeline: ruler, markers, lanes with keys, playhead, overview.
#pragma once

#include <QColor>
#include <QPointF>
#include <QString>
#include <QWidget>
#include <vector>

#include "common/time_model.h"
#include "timeline/key_commands.h"
#include "timeline/timeline_geometry.h"

namespace limbwave::ui {

/// Something that happened at an instant of the clip.
struct TimelineMarker {
  enum class Kind { kMarker, kLoss, kWarning };
  double time_s = 0.0;  ///< In the clip.
  Kind kind = Kind::kMarker;
  QString text;   ///< What it is, for people.
  int index = 0;  ///< Of the event in the take.
};

/// A named stretch of the clip.
struct TimelineStretch {
  double begin_s = 0.0, end_s = 0.0;
  QString name;
};

/// Scrub in the ruler, wheel to zoom, Shift and wheel or middle drag to move, drag keys, double-click a lane to set a
/// key. Shows the lanes that have keys and the current one.
class TimelineCanvas : public QWidget {
  Q_OBJECT
 public:
  TimelineCanvas(TimeModel& time, KeyEditor& keys, QWidget* parent = nullptr);

  void set_markers(std::vector<TimelineMarker> markers);
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
  void marker_clicked(int index);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  bool event(QEvent* event) override;

 private:
  enum class Drag { kNone, kScrub, kPan, kKeys, kOverview };
  struct Hit {
    KeyPlace key;
    int marker = -1;
    int lane = -1;
  };
  [[nodiscard]] Hit hit_at(const QPointF& at) const;
  [[nodiscard]] double lanes_top() const;
  [[nodiscard]] double lane_middle(int row) const;
  [[nodiscard]] QRectF overview_rect() const;
  void scrub(double pixel);
  void press_key(const KeyPlace& place, Qt::KeyboardModifiers modifiers);
  void paint_ruler(QPainter& painter) const;
  void paint_markers(QPainter& painter) const;
  void paint_lanes(QPainter& painter) const;
  void paint_playhead(QPainter& painter) const;
  void paint_overview(QPainter& painter) const;

  TimeModel& time_;
  KeyEditor& keys_;
  std::vector<TimelineMarker> markers_;
  std::vector<TimelineStretch> stretches_;
  QString hint_;
  int current_lane_ = -1;
  int first_row_ = 0;
  Drag drag_ = Drag::kNone;
  QPointF pressed_at_, last_at_;
  double drag_from_s_ = 0.0;   ///< Time under the pointer when the drag began.
  double dragged_by_s_ = 0.0;  ///< How far the keys have come.
  int gesture_ = kNoGesture;
};

}  // namespace limbwave::ui
