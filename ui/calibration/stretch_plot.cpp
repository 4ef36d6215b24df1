#include "calibration/stretch_plot.h"

#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <limits>

#include "common/format.h"
#include "common/theme.h"

namespace limbwave::ui {
namespace {

constexpr double kTop = 22.0;         // named segments
constexpr double kAxis = 20.0;        // times
constexpr double kScale = 44.0;       // g at the left
constexpr double kGrab = 7.0;         // pixels beside an end that still take it
constexpr double kShortest_s = 0.05;  // visible
constexpr double kRange_g = 1.6;

}  // namespace

StretchPlot::StretchPlot(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("stretch_plot"));
  setAccessibleName(tr("Accelerations of the take"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setToolTip(tr("Drag a stretch or its ends. Wheel: zoom. Drag beside it: move. Double click: show all."));
}

double StretchPlot::duration_s() const {
  return take_ && take_->info.format.rate.hz > 0.0
             ? static_cast<double>(take_->info.frames) / take_->info.format.rate.hz
             : 0.0;
}

void StretchPlot::set_take(std::shared_ptr<const take::Take> take, std::shared_ptr<const solve::DecodedTake> decoded,
                           const QString& message) {
  const bool other = !take_ || !take || take_->folder != take->folder;
  const bool fresh = other || decoded_ != decoded;
  take_ = std::move(take);
  decoded_ = std::move(decoded);
  message_ = message;
  if (other) {
    visible_ = {0.0, duration_s()};
    Q_EMIT visible_changed(visible_);
  }
  if (fresh) {
    fill_curves();
  }
  update();
}

void StretchPlot::set_sensor(int sensor) {
  if (sensor != sensor_) {
    sensor_ = sensor;
    fill_curves();
    update();
  }
}

void StretchPlot::set_named(std::vector<NamedStretch> named) {
  named_ = std::move(named);
  update();
}

void StretchPlot::set_chosen(std::vector<Chosen> chosen) {
  chosen_ = std::move(chosen);
  update();
}

void StretchPlot::set_visible(Stretch stretch) {
  if (!std::isfinite(stretch.begin_s) || !std::isfinite(stretch.end_s)) {
    return;
  }
  const double all = duration_s();
  const double width = std::clamp(stretch.seconds(), std::min(kShortest_s, all), all);
  const double begin = std::clamp(stretch.begin_s, 0.0, all - width);
  if (const Stretch next{begin, begin + width}; !(next == visible_)) {
    visible_ = next;
    Q_EMIT visible_changed(visible_);
    update();
  }
}

/// Readings in nominal g; what is not usable becomes a gap.
void StretchPlot::fill_curves() {
  times_.clear();
  for (auto& curve : curves_) {
    curve.clear();
  }
  if (!take_ || !decoded_ || sensor_ < 0 || sensor_ >= static_cast<int>(take_->info.rig.accelerometers.size())) {
    return;
  }
  const body::LineInSignal& board = take_->info.rig.line_in;
  // Frames are relative to the reference slot.
  const double zero = board.zero_g_volts - board.reference_volts;
  const auto s = static_cast<std::size_t>(sensor_);
  for (const decode::AccelerationFrame& frame : decoded_->frames) {
    times_.push_back(frame.time_s);
    const bool usable = (frame.usable >> s & 1U) != 0;
    for (int axis = 0; axis < 3; ++axis) {
      curves_.at(static_cast<std::size_t>(axis))
          .push_back(usable ? (frame.volts.at(s)[axis] - zero) / board.volts_per_g
                            : std::numeric_limits<double>::quiet_NaN());
    }
  }
}

AxisMap StretchPlot::axis() const {
  return {visible_.begin_s, std::max(visible_.end_s, visible_.begin_s + 1e-6), kScale, static_cast<double>(width())};
}

void StretchPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const ThemeColors& theme = theme_colors(palette());
  const QRectF area(kScale, kTop, width() - kScale, height() - kTop - kAxis);
  painter.fillRect(area, theme.base);
  QFont small = font();
  small.setPixelSize(11);
  painter.setFont(tabular(small));
  if (hasFocus()) {
    painter.setPen(theme.accent);
    painter.drawRect(area.adjusted(0, 0, -1, -1));
  }
  if (!decoded_ || times_.empty()) {
    painter.setPen(theme.dim);
    painter.drawText(area.adjusted(16, 0, -16, 0), Qt::AlignCenter | Qt::TextWordWrap, message_);
    return;
  }
  paint_curves(painter, area);
  paint_chosen(painter, area);
  paint_named(painter);
  const AxisMap time = axis();
  const double step = nice_step(time.value_end - time.value_begin, std::max(1, width() / 90));
  painter.setPen(theme.dim);
  for (const double tick : ticks(time.value_begin, time.value_end, step)) {
    const double at = std::floor(time.to_pixel(tick)) + 0.5;
    painter.drawLine(QPointF(at, area.bottom()), QPointF(at, area.bottom() + 4));
    const QString text =
        step >= 1.0 ? format_clock(tick) : QLocale().toString(tick, 'f', step >= 0.1 ? 1 : 2) + tr(" s");
    painter.drawText(QPointF(at + 3, height() - 5), text);
  }
}

void StretchPlot::paint_curves(QPainter& painter, const QRectF& area) const {
  const ThemeColors& theme = theme_colors(palette());
  const AxisMap y{-kRange_g, kRange_g, area.bottom(), area.top()};
  for (const double g : {-1.0, 0.0, 1.0}) {
    const double at = std::floor(y.to_pixel(g)) + 0.5;
    painter.setPen(QPen(theme.grid, 1, g == 0.0 ? Qt::SolidLine : Qt::DotLine));
    painter.drawLine(QPointF(area.left(), at), QPointF(area.right(), at));
    painter.setPen(theme.dim);
    painter.drawText(QRectF(0, at - 8, kScale - 6, 16), Qt::AlignRight | Qt::AlignVCenter,
                     tr("%1 g").arg(g, 0, 'f', 0).replace(QLatin1Char('-'), QChar(0x2212)));
  }
  painter.save();
  painter.setClipRect(area);
  painter.setRenderHint(QPainter::Antialiasing, true);
  const auto first = std::lower_bound(times_.begin(), times_.end(), visible_.begin_s) - times_.begin();
  const auto last = std::upper_bound(times_.begin(), times_.end(), visible_.end_s) - times_.begin();
  const auto from = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, first - 1));
  const auto count = std::min(times_.size(), static_cast<std::size_t>(last) + 1) - from;
  for (std::size_t axis_index = 0; axis_index < 3; ++axis_index) {
    painter.setPen(QPen(series_color(theme, static_cast<int>(axis_index)), 1.25));
    painter.drawPolyline(decimated_line(std::span(times_).subspan(from, count),
                                        std::span(curves_.at(axis_index)).subspan(from, count), axis(), y));
  }
  painter.restore();
  const std::array<QString, 3> names{tr("x"), tr("y"), tr("z")};
  for (int i = 0; i < 3; ++i) {
    painter.setPen(series_color(theme, i));
    painter.drawText(QRectF(area.right() - 60 + 20 * i, area.top() + 2, 18, 16), Qt::AlignCenter,
                     names.at(static_cast<std::size_t>(i)));
  }
}

