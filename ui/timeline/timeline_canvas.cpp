#include "timeline/timeline_canvas.h"

#include <QApplication>
#include <QHelpEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "common/theme.h"
#include "timeline/timeline_layout.h"

namespace limbwave::ui {

TimelineCanvas::TimelineCanvas(TimeModel& time, KeyEditor& keys, QWidget* parent)
    : QWidget(parent), time_(time), keys_(keys) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Timeline"));
  setContextMenuPolicy(Qt::DefaultContextMenu);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  const auto redraw = [this] { update(); };
  connect(&time_, &TimeModel::extent_changed, this, redraw);
  connect(&time_, &TimeModel::playhead_changed, this, redraw);
  connect(&time_, &TimeModel::visible_changed, this, redraw);
  connect(&keys_, &KeyEditor::selection_changed, this, redraw);
  connect(&keys_.model(), &KeyModel::keys_changed, this, redraw);
  connect(&keys_.model(), &KeyModel::lanes_changed, this, [this] {
    first_row_ = 0;
    update();
  });
}

void TimelineCanvas::set_markers(std::vector<TimelineMarker> markers) {
  markers_ = std::move(markers);
  if (drag_ == Drag::kMarker && editable_marker(dragged_marker_) == nullptr) {
    drag_ = Drag::kNone;
  }
  update();
}

void TimelineCanvas::set_stretches(std::vector<TimelineStretch> stretches) {
  stretches_ = std::move(stretches);
  update();
}

void TimelineCanvas::set_current_lane(int lane) {
  current_lane_ = lane;
  update();
}

void TimelineCanvas::set_hint(const QString& hint) {
  hint_ = hint;
  update();
}

TimeScale TimelineCanvas::scale() const {
  return {time_.visible_begin_s(), time_.visible_end_s(), kLabelWidth + 8.0,
          std::max(1.0, static_cast<double>(width() - kLabelWidth - kRightMargin))};
}

std::vector<int> TimelineCanvas::visible_lanes() const {
  std::vector<int> lanes;
  for (int lane = 0; lane < keys_.model().lane_count(); ++lane) {
    if (lane == current_lane_ || !keys_.model().keys(lane).empty()) {
      lanes.push_back(lane);
    }
  }
  return lanes;
}

double TimelineCanvas::lanes_top() const {
  return kRulerHeight + kMarkerHeight;
}
double TimelineCanvas::lane_middle(int row) const {
  return lanes_top() + kLaneHeight * (row - first_row_ + 0.5);
}
double TimelineCanvas::ruler_middle() const {
  return kRulerHeight / 2.0;
}

QRectF TimelineCanvas::overview_rect() const {
  const TimeScale s = scale();
  return {s.left, height() - kOverviewHeight - 4.0, s.width, static_cast<double>(kOverviewHeight)};
}

QPointF TimelineCanvas::key_position(int lane, double time_s) const {
  const std::vector<int> lanes = visible_lanes();
  const auto row = std::find(lanes.begin(), lanes.end(), lane) - lanes.begin();
  return {scale().x(time_s), lane_middle(static_cast<int>(row))};
}

TimelineCanvas::Hit TimelineCanvas::hit_at(const QPointF& at) const {
  Hit found;
  const TimeScale s = scale();
  if (at.y() >= kRulerHeight && at.y() < lanes_top()) {
    found.events = true;
    found.marker = marker_at(at.x());
    return found;
  }
  const std::vector<int> lanes = visible_lanes();
  const auto row = static_cast<int>(std::floor((at.y() - lanes_top()) / kLaneHeight)) + first_row_;
  if (at.y() < lanes_top() || at.y() > overview_rect().top() - 4 || row >= static_cast<int>(lanes.size())) {
    return found;
  }
  found.lane = lanes[static_cast<std::size_t>(row)];
  std::vector<double> xs;
  for (const LaneKey& key : keys_.model().keys(found.lane)) {
    xs.push_back(s.x(key.time_s));
  }
  const int index = hit(xs, at.x(), kKeyReach);
  if (index >= 0) {
    found.key = {found.lane, keys_.model().keys(found.lane)[static_cast<std::size_t>(index)].id};
  }
  return found;
}

