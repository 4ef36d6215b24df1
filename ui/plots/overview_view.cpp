#include "plots/overview_view.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "common/format.h"
#include "common/theme.h"

namespace limbwave::ui {
namespace {
constexpr double kAxis = 18;
constexpr double kShortest_s = 0.02;  // about one cycle of the multiplexer
constexpr double kGrab = 6.0;         // pixels beside a marker's line that still take it
constexpr double kFlag = 16.0;        // height of the markers' names
constexpr double kStep_s = 0.01, kLongStep_s = 0.1;
constexpr double kWire = 7.0;   // height of a wire's row
constexpr double kMany = 30.0;  // ranges a second of a wire that sees its sources well
}  // namespace

OverviewView::OverviewView(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("overview"));
  setAccessibleName(tr("Recorded signal"));
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setMouseTracking(true);
}

QSize OverviewView::sizeHint() const {
  return {600,
          has_wires() ? static_cast<int>(kFlag + kWire * static_cast<double>(overview_->box.wires()) + kAxis) : 96};
}

QSize OverviewView::minimumSizeHint() const {
  return {300, has_wires() ? sizeHint().height() : 80};
}

void OverviewView::set_selected_wire(int wire) {
  if (wire != std::exchange(selected_wire_, wire)) {
    update();
  }
}

QRectF OverviewView::wire_row(std::size_t wire) const {
  return {0, kFlag + kWire * static_cast<double>(wire), static_cast<double>(width()), kWire};
}

int OverviewView::wire_at(double y) const {
  const int wire = static_cast<int>(std::floor((y - kFlag) / kWire));
  return has_wires() && wire >= 0 && wire < static_cast<int>(overview_->box.wires()) ? wire : -1;
}

void OverviewView::set_overview(std::shared_ptr<const TakeOverview> overview) {
  overview_ = std::move(overview);
  updateGeometry();
  begin_s_ = 0.0;
  end_s_ = overview_ ? overview_->seconds() : 0.0;
  all_ = true;
  update();
}

void OverviewView::grown() {
  if (has_wires() && height() != sizeHint().height()) {
    updateGeometry();  // The first that is known of the wires.
  }
  if (all_ && overview_) {
    begin_s_ = 0.0;
    end_s_ = overview_->seconds();
  }
  update();
}

void OverviewView::set_marks(std::vector<OverviewMark> marks) {
  marks_ = std::move(marks);
  update();
}

void OverviewView::set_visible(double begin_s, double end_s) {
  if (!overview_ || !std::isfinite(begin_s) || !std::isfinite(end_s)) {
    return;
  }
  const double all = overview_->seconds();
  const double width = std::clamp(end_s - begin_s, std::min(kShortest_s, all), all);
  const double begin = std::clamp(begin_s, 0.0, all - width);
  all_ = width >= all;
  if (begin != begin_s_ || begin + width != end_s_) {
    begin_s_ = begin;
    end_s_ = begin + width;
    Q_EMIT visible_changed(begin_s_, end_s_);
    update();
  }
}

AxisMap OverviewView::time_axis() const {
  return {begin_s_, std::max(end_s_, begin_s_ + 1e-6), 0.0, static_cast<double>(width())};
}

void OverviewView::set_selected_mark(std::int64_t number) {
  if (number != selected_) {
    selected_ = number;
    update();
  }
}

double OverviewView::shown_time(const OverviewMark& mark) const {
  return drag_moved_ && mark.number != 0 && mark.number == dragged_ ? dragged_to_s_ : mark.time_s;
}

double OverviewView::mark_x(std::int64_t number) const {
  for (const OverviewMark& mark : marks_) {
    if (mark.number == number) {
      return time_axis().to_pixel(shown_time(mark));
    }
  }
  return -1.0;
}

const OverviewMark* OverviewView::selected_mark() const {
  const auto found = std::find_if(marks_.begin(), marks_.end(), [this](const OverviewMark& mark) {
    return selected_ != 0 && mark.number == selected_;
  });
  return found == marks_.end() ? nullptr : &*found;
}