void StretchPlot::paint_chosen(QPainter& painter, const QRectF& area) const {
  const ThemeColors& theme = theme_colors(palette());
  const AxisMap time = axis();
  painter.save();
  painter.setClipRect(area);
  double foot = area.bottom() - 18;
  for (const Chosen& chosen : chosen_) {
    const double left = time.to_pixel(chosen.stretch.begin_s), right = time.to_pixel(chosen.stretch.end_s);
    QColor veil = theme.accent;
    veil.setAlphaF(0.16F);
    painter.fillRect(QRectF(left, area.top(), right - left, area.height()), veil);
    painter.setPen(QPen(theme.accent, 2));
    for (const double at : {left, right}) {
      painter.drawLine(QPointF(at, area.top()), QPointF(at, area.bottom()));
      painter.setBrush(theme.accent);
      painter.drawRoundedRect(QRectF(at - 3, area.center().y() - 14, 6, 28), 3, 3);
    }
    const double shown_left = std::max(left, area.left());
    const QString text = painter.fontMetrics().elidedText(chosen.title, Qt::ElideRight,
                                                          static_cast<int>(std::max(0.0, area.right() - shown_left)));
    const QRectF flag(shown_left + 4, foot, painter.fontMetrics().horizontalAdvance(text) + 8, 16);
    painter.fillRect(flag, theme.base);
    painter.setPen(theme.text);
    painter.drawText(flag, Qt::AlignCenter, text);
    foot -= 18;  // Poses are close to each other: their names must not cover each other.
  }
  painter.restore();
}

void StretchPlot::paint_named(QPainter& painter) const {
  const ThemeColors& theme = theme_colors(palette());
  const AxisMap time = axis();
  painter.save();
  painter.setClipRect(QRectF(kScale, 0, width() - kScale, kTop));
  for (const NamedStretch& named : named_) {
    const QRectF bar(time.to_pixel(named.stretch.begin_s), 1,
                     std::max(2.0, time.to_pixel(named.stretch.end_s) - time.to_pixel(named.stretch.begin_s) - 1),
                     kTop - 4);
    painter.setPen(theme.line);
    painter.setBrush(theme.raised);
    painter.drawRoundedRect(bar, 3, 3);
    painter.setPen(theme.text);
    const QRectF words = bar.adjusted(4, 0, -4, 0).intersected(QRectF(kScale + 4, 0, width() - kScale, kTop));
    painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(named.title, Qt::ElideRight, static_cast<int>(words.width())));
  }
  painter.restore();
}

