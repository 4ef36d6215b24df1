#include "timeline/timeline_widget.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/units.h"
#include "common/icons.h"
#include "common/theme.h"
#include "common/widgets.h"
#include "timeline/shuttle.h"
#include "timeline/timeline_layout.h"

namespace limbwave::ui {

namespace {

constexpr std::array<double, 7> kSpeeds{0.1, 0.25, 0.5, 1.0, 1.5, 2.0, 4.0};
constexpr double kTurnStep = radians(1.0);
constexpr double kFineTurnStep = radians(0.1);

QToolButton* button(const QString& icon_name, const QString& name, const QString& keys, QWidget* parent) {
  QToolButton* made = icon_button(icon_name, name, parent);
  if (!keys.isEmpty()) {
    made->setToolTip(QStringLiteral("%1 (%2)").arg(name, keys));
  }
  made->setFocusPolicy(Qt::TabFocus);
  return made;
}

// Whether a widget needs letters and arrows for itself.
bool types_text(const QWidget* widget) {
  return qobject_cast<const QLineEdit*>(widget) != nullptr ||
         qobject_cast<const QAbstractSpinBox*>(widget) != nullptr ||
         (widget != nullptr && widget->inputMethodHints() != Qt::ImhNone) ||
         (widget != nullptr && widget->inherits("QTextEdit")) ||
         (widget != nullptr && widget->inherits("QPlainTextEdit"));
}

bool uses_arrows(const QWidget* widget) {
  return widget != nullptr &&
         (widget->inherits("QAbstractSlider") || widget->inherits("QComboBox") ||
          widget->inherits("QAbstractItemView") || widget->inherits("QTabBar") || widget->inherits("QRadioButton"));
}

}  // namespace

TimelineWidget::TimelineWidget(TimeModel& time, KeyEditor& keys, QWidget* parent)
    : QWidget(parent), time_(time), keys_(keys), canvas_(new TimelineCanvas(time, keys, this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  build_transport();
  layout->addWidget(canvas_, 1);
  connect(&time_, &TimeModel::playing_changed, this, &TimelineWidget::show_state);
  connect(&time_, &TimeModel::options_changed, this, &TimelineWidget::show_state);
  connect(&time_, &TimeModel::extent_changed, this, &TimelineWidget::show_state);
  connect(&time_, &TimeModel::playhead_changed, this, &TimelineWidget::show_state);
  connect(&keys_, &KeyEditor::selection_changed, this, &TimelineWidget::show_state);
  connect(&keys_.model(), &KeyModel::keys_changed, this, &TimelineWidget::show_state);
  qApp->installEventFilter(this);
  show_state();
}

void TimelineWidget::build_transport() {
  auto* bar = new QWidget(this);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(kGrid, kGrid / 2, kGrid, kGrid / 2);
  row->setSpacing(2);
  auto* start = button(QStringLiteral("to-start"), tr("Go to the start"), tr("Home"), bar);
  auto* back = button(QStringLiteral("step-back"), tr("One frame back"), tr("Left"), bar);
  play_ = button(QStringLiteral("play"), tr("Play"), tr("Space"), bar);
  auto* forward = button(QStringLiteral("step-forward"), tr("One frame on"), tr("Right"), bar);
  auto* end = button(QStringLiteral("to-end"), tr("Go to the end"), tr("End"), bar);
  loop_ = button(QStringLiteral("loop"), tr("Loop"), {}, bar);
  loop_->setCheckable(true);
  speed_ = new QComboBox(bar);
  speed_->setToolTip(tr("Playing speed"));
  speed_->setAccessibleName(tr("Playing speed"));
  for (const double speed : kSpeeds) {
    speed_->addItem(tr("%1×").arg(speed), speed);
  }
  speed_->setCurrentIndex(3);
  now_ = new QLabel(bar);
  now_->setFont(tabular(font(), 1.15, QFont::DemiBold));
  now_->setAccessibleName(tr("Playhead"));
  length_ = new QLabel(bar);
  length_->setFont(tabular(font()));
  length_->setProperty("role", QStringLiteral("dim"));
  add_ = button(QStringLiteral("key"), tr("Set a key for the selected bone at the playhead"), tr("I"), bar);
  remove_ = button(QStringLiteral("minus"), tr("Delete the selected keys or the selected marker"), tr("Del"), bar);
  auto* all = button(QStringLiteral("frame"), tr("Show the whole clip"), tr("Shift+Home"), bar);
  for (QWidget* widget : {start, back, play_, forward, end, loop_}) {
    row->addWidget(widget);
  }
  row->addSpacing(kGrid);
  row->addWidget(speed_);
  row->addSpacing(2 * kGrid);
  row->addWidget(now_);
  row->addSpacing(kGrid);
  row->addWidget(length_);
  row->addStretch(1);
  for (QWidget* widget : {add_, remove_, all}) {
    row->addWidget(widget);
  }
  layout()->addWidget(bar);

  connect(start, &QToolButton::clicked, this, [this] { time_.set_playhead(0.0); });
  connect(end, &QToolButton::clicked, this, [this] { time_.set_playhead(time_.duration_s()); });
  connect(back, &QToolButton::clicked, this, [this] { time_.step(-1); });
  connect(forward, &QToolButton::clicked, this, [this] { time_.step(1); });
  connect(play_, &QToolButton::clicked, this, &TimelineWidget::toggle_playing);
  connect(loop_, &QToolButton::clicked, this, [this](bool on) { time_.set_looping(on); });
  connect(all, &QToolButton::clicked, this, [this] { time_.show_all(); });
  connect(add_, &QToolButton::clicked, this, [this] { handle_key(Qt::Key_I, Qt::NoModifier); });
  connect(remove_, &QToolButton::clicked, this, [this] { handle_key(Qt::Key_Delete, Qt::NoModifier); });
  connect(speed_, &QComboBox::currentIndexChanged, this,
          [this](int) { time_.set_speed(speed_->currentData().toDouble()); });
}

void TimelineWidget::show_state() {
  const bool playing = time_.playing();
  if (play_->property("playing").toBool() != playing || play_->icon().isNull()) {
    play_->setProperty("playing", playing);
    play_->setIcon(icon(playing ? QStringLiteral("pause") : QStringLiteral("play")));
    play_->setToolTip(tr("%1 (Space)").arg(playing ? tr("Pause") : tr("Play")));
    play_->setAccessibleName(playing ? tr("Pause") : tr("Play"));
  }
  loop_->setChecked(time_.looping());
  const bool any = time_.duration_s() > 0.0;
  if (any != had_any_) {
    had_any_ = any;
    for (QToolButton* each : findChildren<QToolButton*>()) {
      each->setEnabled(any);
    }
  }
  add_->setEnabled(any && canvas_->current_lane() >= 0);
  remove_->setEnabled(!keys_.selected().empty() || canvas_->marker_time(canvas_->selected_marker()) >= 0.0);
  const qint64 frame = time_.frame();
  now_->setText(any ? time_text(time_.playhead_s(), 0.001) : tr("–"));
  const QString length =
      tr("/ %1   frame %2 of %3").arg(time_text(time_.duration_s(), 0.001)).arg(frame + 1).arg(time_.frames());
  // What stands at its start waits to be played.
  const bool waits = any && !playing && frame == 0;
  length_->setText(!any ? tr("nothing to play yet") : waits ? tr("%1   Space plays").arg(length) : length);
}

void TimelineWidget::set_current_lane(int lane) {
  canvas_->set_current_lane(lane);
  show_state();
}

void TimelineWidget::select_marker(int number) {
  canvas_->select_marker(number);
  show_state();
}

void TimelineWidget::toggle_playing() {
  if (!time_.playing()) {
    time_.set_speed(speed_->currentData().toDouble());
  }
  time_.toggle_playing();
}

void TimelineWidget::shuttle(int direction) {
  time_.set_speed(shuttle_speed(time_.speed(), time_.playing(), direction));
  time_.set_playing(true);
}

void TimelineWidget::go_to_key(int direction) {
  const double now = time_.playhead_s();
  const double slack = keys_.model().smallest_gap_s() / 2;
  double best = -1.0;
  for (const int lane : canvas_->visible_lanes()) {
    for (const LaneKey& key : keys_.model().keys(lane)) {
      const double ahead = (key.time_s - now) * direction;
      if (ahead > slack && (best < 0.0 || ahead < (best - now) * direction)) {
        best = key.time_s;
      }
    }
  }
  if (best >= 0.0) {
    time_.set_playhead(best);
  }
}

bool TimelineWidget::handle_marker_key(int key, bool alt, bool plain) {
  const int number = canvas_->selected_marker();
  const double time = canvas_->marker_time(number);
  if (time < 0.0) {
    return false;
  }
  if (alt && (key == Qt::Key_Left || key == Qt::Key_Right)) {
    const double by = key == Qt::Key_Left ? -time_.frame_s() : time_.frame_s();
    const double to = std::clamp(time + by, 0.0, time_.duration_s());
    Q_EMIT canvas_->marker_moved(number, to);
    time_.set_playhead(to);
    return true;
  }
  if (plain && (key == Qt::Key_Delete || key == Qt::Key_Backspace)) {
    Q_EMIT canvas_->marker_removed(number);
    return true;
  }
  if (plain && key == Qt::Key_F2) {
    canvas_->edit_marker(number);
    return true;
  }
  return false;
}

bool TimelineWidget::handle_key(int key, Qt::KeyboardModifiers modifiers) {
  const bool plain = modifiers == Qt::NoModifier || modifiers == Qt::KeypadModifier;
  const bool alt = (modifiers & Qt::AltModifier) != 0;
  const bool shift = (modifiers & Qt::ShiftModifier) != 0;
  if (canvas_->selected_marker() > 0 && handle_marker_key(key, alt, plain)) {
    return true;
  }
  if (alt && !keys_.selected().empty()) {
    const double turn = shift ? kFineTurnStep : kTurnStep;
    switch (key) {
      case Qt::Key_Left:
        return keys_.move(keys_.selected(), -time_.frame_s()), true;
      case Qt::Key_Right:
        return keys_.move(keys_.selected(), time_.frame_s()), true;
      case Qt::Key_Up:
        return keys_.turn(keys_.selected(), turn), true;
      case Qt::Key_Down:
        return keys_.turn(keys_.selected(), -turn), true;
      default:
        return false;
    }
  }
  if (shift && key == Qt::Key_Home) {
    return time_.show_all(), true;
  }
  if (shift && (key == Qt::Key_Left || key == Qt::Key_Right)) {
    return time_.step(key == Qt::Key_Left ? -10 : 10), true;
  }
  if (!plain) {
    return false;
  }
  switch (key) {
    case Qt::Key_Space:
      return toggle_playing(), true;
    case Qt::Key_J:
      return shuttle(-1), true;
    case Qt::Key_L:
      return shuttle(1), true;
    case Qt::Key_K:
      return time_.set_playing(false), true;
    case Qt::Key_Left:
      return time_.step(-1), true;
    case Qt::Key_Right:
      return time_.step(1), true;
    case Qt::Key_Up:
      return go_to_key(-1), true;
    case Qt::Key_Down:
      return go_to_key(1), true;
    case Qt::Key_Home:
      return time_.set_playhead(0.0), true;
    case Qt::Key_End:
      return time_.set_playhead(time_.duration_s()), true;
    case Qt::Key_I: {
      const int lane = canvas_->current_lane();
      return lane >= 0 && keys_.set_value(lane, time_.playhead_s(), keys_.model().value_at(lane, time_.playhead_s()));
    }
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
      return keys_.remove(keys_.selected());
    default:
      return false;
  }
}

bool TimelineWidget::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress || !isVisible() || !watched->isWidgetType()) {
    return false;
  }
  auto* target = static_cast<QWidget*>(watched);
  if (target->window() != window() || QApplication::activePopupWidget() != nullptr || types_text(target)) {
    return false;
  }
  const auto* press = static_cast<QKeyEvent*>(event);
  const bool arrow = press->key() >= Qt::Key_Left && press->key() <= Qt::Key_Down;
  const bool press_button = press->key() == Qt::Key_Space && target->inherits("QAbstractButton");
  if (((arrow || press->key() == Qt::Key_Home || press->key() == Qt::Key_End) && uses_arrows(target)) || press_button) {
    return false;
  }
  return handle_key(press->key(), press->modifiers());
}

}  // namespace limbwave::ui
