#include "plots/sensor_strips.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <QTextLayout>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "common/health_text.h"
#include "common/icons.h"
#include "common/theme.h"
#include "common/widgets.h"
#include "plots/plot_geometry.h"

namespace limbwave::ui {
namespace {

constexpr double kHistory = 10.0;  // seconds shown
constexpr double kHeader = 20, kFooter = 18, kGap = 6, kCard = 216;

Tone tone_of(solve::HealthState state) {
  switch (state) {
    case solve::HealthState::kGood:
      return Tone::kGood;
    case solve::HealthState::kWarning:
      return Tone::kWarning;
    case solve::HealthState::kBad:
      return Tone::kDanger;
    case solve::HealthState::kUnknown:
      break;
  }
  return Tone::kUnknown;
}

QString signed_number(double value, int digits) {
  QString text = QLocale().toString(std::abs(value), 'f', digits);
  const bool negative = value < 0.0 && text != QLocale().toString(0.0, 'f', digits);
  return (negative ? QStringLiteral("\u2212") : QStringLiteral("\u2007")) + text;
}

// As many whole lines as there is room for, at least one; what does not fit ends in an ellipsis.
void draw_words(QPainter& painter, const QRectF& area, const QString& words) {
  QTextLayout layout(words, painter.font());
  const double line_height = painter.fontMetrics().height();
  const int room = std::max(1, static_cast<int>(area.height() / line_height));
  layout.beginLayout();
  for (int i = 0; i < room; ++i) {
    QTextLine line = layout.createLine();
    if (!line.isValid()) {
      break;
    }
    line.setLineWidth(area.width());
    const bool last = i + 1 == room;
    const QString text = last ? words.mid(line.textStart()) : words.mid(line.textStart(), line.textLength());
    painter.drawText(QPointF(area.left(), area.top() + i * line_height + painter.fontMetrics().ascent()),
                     painter.fontMetrics().elidedText(text, Qt::ElideRight, static_cast<int>(area.width())));
  }
  layout.endLayout();
}

}  // namespace

SensorStrips::SensorStrips(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("sensor_strips"));
  setAccessibleName(tr("Accelerations and health of every sensor"));
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

QSize SensorStrips::minimumSizeHint() const {
  return {600,
          static_cast<int>(kHeader + kFooter + 48.0 * static_cast<double>(std::max<qsizetype>(1, sensors_.size())))};
}

void SensorStrips::set_sensors(const QStringList& names) {
  sensors_ = names;
  ranges_.assign(static_cast<std::size_t>(names.size()), 20.0);
  updateGeometry();
  update();
}

void SensorStrips::set_selected_sensor(int sensor) {
  if (sensor != selected_) {
    selected_ = sensor;
    update();
  }
}

void SensorStrips::set_snapshot(std::shared_ptr<const solve::LiveSnapshot> snapshot) {
  snapshot_ = std::move(snapshot);
  update_ranges();
  update();
}

void SensorStrips::set_marks(std::vector<Mark> marks) {
  marks_ = std::move(marks);
  update();
}

void SensorStrips::paint_marks(QPainter& painter) const {
  if (!snapshot_) {
    return;
  }
  const ThemeColors& theme = theme_colors(palette());
  painter.setPen(theme.accent);
  for (int axis = 0; axis < 3; ++axis) {
    const QRectF top = strip(0, axis);
    const double bottom = row(static_cast<int>(sensors_.size()) - 1).bottom();
    const AxisMap x{snapshot_->stream_time_s - kHistory, snapshot_->stream_time_s, top.left(), top.right()};
    for (const Mark& mark : marks_) {
      const double at = std::floor(x.to_pixel(mark.stream_time_s)) + 0.5;
      if (at < top.left() || at > top.right()) {
        continue;
      }
      painter.drawLine(QPointF(at, top.top()), QPointF(at, bottom));
      const double room = top.right() - at - 6.0;
      if (axis == 0 && room > 24.0) {
        const QString text =
            painter.fontMetrics().elidedText(mark.text, Qt::ElideRight, static_cast<int>(std::min(room, 140.0)));
        const QRectF flag(at + 1, top.bottom() - 15, painter.fontMetrics().horizontalAdvance(text) + 6, 15);
        painter.fillRect(flag, theme.base);
        painter.drawText(flag, Qt::AlignCenter, text);
      }
    }
  }
}

void SensorStrips::update_ranges() {
  if (!snapshot_) {
    return;
  }
  for (std::size_t sensor = 0; sensor < ranges_.size() && sensor < snapshot_->specific_force.size(); ++sensor) {
    double largest = 0.0;
    for (const Eigen::Vector3d& f : snapshot_->specific_force[sensor]) {
      largest = f.allFinite() ? std::max(largest, f.cwiseAbs().maxCoeff()) : largest;
    }
    ranges_[sensor] = strip_range(largest, ranges_[sensor]);
  }
}

QRectF SensorStrips::row(int sensor) const {
  const double count = std::max(1.0, static_cast<double>(sensors_.size()));
  const double each = (height() - kHeader - kFooter) / count;
  return {0.0, kHeader + sensor * each, static_cast<double>(width()), each - kGap};
}

QRectF SensorStrips::strip(int sensor, int axis) const {
  const QRectF area = row(sensor);
  const double inner = area.width() - kCard - kGap;
  const double each = inner / 3.0;
  return {std::floor(kCard + kGap + axis * each), area.top(), std::floor(each - kGap), area.height()};
}

void SensorStrips::paint_card(QPainter& painter, int sensor) const {
  const ThemeColors& theme = theme_colors(palette());
  const QRectF area(0, row(sensor).top(), kCard, row(sensor).height());
  const auto at = static_cast<std::size_t>(sensor);
  solve::SensorHealth health;
  if (snapshot_ && at < snapshot_->health.size()) {
    health = snapshot_->health[at];
  }
  const Tone tone = tone_of(health.state);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme.panel);
  painter.drawRoundedRect(area, 4, 4);
  painter.fillRect(QRectF(area.left(), area.top(), 4, area.height()), series_color(theme, sensor));
  if (sensor == selected_) {
    painter.setPen(QPen(theme.accent, hasFocus() ? 2 : 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(area.adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
  }
  QFont bold = font();
  bold.setWeight(QFont::DemiBold);
  painter.setFont(bold);
  painter.setPen(theme.text);
  QFont small = font();
  small.setPixelSize(12);
  const double line = painter.fontMetrics().height(), small_line = QFontMetricsF(small, this).height();
  // In a low row the words stand beside the name.
  const bool low = area.height() < line + small_line;
  const double pad = std::clamp((area.height() - line - (low ? 0.0 : small_line)) / 2.0, 0.0, 5.0);
  const QRectF title(area.left() + 14, area.top() + pad, area.width() - 14 - 30, line);
  const QString name =
      painter.fontMetrics().elidedText(QStringLiteral("%1  %2").arg(sensor + 1).arg(sensors_.value(sensor)),
                                       Qt::ElideRight, static_cast<int>(low ? 0.6 * title.width() : title.width()));
  const double name_width = painter.fontMetrics().horizontalAdvance(name);
  painter.drawText(title, Qt::AlignLeft | Qt::AlignVCenter, name);
  painter.drawPixmap(QPointF(area.right() - 26, area.top() + 5),
                     icon_pixmap(tone_icon(tone), tone_color(palette(), tone), 16, devicePixelRatioF()));
  painter.setFont(small);
  painter.setPen(tone == Tone::kWarning || tone == Tone::kDanger ? tone_color(palette(), tone) : theme.dim);
  const QString words = health_text(health);
  const double beside = title.left() + name_width + 10.0;
  draw_words(painter,
             low ? QRectF(beside, title.top() + (line - small_line) / 2.0, title.right() - beside, small_line)
                 : QRectF(title.left(), title.bottom(), area.width() - 22, area.bottom() - title.bottom()),
             words);
}

void SensorStrips::paint_strip(QPainter& painter, int sensor, int axis) const {
  const ThemeColors& theme = theme_colors(palette());
  const QRectF area = strip(sensor, axis);
  const auto at = static_cast<std::size_t>(sensor);
  const double range = ranges_[at];
  painter.fillRect(area, theme.base);
  const AxisMap y{-range, range, area.bottom(), area.top()};
  painter.setPen(theme.grid);
  for (const double level : {-9.80665, 0.0, 9.80665}) {
    const double pixel = std::floor(y.to_pixel(level)) + 0.5;
    painter.setPen(QPen(theme.grid, 1, level == 0.0 ? Qt::SolidLine : Qt::DotLine));
    painter.drawLine(QPointF(area.left(), pixel), QPointF(area.right(), pixel));
  }
  if (!snapshot_ || at >= snapshot_->specific_force.size() || snapshot_->frames.empty()) {
    return;
  }
  const auto& force = snapshot_->specific_force[at];
  const std::size_t count = std::min(force.size(), snapshot_->frames.size());
  if (count == 0) {
    return;
  }
  const double now = snapshot_->stream_time_s;
  const AxisMap x{now - kHistory, now, area.left(), area.right()};
  std::vector<double> times(count), values(count);
  for (std::size_t i = 0; i < count; ++i) {
    times[i] = snapshot_->frames[i].time_s;
    const bool usable = (snapshot_->frames[i].usable >> at & 1U) != 0;
    values[i] = usable ? force[i][axis] : std::numeric_limits<double>::quiet_NaN();
  }
  painter.save();
  painter.setClipRect(area);
  painter.setRenderHint(QPainter::Antialiasing, true);
  painter.setPen(QPen(series_color(theme, sensor), 1.25));
  painter.drawPolyline(decimated_line(times, values, x, y));
  painter.restore();
  const double last = values.back();
  QFont figures = tabular(font(), 1.0, QFont::DemiBold);
  painter.setFont(figures);
  const QString text = std::isfinite(last) ? signed_number(last, 1) : QStringLiteral("–");
  const double width = painter.fontMetrics().horizontalAdvance(text) + 10;
  const QRectF box(area.right() - width, area.top(), width, painter.fontMetrics().height() + 2);
  QColor veil = theme.base;
  veil.setAlphaF(0.75F);
  painter.fillRect(box, veil);
  painter.setPen(std::isfinite(last) ? theme.text : theme.dim);
  painter.drawText(box, Qt::AlignCenter, text);
}

void SensorStrips::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing, false);
  const ThemeColors& theme = theme_colors(palette());
  QFont small = font();
  small.setPixelSize(11);
  for (int sensor = 0; sensor < static_cast<int>(sensors_.size()); ++sensor) {
    painter.setRenderHint(QPainter::Antialiasing, true);
    paint_card(painter, sensor);
    painter.setRenderHint(QPainter::Antialiasing, false);
    for (int axis = 0; axis < 3; ++axis) {
      paint_strip(painter, sensor, axis);
    }
    painter.setFont(small);
    painter.setPen(theme.dim);
    const QRectF first = strip(sensor, 0);
    painter.drawText(first.adjusted(4, 1, 0, 0), Qt::AlignLeft | Qt::AlignTop,
                     QStringLiteral("±%1").arg(ranges_[static_cast<std::size_t>(sensor)]));
  }
  if (sensors_.isEmpty()) {
    return;
  }
  painter.setFont(small);
  paint_marks(painter);
  painter.setPen(theme.dim);
  const std::array<QString, 3> names{tr("x axis, m/s²"), tr("y axis, m/s²"), tr("z axis, m/s²")};
  for (int axis = 0; axis < 3; ++axis) {
    const QRectF top = strip(0, axis);
    painter.drawText(QRectF(top.left(), 0, top.width(), kHeader - 2), Qt::AlignLeft | Qt::AlignVCenter,
                     names.at(static_cast<std::size_t>(axis)));
    const QRectF foot(top.left(), height() - kFooter, top.width(), kFooter);
    painter.drawText(foot, Qt::AlignLeft | Qt::AlignVCenter, tr("−10 s"));
    painter.drawText(foot, Qt::AlignRight | Qt::AlignVCenter, tr("now"));
  }
}

void SensorStrips::mousePressEvent(QMouseEvent* event) {
  for (int sensor = 0; sensor < static_cast<int>(sensors_.size()); ++sensor) {
    if (row(sensor).contains(event->position())) {
      Q_EMIT sensor_clicked(sensor);
      return;
    }
  }
  Q_EMIT sensor_clicked(-1);
}

void SensorStrips::keyPressEvent(QKeyEvent* event) {
  const int last = static_cast<int>(sensors_.size()) - 1;
  if (event->key() == Qt::Key_Down && last >= 0) {
    Q_EMIT sensor_clicked(std::min(last, selected_ + 1));
  } else if (event->key() == Qt::Key_Up && last >= 0) {
    Q_EMIT sensor_clicked(std::max(0, selected_ - 1));
  } else {
    QWidget::keyPressEvent(event);
  }
}

bool SensorStrips::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    for (int sensor = 0; sensor < static_cast<int>(sensors_.size()); ++sensor) {
      const auto at = static_cast<std::size_t>(sensor);
      if (row(sensor).contains(help->pos()) && snapshot_ && at < snapshot_->health.size()) {
        QToolTip::showText(help->globalPos(),
                           QStringLiteral("%1: %2").arg(sensors_.value(sensor), health_text(snapshot_->health[at])),
                           this);
        return true;
      }
    }
    QToolTip::hideText();
    return true;
  }
  return QWidget::event(event);
}

}  // namespace limbwave::ui
