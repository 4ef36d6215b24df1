#include "workspaces/solve/curves_panel.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cmath>

#include "common/theme.h"
#include "workspaces/solve/quality_text.h"

namespace limbwave::ui {

namespace {

constexpr double kNames = 128;
constexpr double kValues = 132;
constexpr double kHeader = 22;
constexpr double kLeastRow = 22;
constexpr double kTrustHeight = 5;
constexpr double kHighest = 90.0;  // Degrees.

}  // namespace

QColor confidence_color(double fraction) {
  static constexpr std::array<std::array<double, 3>, 5> kStops{
      {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}}};
  const double at = std::clamp(std::isfinite(fraction) ? fraction : 0.0, 0.0, 1.0) * (kStops.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  const double part = at - static_cast<double>(i);
  const auto mix = [&](std::size_t k) {
    return static_cast<int>(std::lround(kStops[i][k] + part * (kStops[i + 1][k] - kStops[i][k])));
  };
  return {mix(0), mix(1), mix(2)};
}

CurvesPanel::CurvesPanel(TimeModel& time, QWidget* parent)
    : QWidget(parent), time_(time), bar_(new QScrollBar(Qt::Vertical, this)) {
  bar_->hide();
  bar_->setSingleStep(static_cast<int>(kLeastRow));
  connect(bar_, &QScrollBar::valueChanged, this, &CurvesPanel::redraw);
  setAccessibleName(tr("Inclination and trust of every sensor"));
  setMouseTracking(true);
  connect(&time_, &TimeModel::visible_changed, this, &CurvesPanel::redraw);
  connect(&time_, &TimeModel::extent_changed, this, &CurvesPanel::redraw);
  connect(&time_, &TimeModel::playhead_changed, this, [this] { update(); });
}

void CurvesPanel::set_curves(SensorCurves curves, std::vector<double> times) {
  curves_ = std::move(curves);
  times_ = std::move(times);
  fit_bar();
  redraw();
}

void CurvesPanel::fit_bar() {
  const int seen = std::max(1, static_cast<int>(height() - kHeader));
  const int all = static_cast<int>(std::ceil(kLeastRow * static_cast<double>(rows())));
  bar_->setRange(0, std::max(0, all - seen));
  bar_->setPageStep(seen);
  bar_->setVisible(all > seen);
  bar_->setGeometry(width() - bar_->sizeHint().width(), static_cast<int>(kHeader), bar_->sizeHint().width(), seen);
}

double CurvesPanel::room() const {
  return bar_->isHidden() ? width() : width() - bar_->width();
}

double CurvesPanel::row_height() const {
  return std::max(kLeastRow, (height() - kHeader) / static_cast<double>(std::max<std::size_t>(1, rows())));
}

void CurvesPanel::select_segment(int segment) {
  selected_ = segment;
  for (std::size_t row = 0; segment >= 0 && row < rows() && !bar_->isHidden(); ++row) {
    if ((*curves_)[row].segment == segment) {
      const QRectF area = row_rect(row);
      const double hidden_above = kHeader - area.top();
      const double hidden_below = area.bottom() - height();
      bar_->setValue(bar_->value() + static_cast<int>(std::lround(hidden_below > 0.0   ? hidden_below
                                                                  : hidden_above > 0.0 ? -hidden_above
                                                                                       : 0.0)));
      break;
    }
  }
  redraw();
}

TimeScale CurvesPanel::scale() const {
  return {time_.visible_begin_s(), time_.visible_end_s(), kNames, std::max(1.0, room() - kNames - kValues)};
}

QRectF CurvesPanel::row_rect(std::size_t row) const {
  const double scrolled = bar_->isHidden() ? 0.0 : bar_->value();
  return {0.0, kHeader + row_height() * static_cast<double>(row) - scrolled, room(), row_height()};
}

std::ptrdiff_t CurvesPanel::index_at(double time_s) const {
  if (times_.empty()) {
    return -1;
  }
  const auto after = std::lower_bound(times_.begin(), times_.end(), time_s);
  if (after == times_.begin()) {
    return 0;
  }
  if (after == times_.end() || time_s - *(after - 1) < *after - time_s) {
    return after - times_.begin() - 1;
  }
  return after - times_.begin();
}

void CurvesPanel::redraw() {
  picture_ = {};
  update();
}

void CurvesPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fit_bar();
  redraw();
}

void CurvesPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
    redraw();
  }
}

void CurvesPanel::paintEvent(QPaintEvent* /*event*/) {
  const double ratio = devicePixelRatioF();
  if (picture_.isNull() || picture_.devicePixelRatio() != ratio) {
    picture_ = QPixmap(size() * ratio);
    picture_.setDevicePixelRatio(ratio);
    QPainter painter(&picture_);
    draw(painter);
  }
  QPainter painter(this);
  painter.drawPixmap(0, 0, picture_);
  draw_values(painter);
}