void TimelineCanvas::scrub(double pixel) {
  time_.set_playhead(scale().time(pixel));
}

void TimelineCanvas::press_key(const KeyPlace& place, Qt::KeyboardModifiers modifiers) {
  std::vector<KeyPlace> places = keys_.selected();
  const auto mine = std::find(places.begin(), places.end(), place);
  if ((modifiers & (Qt::ShiftModifier | Qt::ControlModifier)) != 0) {
    if (mine != places.end()) {
      places.erase(mine);
    } else {
      places.push_back(place);
    }
    keys_.select(places);
  } else if (mine == places.end()) {
    keys_.select({place});
  }
}

void TimelineCanvas::mousePressEvent(QMouseEvent* event) {
  if (drag_ != Drag::kNone) {
    return;
  }
  const QPointF at = event->position();
  pressed_at_ = last_at_ = at;
  if (event->button() == Qt::MiddleButton) {
    drag_ = Drag::kPan;
    return;
  }
  if (event->button() != Qt::LeftButton || time_.duration_s() <= 0.0) {
    return;
  }
  if (at.y() >= overview_rect().top() - 4) {
    drag_ = Drag::kOverview;
    mouseMoveEvent(event);
    return;
  }
  const Hit found = hit_at(at);
  if (found.marker >= 0) {
    const TimelineMarker marker = markers_[static_cast<std::size_t>(found.marker)];
    time_.set_playhead(marker.time_s);
    if (marker.number > 0) {
      Q_EMIT marker_clicked(marker.number);
    }
    if (editable_marker(marker.number) != nullptr) {
      drag_ = Drag::kMarker;
      dragged_marker_ = marker.number;
      dragged_to_s_ = -1.0;
      drag_from_s_ = scale().time(at.x()) - marker.time_s;
    }
    return;
  }
  if (found.lane >= 0) {
    Q_EMIT lane_clicked(found.lane);
  }
  if (found.key.lane >= 0) {
    press_key(found.key, event->modifiers());
    drag_ = Drag::kKeys;
    gesture_ = keys_.begin_gesture();
    drag_from_s_ = scale().time(at.x());
    dragged_by_s_ = 0.0;
    return;
  }
  if (at.x() >= kLabelWidth) {
    keys_.select({});
    drag_ = Drag::kScrub;
    scrub(at.x());
  }
}

void TimelineCanvas::mouseMoveEvent(QMouseEvent* event) {
  const QPointF at = event->position();
  switch (drag_) {
    case Drag::kNone: {
      const Hit found = hit_at(at);
      const bool marker =
          found.marker >= 0 && editable_marker(markers_[static_cast<std::size_t>(found.marker)].number) != nullptr;
      setCursor(found.key.lane >= 0 || marker ? Qt::SizeHorCursor : Qt::ArrowCursor);
      break;
    }
    case Drag::kScrub:
      scrub(at.x());
      break;
    case Drag::kPan: {
      const double by = (last_at_.x() - at.x()) * scale().seconds_per_pixel();
      time_.set_visible(time_.visible_begin_s() + by, time_.visible_end_s() + by);
      break;
    }
    case Drag::kOverview: {
      const QRectF bar = overview_rect();
      const double middle = time_.duration_s() * (at.x() - bar.left()) / std::max(1.0, bar.width());
      const double half = (time_.visible_end_s() - time_.visible_begin_s()) / 2;
      const double begin = std::clamp(middle - half, 0.0, std::max(0.0, time_.duration_s() - 2 * half));
      time_.set_visible(begin, begin + 2 * half);
      break;
    }
    case Drag::kKeys:
      drag_keys(*event);
      break;
    case Drag::kMarker:
      drag_marker(*event);
      break;
  }
  last_at_ = at;
}