const OverviewMark* OverviewView::mark_at(const QPointF& position) const {
  const AxisMap time = time_axis();
  const OverviewMark* best = nullptr;
  double least = kGrab;
  const QFontMetrics metrics(font());
  for (const OverviewMark& mark : marks_) {
    const double right = position.x() - time.to_pixel(mark.time_s);
    // Its line anywhere, its name in the band of names.
    const bool on_name =
        position.y() < kFlag && right > 0.0 && right < std::min(140, metrics.horizontalAdvance(mark.text));
    const double distance = on_name ? kGrab - 0.5 : std::abs(right);
    if (mark.number != 0 && distance < least) {
      least = distance;
      best = &mark;
    }
  }
  return best;
}

void OverviewView::paint_marks(QPainter& painter, const QRectF& band) const {
  const ThemeColors& theme = theme_colors(palette());
  const AxisMap time = time_axis();
  painter.setBrush(Qt::NoBrush);
  for (const OverviewMark& mark : marks_) {
    const double at = std::floor(time.to_pixel(shown_time(mark))) + 0.5;
    if (at < -140.0 || at > width()) {
      continue;
    }
    const bool selected = mark.number != 0 && mark.number == selected_;
    const QColor color = mark.problem ? theme.warning : theme.accent;
    painter.setPen(QPen(color, selected ? 3 : 1));
    painter.drawLine(QPointF(at, 0), QPointF(at, band.bottom()));
    const QString text = painter.fontMetrics().elidedText(mark.text, Qt::ElideRight, 140);
    const QRectF flag(at + 1, 0, painter.fontMetrics().horizontalAdvance(text) + 6, kFlag);
    // A ground of its own, so that the words can be read on the signal.
    painter.fillRect(flag, selected ? color : theme.base);
    painter.setPen(selected ? theme.accent_text : color);
    painter.drawText(flag.adjusted(3, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, text);
  }
}

void OverviewView::paint_signal(QPainter& painter, const QRectF& band) const {
  const ThemeColors& theme = theme_colors(palette());
  const AxisMap time = time_axis();
  const double rate = overview_->rate_hz;
  const AxisMap x{time.value_begin * rate, time.value_end * rate, time.pixel_begin, time.pixel_end};
  const auto first = static_cast<std::int64_t>(std::floor(x.value_begin));
  const auto last = static_cast<std::int64_t>(std::ceil(x.value_end)) + 1;
  const std::array<const signal::MinMaxPyramid*, 2> channels{&overview_->left, &overview_->right};
  for (std::size_t c = 0; c < 2; ++c) {
    const double share = c == 0 ? 0.64 : 0.36;
    const QRectF area(0, c == 0 ? 0.0 : band.height() * 0.64, width(), band.height() * share);
    const AxisMap y{-1.0, 1.0, area.bottom() - 1, area.top() + 1};
    const QColor color = c == 0 ? series_color(theme, 1) : theme.dim;
    painter.setPen(QPen(color, 1));
    painter.setBrush(color);
    painter.drawPolygon(min_max_outline(channels.at(c)->query(first, last, width()), x, y));
  }
}

// Colour, height and place tell the same: well is a low bar, as bright as sources are in sight; what is wrong is high.
void OverviewView::paint_wires(QPainter& painter) const {
  const ThemeColors& theme = theme_colors(palette());
  const AxisMap time = time_axis();
  const BoxHistory& box = overview_->box;
  const auto columns = static_cast<double>(box.columns());
  const double first = std::clamp(std::floor(time.value_begin / box.column_s()), 0.0, columns);
  const double last = std::clamp(std::ceil(time.value_end / box.column_s()), 0.0, columns);
  for (std::size_t w = 0; w < box.wires(); ++w) {
    const QRectF row = wire_row(w);
    if (static_cast<int>(w) == selected_wire_) {
      painter.fillRect(row, theme.raised);
    }
    for (auto c = static_cast<std::size_t>(first); c < static_cast<std::size_t>(last); ++c) {
      const double begin = time.to_pixel(static_cast<double>(c) * box.column_s());
      const double end = time.to_pixel(static_cast<double>(c + 1) * box.column_s());
      const WireCell& cell = box.cell(w, c);
      const auto bar = [&](double top, double height, const QColor& color) {
        painter.fillRect(QRectF(begin, row.top() + top, std::max(1.0, end - begin), height), color);
      };
      switch (cell.condition) {
        case WireCondition::kWell:
        case WireCondition::kUnseen: {
          QColor color = theme.good;
          const double share = cell.ranges_hz < 0.0F ? 0.6 : std::min(1.0, static_cast<double>(cell.ranges_hz) / kMany);
          color.setAlphaF(static_cast<float>(0.25 + 0.75 * share));
          bar(2.0, 3.0, cell.condition == WireCondition::kWell ? color : theme.line);
          break;
        }
        case WireCondition::kSilent:
          bar(1.0, kWire - 2.0, theme.warning);
          break;
        case WireCondition::kPulled:
          bar(3.0, 1.0, theme.warning);  // nothing but a line
          break;
        case WireCondition::kClips:
        case WireCondition::kLost:
          bar(0.0, kWire, theme.danger);
          break;
        case WireCondition::kUnknown:
          break;
      }
    }
  }
}

void OverviewView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const ThemeColors& theme = theme_colors(palette());
  const QRectF band(0, 0, width(), height() - kAxis);
  painter.fillRect(band, theme.base);
  QFont small = font();
  small.setPixelSize(11);
  painter.setFont(tabular(small));
  if (hasFocus()) {
    painter.setPen(theme.accent);
    painter.drawRect(band.adjusted(0, 0, -1, -1));
  }
  if (!overview_ || overview_->frames == 0) {
    painter.setPen(theme.dim);
    painter.drawText(band, Qt::AlignCenter, overview_ ? tr("The take is empty.") : tr("Reading the signal…"));
    return;
  }
  const AxisMap time = time_axis();
  has_wires() ? paint_wires(painter) : paint_signal(painter, band);
  paint_marks(painter, band);
  const double step = nice_step(time.value_end - time.value_begin, std::max(1, width() / 90));
  painter.setPen(theme.dim);
  for (const double tick : ticks(time.value_begin, time.value_end, step)) {
    const double at = std::floor(time.to_pixel(tick)) + 0.5;
    painter.drawLine(QPointF(at, band.bottom()), QPointF(at, band.bottom() + 4));
    const QString text =
        step >= 1.0 ? format_clock(tick) : QLocale().toString(tick, 'f', step >= 0.1 ? 1 : 3) + tr(" s");
    if (at + 3 + painter.fontMetrics().horizontalAdvance(text) <= width()) {  // No half of a number at the edge.
      painter.drawText(QPointF(at + 3, height() - 5), text);
    }
  }
}