void CurvesPanel::draw(QPainter& painter) const {
  const ThemeColors& theme = theme_colors(palette());
  painter.fillRect(rect(), theme.base);
  for (std::size_t row = 0; row < rows(); ++row) {
    if (const QRectF area = row_rect(row); area.bottom() > kHeader && area.top() < height()) {
      draw_row(painter, row);
    }
  }
  painter.fillRect(QRectF(0, 0, width(), kHeader), theme.panel);
  painter.setFont(tabular(font(), 0.85));
  painter.setPen(theme.dim);
  painter.drawText(QRectF(kNames, 0, width(), kHeader), Qt::AlignVCenter, tr("Elevation of the bone, −90° to 90°"));
  // The scale of trust, right beside its name.
  const QString trust = tr("Trust");
  const QRectF bar(room() - kValues - 140, kHeader / 2 - 3, 64, 6);
  const double named = painter.fontMetrics().horizontalAdvance(trust) + 4.0;
  painter.drawText(QRectF(bar.left() - 20 - named, 0, named, kHeader), Qt::AlignVCenter | Qt::AlignRight, trust);
  painter.drawText(QRectF(bar.left() - 16, 0, 12, kHeader), Qt::AlignVCenter | Qt::AlignRight, QStringLiteral("0"));
  painter.drawText(QRectF(bar.right() + 4, 0, 24, kHeader), Qt::AlignVCenter, QStringLiteral("1"));
  for (int x = 0; x < static_cast<int>(bar.width()); ++x) {
    painter.fillRect(QRectF(bar.left() + x, bar.top(), 1, bar.height()), confidence_color(x / bar.width()));
  }
  // Above the values at the playhead.
  const double values = room() - kValues + kGrid;
  painter.drawText(QRectF(values - 40, 0, 92, kHeader), Qt::AlignVCenter | Qt::AlignRight, tr("Elevation"));
  painter.drawText(QRectF(values + 60, 0, 56, kHeader), Qt::AlignVCenter | Qt::AlignRight, trust);
}

void CurvesPanel::draw_row(QPainter& painter, std::size_t row) const {
  const ThemeColors& theme = theme_colors(palette());
  const QRectF area = row_rect(row);
  const SensorCurve& content = (*curves_)[row];
  const bool selected = selected_ >= 0 && content.segment == selected_;
  if (selected) {
    QColor tint = theme.accent;
    tint.setAlphaF(0.10F);
    painter.fillRect(area, tint);
  }
  painter.setPen(QPen(theme.grid, 1));
  painter.drawLine(QPointF(0, std::round(area.top()) + 0.5), QPointF(room(), std::round(area.top()) + 0.5));
  const QRectF plot(kNames, area.top() + 3, room() - kNames - kValues, area.height() - kTrustHeight - 5);
  const double zero = std::round(plot.center().y()) + 0.5;
  painter.setPen(QPen(theme.grid, 1, Qt::DashLine));
  painter.drawLine(QPointF(plot.left(), zero), QPointF(plot.right(), zero));
  painter.setFont(tabular(font(), 0.92));
  painter.setPen(selected ? theme.text : theme.dim);
  painter.drawText(QRectF(kGrid, area.top(), kNames - 2 * kGrid, area.height()), Qt::AlignVCenter,
                   painter.fontMetrics().elidedText(content.name, Qt::ElideRight, static_cast<int>(kNames) - 16));
  painter.save();
  painter.setClipRect(QRectF(plot.left(), area.top(), plot.width(), area.height()));
  painter.setPen(QPen(series_color(theme, static_cast<int>(row)), 1));
  draw_curve(painter, content, plot);
  draw_trust(painter, content, QRectF(plot.left(), area.bottom() - kTrustHeight - 1, plot.width(), kTrustHeight));
  painter.restore();
}

void CurvesPanel::draw_curve(QPainter& painter, const SensorCurve& curve, const QRectF& area) const {
  const TimeScale s = scale();
  const auto& values = curve.elevation_deg;
  const auto count = static_cast<std::ptrdiff_t>(std::min(values.size(), times_.size()));
  if (count == 0) {
    return;
  }
  const auto y = [&](double value) { return area.center().y() - value / kHighest * area.height() / 2; };
  const auto first = std::max<std::ptrdiff_t>(0, index_at(s.begin_s) - 1);
  const auto last = std::min<std::ptrdiff_t>(count - 1, index_at(s.end_s) + 1);
  const auto x = [&](std::ptrdiff_t i) { return s.x(times_[static_cast<std::size_t>(i)]); };
  if (last - first < 4 * static_cast<std::ptrdiff_t>(s.width)) {
    painter.setRenderHint(QPainter::Antialiasing);
    QPolygonF line;
    for (std::ptrdiff_t i = first; i <= last; ++i) {
      const float value = values[static_cast<std::size_t>(i)];
      if (std::isfinite(value)) {
        line << QPointF(x(i), y(value));
      } else {
        painter.drawPolyline(line);
        line.clear();
      }
    }
    painter.drawPolyline(line);
    return;
  }
  painter.setRenderHint(QPainter::Antialiasing, false);
  std::vector<QLineF> bars;
  for (const signal::MinMaxPoint& point : curve.elevation_extremes.query(first, last + 1, static_cast<int>(s.width))) {
    const auto i = std::clamp<std::ptrdiff_t>(point.first, 0, count - 1);
    if (std::isfinite(point.minimum)) {
      bars.emplace_back(x(i), y(point.minimum), x(i), y(point.maximum) - 0.5);
    }
  }
  painter.drawLines(bars.data(), static_cast<int>(bars.size()));
}