void TimelineCanvas::drag_keys(const QMouseEvent& event) {
  const QPointF at = event.position();
  if (std::abs(at.x() - pressed_at_.x()) < kDragStarts && dragged_by_s_ == 0.0) {
    return;
  }
  double wanted = scale().time(at.x()) - drag_from_s_;
  const auto before = keys_.selected();
  if (before.empty()) {
    return;
  }
  if ((event.modifiers() & Qt::AltModifier) == 0) {
    wanted = snapped_to_frame(wanted, time_.frame_s());
  }
  const double first = keys_.model().find(before.front().lane, before.front().id)->time_s;
  keys_.move(before, wanted - dragged_by_s_, gesture_);
  // Keys that were held back catch up once there is room again.
  dragged_by_s_ += keys_.model().find(before.front().lane, before.front().id)->time_s - first;
}

void TimelineCanvas::mouseReleaseEvent(QMouseEvent* /*event*/) {
  if (drag_ == Drag::kMarker) {
    drop_marker();
  }
  drag_ = Drag::kNone;
}

void TimelineCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
  const Hit found = hit_at(event->position());
  const double time = scale().time(event->position().x());
  const bool left = event->button() == Qt::LeftButton && event->position().x() >= kLabelWidth;
  if (left && found.marker >= 0) {
    edit_marker(markers_[static_cast<std::size_t>(found.marker)].number);
  } else if (left && found.events && markers_editable_ && time >= 0.0 && time <= time_.duration_s()) {
    Q_EMIT marker_wanted(snapped_to_frame(time, time_.frame_s()));
  } else if (left && found.lane >= 0 && found.key.lane < 0) {
    keys_.set_value(found.lane, time, keys_.model().value_at(found.lane, time));
  } else {
    mousePressEvent(event);
  }
}

void TimelineCanvas::wheelEvent(QWheelEvent* event) {
  const QPoint delta = event->angleDelta();
  const bool sideways = (event->modifiers() & Qt::ShiftModifier) != 0 || delta.x() != 0;
  const bool over_names = event->position().x() < kLabelWidth;
  if (over_names) {
    const auto rows = static_cast<int>(visible_lanes().size());
    const int fit = std::max(1, static_cast<int>((overview_rect().top() - lanes_top()) / kLaneHeight));
    first_row_ = std::clamp(first_row_ - (delta.y() > 0 ? 1 : -1), 0, std::max(0, rows - fit));
    update();
  } else if (sideways) {
    const double by =
        -(delta.x() != 0 ? delta.x() : delta.y()) / 120.0 * 0.1 * (time_.visible_end_s() - time_.visible_begin_s());
    time_.set_visible(time_.visible_begin_s() + by, time_.visible_end_s() + by);
  } else {
    time_.zoom(std::pow(1.25, delta.y() / 120.0), scale().time(event->position().x()));
  }
  event->accept();
}

bool TimelineCanvas::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) {
    return QWidget::event(event);
  }
  const auto* help = static_cast<QHelpEvent*>(event);
  const Hit found = hit_at(help->pos());
  QString text;
  if (found.key.lane >= 0) {
    const LaneKey* key = keys_.model().find(found.key.lane, found.key.id);
    text = tr("%1: %2° at %3 s")
               .arg(keys_.model().lane_name(found.key.lane), QLocale().toString(degrees(key->value), 'f', 1),
                    QLocale().toString(key->time_s, 'f', 3));
  } else if (found.marker >= 0) {
    const TimelineMarker& marker = markers_[static_cast<std::size_t>(found.marker)];
    text = tr("%1 at %2 s").arg(marker.text, QLocale().toString(marker.time_s, 'f', 3));
  } else if (found.events && markers_editable_) {
    text = tr("Double-click sets a marker");
  } else if (found.lane >= 0) {
    text = tr("%1: double-click sets a key").arg(keys_.model().lane_name(found.lane));
  }
  QToolTip::showText(help->globalPos(), text, this);
  return true;
}

}  // namespace limbwave::ui
