// What can be done to markers on the timeline's canvas.
#include <QContextMenuEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>

#include "common/theme.h"
#include "timeline/timeline_canvas.h"
#include "timeline/timeline_layout.h"

namespace limbwave::ui {

namespace {

constexpr int kNameWidth = 200, kNameHeight = 24;

}  // namespace

void TimelineCanvas::set_markers_editable(bool editable) {
  markers_editable_ = editable;
  if (!editable && drag_ == Drag::kMarker) {
    drag_ = Drag::kNone;
  }
  update();
}

void TimelineCanvas::select_marker(int number) {
  if (number != selected_marker_) {
    selected_marker_ = number;
    update();
  }
}

std::optional<QPointF> TimelineCanvas::marker_position(int number) const {
  for (const TimelineMarker& marker : markers_) {
    if (number > 0 && marker.number == number) {
      return QPointF(scale().x(marker.time_s), kRulerHeight + kMarkerHeight / 2.0);
    }
  }
  return std::nullopt;
}

const TimelineMarker* TimelineCanvas::editable_marker(int number) const {
  const auto found = std::find_if(markers_.begin(), markers_.end(),
                                  [number](const TimelineMarker& marker) { return marker.number == number; });
  return markers_editable_ && number > 0 && found != markers_.end() ? &*found : nullptr;
}

double TimelineCanvas::marker_time(int number) const {
  const TimelineMarker* marker = editable_marker(number);
  return marker != nullptr ? marker->time_s : -1.0;
}

int TimelineCanvas::marker_at(double pixel) const {
  const TimeScale s = scale();
  for (const bool editable : {true, false}) {
    std::vector<double> xs;
    std::vector<int> indices;
    for (std::size_t i = 0; i < markers_.size(); ++i) {
      if ((markers_[i].number > 0) == editable) {
        xs.push_back(s.x(markers_[i].time_s));
        indices.push_back(static_cast<int>(i));
      }
    }
    if (const int found = hit(xs, pixel, kKeyReach); found >= 0) {
      return indices[static_cast<std::size_t>(found)];
    }
  }
  // What was drawn last lies on top.
  const auto words = std::find_if(drawn_words_.rbegin(), drawn_words_.rend(), [&](const DrawnWords& one) {
    return pixel >= one.left && pixel <= one.right && one.marker < static_cast<int>(markers_.size());
  });
  return words == drawn_words_.rend() ? -1 : words->marker;
}

void TimelineCanvas::drag_marker(const QMouseEvent& event) {
  const QPointF at = event.position();
  if (std::abs(at.x() - pressed_at_.x()) < kDragStarts && dragged_to_s_ < 0.0) {
    return;
  }
  double wanted = scale().time(at.x()) - drag_from_s_;
  if ((event.modifiers() & Qt::AltModifier) == 0) {
    wanted = snapped_to_frame(wanted, time_.frame_s());
  }
  dragged_to_s_ = std::clamp(wanted, 0.0, time_.duration_s());
  time_.set_playhead(dragged_to_s_);  // One sees where one is.
  update();
}

void TimelineCanvas::drop_marker() {
  const TimelineMarker* marker = editable_marker(dragged_marker_);
  // Only the place where it is let go counts: one step of undo, one line in the take.
  if (marker != nullptr && dragged_to_s_ >= 0.0 && dragged_to_s_ != marker->time_s) {
    Q_EMIT marker_moved(dragged_marker_, dragged_to_s_);
  }
  dragged_to_s_ = -1.0;
  update();
}

void TimelineCanvas::edit_marker(int number) {
  const TimelineMarker* marker = editable_marker(number);
  if (marker == nullptr) {
    return;
  }
  delete name_;
  name_ = new QLineEdit(marker->text, this);
  name_->setObjectName(QStringLiteral("marker_name"));
  name_->setAccessibleName(tr("Name of the marker"));
  name_->setMaxLength(200);
  const double x = std::clamp(scale().x(marker->time_s), static_cast<double>(kLabelWidth),
                              std::max(1.0 * kLabelWidth, static_cast<double>(width() - kNameWidth - kGrid)));
  name_->setGeometry(static_cast<int>(x), kRulerHeight + (kMarkerHeight - kNameHeight) / 2, kNameWidth, kNameHeight);
  name_->selectAll();
  name_->show();
  name_->setFocus();
  name_->installEventFilter(this);
  connect(name_, &QLineEdit::editingFinished, this, [this, number, field = name_.data()] {
    if (field != name_) {
      return;
    }
    name_.clear();  // The focus it loses now finishes it no second time.
    field->deleteLater();
    Q_EMIT marker_renamed(number, field->text());
    setFocus();
  });
}

bool TimelineCanvas::eventFilter(QObject* watched, QEvent* event) {
  if (watched == name_ && event->type() == QEvent::KeyPress &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    QLineEdit* field = name_;
    name_.clear();
    field->deleteLater();
    setFocus();
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

void TimelineCanvas::contextMenuEvent(QContextMenuEvent* event) {
  const Hit found = hit_at(event->pos());
  const double time = scale().time(event->pos().x());
  QMenu menu(this);
  if (found.key.lane >= 0) {
    press_key(found.key, Qt::NoModifier);
    menu.addAction(tr("Delete the selected keys"), this, [this] { keys_.remove(keys_.selected()); });
  } else if (found.marker >= 0) {
    const int number = markers_[static_cast<std::size_t>(found.marker)].number;
    if (editable_marker(number) == nullptr) {
      return;
    }
    Q_EMIT marker_clicked(number);
    menu.addAction(tr("Rename the marker"), this, [this, number] { edit_marker(number); });
    menu.addAction(tr("Delete the marker"), this, [this, number] { Q_EMIT marker_removed(number); });
  } else if (found.events && markers_editable_ && time >= 0.0 && time <= time_.duration_s()) {
    const double at = snapped_to_frame(time, time_.frame_s());
    menu.addAction(tr("Set a marker here"), this, [this, at] { Q_EMIT marker_wanted(at); });
  } else if (found.lane >= 0) {
    menu.addAction(tr("Set a key here"), this, [this, lane = found.lane, time] {
      keys_.set_value(lane, time, keys_.model().value_at(lane, time));
    });
  } else {
    return;
  }
  menu.exec(event->globalPos());
}

}  // namespace limbwave::ui