void CurvesPanel::draw_trust(QPainter& painter, const SensorCurve& curve, const QRectF& area) const {
  const TimeScale s = scale();
  const auto count = static_cast<std::ptrdiff_t>(std::min(curve.trust.size(), times_.size()));
  if (count == 0) {
    return;
  }
  painter.setRenderHint(QPainter::Antialiasing, false);
  const auto first = std::clamp<std::ptrdiff_t>(index_at(s.begin_s) - 1, 0, count - 1);
  const auto last = std::clamp<std::ptrdiff_t>(index_at(s.end_s) + 1, 0, count - 1);
  const auto x = [&](std::ptrdiff_t i) {
    return s.x(times_[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, count - 1))]);
  };
  const auto paint = [&](std::ptrdiff_t from, std::ptrdiff_t to, double value) {
    painter.fillRect(QRectF(x(from), area.top(), std::max(1.0, x(to) - x(from) + 0.5), area.height()),
                     confidence_color(value));
  };
  if (last - first < 2 * static_cast<std::ptrdiff_t>(s.width)) {
    for (std::ptrdiff_t i = first; i <= last; ++i) {
      paint(i, i + 1, curve.trust[static_cast<std::size_t>(i)]);
    }
    return;
  }
  // The least trusted reading of a pixel shows: a short knock must not vanish.
  for (const signal::MinMaxPoint& point : curve.trust_extremes.query(first, last + 1, static_cast<int>(s.width))) {
    paint(point.first, point.first + point.count, point.minimum);
  }
}

void CurvesPanel::draw_values(QPainter& painter) const {
  if (rows() == 0 || time_.duration_s() <= 0.0) {
    return;
  }
  const ThemeColors& theme = theme_colors(palette());
  const double x = std::round(scale().x(time_.playhead_s())) + 0.5;
  if (x >= kNames - 1 && x <= room() - kValues + 1) {
    painter.setPen(QPen(theme.accent, 1));
    painter.drawLine(QPointF(x, kHeader), QPointF(x, height()));
  }
  const std::ptrdiff_t index = index_at(time_.playhead_s());
  painter.setFont(tabular(font(), 0.92));
  for (std::size_t row = 0; row < rows() && index >= 0; ++row) {
    const auto i = static_cast<std::size_t>(index);
    const SensorCurve& curve = (*curves_)[row];
    const QRectF area = row_rect(row);
    if (area.center().y() < kHeader || area.top() > height()) {
      continue;
    }
    const QRectF cell(room() - kValues + kGrid, area.top(), kValues - 2 * kGrid, area.height());
    painter.setPen(theme.text);
    if (i < curve.elevation_deg.size() && std::isfinite(curve.elevation_deg[i])) {
      painter.drawText(QRectF(cell.left(), cell.top(), 52, cell.height()), Qt::AlignVCenter | Qt::AlignRight,
                       tr("%1°").arg(signed_number(static_cast<double>(curve.elevation_deg[i]), 1)));
    }
    if (i < curve.trust.size()) {
      painter.setPen(theme.dim);
      painter.drawText(QRectF(cell.left() + 60, cell.top(), 56, cell.height()), Qt::AlignVCenter | Qt::AlignRight,
                       locale().toString(static_cast<double>(curve.trust[i]), 'f', 2));
    }
  }
}

void CurvesPanel::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) {
    return;
  }
  const QPointF at = event->position();
  if (at.y() < kHeader) {
    return;
  }
  for (std::size_t row = 0; row < rows(); ++row) {
    if (row_rect(row).contains(at) && (at.x() < kNames || at.x() > room() - kValues)) {
      Q_EMIT segment_clicked((*curves_)[row].segment);
      return;
    }
  }
  time_.set_playhead(scale().time(at.x()));
}

void CurvesPanel::mouseMoveEvent(QMouseEvent* event) {
  if ((event->buttons() & Qt::LeftButton) != 0 && event->position().x() >= kNames) {
    time_.set_playhead(scale().time(event->position().x()));
  }
}

void CurvesPanel::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0;
  const double x = event->position().x();
  if (!bar_->isHidden() && (x < kNames || x > room() - kValues)) {
    bar_->setValue(bar_->value() - static_cast<int>(std::lround(3.0 * kLeastRow * notches)));
    event->accept();
    return;
  }
  if ((event->modifiers() & Qt::ShiftModifier) != 0 || event->angleDelta().x() != 0) {
    const double by =
        -(notches + event->angleDelta().x() / 120.0) * 0.1 * (time_.visible_end_s() - time_.visible_begin_s());
    time_.set_visible(time_.visible_begin_s() + by, time_.visible_end_s() + by);
  } else {
    time_.zoom(std::pow(1.25, notches), scale().time(event->position().x()));
  }
  event->accept();
}

}  // namespace limbwave::ui