void OverviewView::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0;
  const AxisMap time = time_axis();
  const double about = time.to_value(event->position().x());
  const double factor = std::pow(1.25, -notches);
  set_visible(about - (about - begin_s_) * factor, about - (about - begin_s_) * factor + (end_s_ - begin_s_) * factor);
  event->accept();
}

void OverviewView::mousePressEvent(QMouseEvent* event) {
  drag_x_ = event->position().x();
  drag_moved_ = false;
  const OverviewMark* mark = event->button() == Qt::LeftButton ? mark_at(event->position()) : nullptr;
  dragged_ = mark != nullptr ? mark->number : 0;
  if (dragged_ != 0) {
    dragged_to_s_ = mark->time_s;
    Q_EMIT mark_selected(dragged_);
  } else if (const int wire = wire_at(event->position().y()); wire >= 0 && event->button() == Qt::LeftButton) {
    Q_EMIT wire_clicked(wire);
  }
}

void OverviewView::mouseMoveEvent(QMouseEvent* event) {
  const AxisMap time = time_axis();
  const double x = event->position().x();
  if ((event->buttons() & Qt::LeftButton) == 0) {
    setCursor(mark_at(event->position()) != nullptr ? Qt::SizeHorCursor : Qt::ArrowCursor);
    return;
  }
  if (dragged_ != 0) {
    drag_moved_ = drag_moved_ || std::abs(x - drag_x_) > 2.0;
    dragged_to_s_ = std::clamp(time.to_value(x), 0.0, overview_ ? overview_->seconds() : 0.0);
    update();
    return;
  }
  const double shift = time.to_value(drag_x_) - time.to_value(x);
  drag_x_ = x;
  set_visible(begin_s_ + shift, end_s_ + shift);
}