StretchPlot::Grip StretchPlot::grip_at(const QPointF& position) const {
  const AxisMap time = axis();
  Grip best;
  double least = kGrab;
  for (std::size_t i = 0; i < chosen_.size(); ++i) {
    const auto& [begin_s, end_s] = chosen_[i].stretch;
    for (const auto& [at, part] : {std::pair{begin_s, Part::kBegin}, std::pair{end_s, Part::kEnd}}) {
      const double distance = std::abs(position.x() - time.to_pixel(at));
      if (distance < least) {
        least = distance;
        best = {part, static_cast<int>(i)};
      }
    }
  }
  // Inside, unless it fills the view: then there must be a way to move the
  // view.
  for (std::size_t i = 0; i < chosen_.size() && best.part == Part::kNone; ++i) {
    const Stretch& stretch = chosen_[i].stretch;
    const double at = time.to_value(position.x());
    const bool fills = stretch.begin_s <= visible_.begin_s && stretch.end_s >= visible_.end_s;
    if (!fills && at > stretch.begin_s && at < stretch.end_s) {
      best = {Part::kWhole, static_cast<int>(i)};
    }
  }
  return best.part == Part::kNone ? Grip{Part::kPan, -1} : best;
}

int StretchPlot::named_at(const QPointF& position) const {
  const double at = axis().to_value(position.x());
  for (std::size_t i = 0; i < named_.size() && position.y() < kTop && position.x() >= kScale; ++i) {
    if (at >= named_[i].stretch.begin_s && at < named_[i].stretch.end_s) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

void StretchPlot::mousePressEvent(QMouseEvent* event) {
  grip_ = {};
  if (event->button() != Qt::LeftButton || !decoded_) {
    return;
  }
  if (const int named = named_at(event->position()); named >= 0) {
    Q_EMIT named_clicked(named);
    return;
  }
  grip_ = grip_at(event->position());
  grip_s_ = axis().to_value(event->position().x());
  Q_EMIT drag_begun();
}

void StretchPlot::mouseMoveEvent(QMouseEvent* event) {
  if ((event->buttons() & Qt::LeftButton) == 0 || grip_.part == Part::kNone) {
    const Part part = decoded_ ? grip_at(event->position()).part : Part::kNone;
    setCursor(named_at(event->position()) >= 0             ? Qt::PointingHandCursor
              : part == Part::kBegin || part == Part::kEnd ? Qt::SizeHorCursor
              : part == Part::kWhole                       ? Qt::SizeAllCursor
                                                           : Qt::ArrowCursor);
    return;
  }
  const double at = axis().to_value(event->position().x());
  const double by = at - grip_s_;
  if (grip_.part == Part::kPan) {
    set_visible({visible_.begin_s - by, visible_.end_s - by});
    return;  // The time under the button stays the same.
  }
  Stretch stretch = chosen_.at(static_cast<std::size_t>(grip_.i)).stretch;
  if (grip_.part == Part::kWhole) {
    const double shift = std::clamp(by, -stretch.begin_s, duration_s() - stretch.end_s);
    stretch = {stretch.begin_s + shift, stretch.end_s + shift};
    grip_s_ += shift;
  } else {
    (grip_.part == Part::kBegin ? stretch.begin_s : stretch.end_s) = at;
  }
  Q_EMIT stretch_dragged(grip_.i, stretch);
}

void StretchPlot::mouseReleaseEvent(QMouseEvent*) {
  grip_ = {};
}

void StretchPlot::mouseDoubleClickEvent(QMouseEvent* event) {
  if (named_at(event->position()) < 0) {
    set_visible({0.0, duration_s()});
  }
}

void StretchPlot::wheelEvent(QWheelEvent* event) {
  const double about = axis().to_value(event->position().x());
  const double factor = std::pow(1.25, -event->angleDelta().y() / 120.0);
  set_visible({about - (about - visible_.begin_s) * factor, about + (visible_.end_s - about) * factor});
  event->accept();
}

void StretchPlot::keyPressEvent(QKeyEvent* event) {
  const double width_s = visible_.seconds();
  switch (event->key()) {
    case Qt::Key_Left:
      set_visible({visible_.begin_s - 0.1 * width_s, visible_.end_s - 0.1 * width_s});
      break;
    case Qt::Key_Right:
      set_visible({visible_.begin_s + 0.1 * width_s, visible_.end_s + 0.1 * width_s});
      break;
    case Qt::Key_Plus:
      set_visible({visible_.begin_s + 0.1 * width_s, visible_.end_s - 0.1 * width_s});
      break;
    case Qt::Key_Minus:
      set_visible({visible_.begin_s - 0.125 * width_s, visible_.end_s + 0.125 * width_s});
      break;
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace limbwave::ui