void OverviewView::mouseReleaseEvent(QMouseEvent*) {
  const bool moved = dragged_ != 0 && drag_moved_;
  const std::int64_t number = std::exchange(dragged_, 0);
  drag_moved_ = false;
  if (moved) {
    Q_EMIT mark_moved(number, dragged_to_s_);
  }
  update();
}

void OverviewView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (!overview_) {
    return;
  }
  if (const OverviewMark* mark = mark_at(event->position())) {
    Q_EMIT mark_activated(mark->number);
  } else if (event->position().y() < kFlag) {
    Q_EMIT mark_wanted(time_axis().to_value(event->position().x()));
  } else {
    set_visible(0.0, overview_->seconds());
  }
}

bool OverviewView::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const OverviewMark* mark = mark_at(help->pos());
    const int wire = mark == nullptr ? wire_at(help->pos().y()) : -1;
    const QString words =
        wire >= 0 ? overview_->box.words(static_cast<std::size_t>(wire), time_axis().to_value(help->pos().x()))
                  : QString();
    if (!words.isEmpty()) {
      QToolTip::showText(help->globalPos(), words, this);
      return true;
    }
    QToolTip::showText(
        help->globalPos(),
        mark != nullptr ? tr("%1 at %2. Drag: move. Double click: rename. Delete: delete.")
                              .arg(mark->text, format_clock_hundredths(mark->time_s))
                        : tr("Wheel: zoom. Drag: move. Double click: show all; at the upper edge: set a marker there."),
        this);
    return true;
  }
  return QWidget::event(event);
}

/// Keys for the selected marker; false: it is none of them.
bool OverviewView::mark_key(QKeyEvent* event) {
  const OverviewMark* mark = selected_mark();
  if (mark == nullptr) {
    return false;
  }
  const bool shift = (event->modifiers() & Qt::ShiftModifier) != 0;
  const double step = (event->modifiers() & Qt::ControlModifier) != 0 ? kLongStep_s : kStep_s;
  switch (event->key()) {
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
      Q_EMIT mark_removed(mark->number);
      return true;
    case Qt::Key_F2:
    case Qt::Key_Return:
    case Qt::Key_Enter:
      Q_EMIT mark_activated(mark->number);
      return true;
    case Qt::Key_Left:
    case Qt::Key_Right:
      if (shift) {
        Q_EMIT mark_moved(mark->number, mark->time_s + (event->key() == Qt::Key_Left ? -step : step));
      }
      return shift;
    default:
      return false;
  }
}

void OverviewView::keyPressEvent(QKeyEvent* event) {
  if (mark_key(event)) {
    return;
  }
  const double width_s = end_s_ - begin_s_;
  switch (event->key()) {
    case Qt::Key_Left:
      set_visible(begin_s_ - 0.1 * width_s, end_s_ - 0.1 * width_s);
      break;
    case Qt::Key_Right:
      set_visible(begin_s_ + 0.1 * width_s, end_s_ + 0.1 * width_s);
      break;
    case Qt::Key_Plus:
      set_visible(begin_s_ + 0.1 * width_s, end_s_ - 0.1 * width_s);
      break;
    case Qt::Key_Minus:
      set_visible(begin_s_ - 0.125 * width_s, end_s_ + 0.125 * width_s);
      break;
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace limbwave::ui
