#include "plots/scope_view.h"

#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "common/format.h"
#include "common/theme.h"

namespace limbwave::ui {
namespace {

constexpr double kTitle = 18, kSlots = 20, kGap = 6;

}  // namespace

struct ScopeView::Bands {
  QRectF sensor_row, slot_row, data, clock;
};

ScopeView::ScopeView(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("scope"));
  setAccessibleName(tr("Scope of both channels"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void ScopeView::set_sensors(const QStringList& names, int slot_count) {
  sensors_ = names;
  slot_count_ = std::max(2, slot_count);
  update();
}

void ScopeView::set_selected_sensor(int sensor) {
  if (sensor != selected_) {
    selected_ = sensor;
    update();
  }
}

double ScopeView::peak(int channel) const {
  double largest = 0.0;
  for (std::size_t i = static_cast<std::size_t>(channel); i < snapshot_->scope.size(); i += 2) {
    largest = std::max(largest, static_cast<double>(std::abs(snapshot_->scope[i])));
  }
  return largest;
}

void ScopeView::set_snapshot(std::shared_ptr<const solve::LiveSnapshot> snapshot) {
  const bool first = snapshot_ == nullptr;
  snapshot_ = std::move(snapshot);
  for (int channel = 0; channel < 2 && snapshot_; ++channel) {
    // Grows at once, shrinks only after two quiet seconds: a scale that hunts cannot be read.
    const auto at = static_cast<std::size_t>(channel);
    const double wanted = scope_range(peak(channel));
    quiet_.at(at) = wanted < range_.at(at) ? quiet_.at(at) + 1 : 0;
    constexpr int kTwoSeconds = 60;
    if (first || wanted > range_.at(at) || quiet_.at(at) > kTwoSeconds) {
      range_.at(at) = wanted;
      quiet_.at(at) = 0;
    }
  }
  update();
}

ScopeView::Bands ScopeView::bands() const {
  // From top to bottom: caption, sensors, slots, accelerations; gap, caption, clock.
  const double top = 2 * kTitle + kSlots, height_left = height() - top - kGap - kTitle;
  const double data_height = std::floor(height_left * 0.66);
  const double inner = width();
  return {QRectF(0, kTitle, inner, kTitle), QRectF(0, 2 * kTitle, inner, kSlots), QRectF(0, top, inner, data_height),
          QRectF(0, top + data_height + kGap + kTitle, inner, height_left - data_height)};
}

void ScopeView::paint_ground(QPainter& painter, const QRectF& band) const {
  const ThemeColors& theme = theme_colors(palette());
  painter.fillRect(band, theme.base);
  painter.setPen(theme.grid);
  const double middle = std::floor(band.center().y()) + 0.5;
  painter.drawLine(QPointF(band.left(), middle), QPointF(band.right(), middle));
}

void ScopeView::paint_slots(QPainter& painter, const Bands& areas, const ScopeWindow& window, const AxisMap& x) const {
  const ThemeColors& theme = theme_colors(palette());
  const double start = window.cycle->start_sample, slot = window.period / slot_count_;
  for (int i = 0; i < slot_count_; ++i) {
    const double from = x.to_pixel(start + i * slot), to = x.to_pixel(start + (i + 1) * slot);
    const int sensor = i / 3;
    const bool reference = i == slot_count_ - 1;
    QColor tint = reference ? theme.dim : series_color(theme, sensor);
    const QColor ink = tint;
    tint.setAlphaF(sensor == selected_ && !reference ? 0.22F : (i % 2 == 0 ? 0.09F : 0.05F));
    painter.fillRect(QRectF(from, areas.data.top(), to - from, areas.data.height()), tint);
    const bool clipped = (window.cycle->clipped >> static_cast<unsigned>(i) & 1U) != 0;
    painter.setPen(clipped ? theme.danger : ink);
    painter.drawText(QRectF(from, areas.slot_row.top(), to - from, kSlots), Qt::AlignCenter,
                     clipped ? QStringLiteral("%1!").arg(i) : QString::number(i));
  }
  // A hairline and the name where a sensor begins, beneath which its three axes stand.
  for (int sensor = 0; sensor * 3 < slot_count_; ++sensor) {
    const bool reference = sensor * 3 == slot_count_ - 1;
    const double from = x.to_pixel(start + sensor * 3 * slot);
    const double to = x.to_pixel(start + std::min(slot_count_, sensor * 3 + 3) * slot);
    painter.setPen(theme.line);
    painter.drawLine(QPointF(from, areas.sensor_row.top() + 2), QPointF(from, areas.data.bottom()));
    painter.setPen(reference ? theme.dim : series_color(theme, sensor));
    const QString name = reference ? tr("ref") : QStringLiteral("%1  %2").arg(sensor + 1).arg(sensors_.value(sensor));
    painter.drawText(QRectF(from + 4, areas.sensor_row.top(), to - from - 6, kTitle), Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(name, Qt::ElideRight, static_cast<int>(to - from - 6)));
  }
}

void ScopeView::paint_channel(QPainter& painter, const QRectF& band, const ScopeWindow& window, const AxisMap& x,
                              int channel, bool slots_known) const {
  const ThemeColors& theme = theme_colors(palette());
  const double range = range_.at(static_cast<std::size_t>(channel));
  const AxisMap y{-range, range, band.bottom(), band.top()};
  const double first = snapshot_->scope_first_sample;
  const auto frames = static_cast<std::int64_t>(snapshot_->scope.size() / 2);
  const auto begin =
      std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor(window.first_sample - first)), 0, frames);
  const auto end =
      std::clamp<std::int64_t>(static_cast<std::int64_t>(std::ceil(window.last_sample - first)), 0, frames);
  painter.save();
  painter.setClipRect(band);
  // One stroke per stretch of one colour; a sample at the border belongs to both.
  QPolygonF line;
  QColor color = theme.text;
  const auto flush = [&] {
    painter.setPen(QPen(color, 1));
    painter.drawPolyline(line);
  };
  for (std::int64_t i = begin; i < end; ++i) {
    const double sample = first + static_cast<double>(i);
    QColor wanted = theme.text;
    if (slots_known && window.cycle) {
      const double place = (sample - window.cycle->start_sample) / window.period * slot_count_;
      const int slot = static_cast<int>(std::floor(place));
      wanted = slot < 0 || slot >= slot_count_ - 1 ? theme.dim : series_color(theme, slot / 3);
    }
    const auto value = static_cast<double>(snapshot_->scope[static_cast<std::size_t>(2 * i + channel)]);
    const QPointF point(x.to_pixel(sample), y.to_pixel(std::isfinite(value) ? value : 0.0));
    if (wanted != color && !line.isEmpty()) {
      line.append(point);
      flush();
      line = QPolygonF{point};
    } else {
      line.append(point);
    }
    color = wanted;
  }
  flush();
  painter.restore();
}

void ScopeView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const ThemeColors& theme = theme_colors(palette());
  QFont small = font();
  small.setPixelSize(11);
  painter.setFont(tabular(small));
  const Bands areas = bands();
  const bool swapped = snapshot_ && snapshot_->line.swapped;
  const auto note = [&](int channel) {
    const double range = range_.at(static_cast<std::size_t>(channel));
    return tr("full height ±%1 of full scale").arg(QLocale().toString(range, 'g', 2));
  };
  paint_ground(painter, areas.data);
  paint_ground(painter, areas.clock);
  const bool any = snapshot_ && snapshot_->scope.size() >= 8;
  ScopeWindow window;
  if (any) {
    const double free_samples = snapshot_->format.rate.hz * 0.02;
    window =
        scope_window(snapshot_->scope_cycles, snapshot_->scope_first_sample, snapshot_->scope.size() / 2, free_samples);
    const AxisMap x{window.first_sample, window.last_sample, areas.data.left(), areas.data.right()};
    painter.save();
    painter.setClipRect(QRectF(areas.data.left(), 0, areas.data.width(), height()));
    if (window.cycle) {
      paint_slots(painter, areas, window, x);
    }
    painter.restore();
    paint_channel(painter, areas.data, window, x, swapped ? 1 : 0, true);
    paint_channel(painter, areas.clock, window, x, swapped ? 0 : 1, false);
  }
  painter.setPen(theme.dim);
  const QString data_title = swapped ? tr("Right channel: accelerations (swapped)") : tr("Left channel: accelerations");
  const QString clock_title = swapped ? tr("Left channel: clock (swapped)") : tr("Right channel: clock");
  const auto caption = [&](double top, const QString& left, const QString& right) {
    const QRectF row(0, top, width(), kTitle);
    painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter, left);
    painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, right);
  };
  caption(0, data_title, any ? note(swapped ? 1 : 0) : QString());
  caption(areas.clock.top() - kTitle, clock_title, any ? note(swapped ? 0 : 1) : QString());
  if (any && !window.cycle) {
    painter.setPen(theme.warning);
    painter.drawText(areas.slot_row.united(areas.sensor_row), Qt::AlignCenter,
                     tr("not in step with the board: the picture runs free, slots are not known"));
  } else if (!any) {
    painter.drawText(areas.data, Qt::AlignCenter, tr("no signal"));
  }
}

void ScopeView::mousePressEvent(QMouseEvent* event) {
  const Bands areas = bands();
  int sensor = -1;
  if (snapshot_ && snapshot_->scope.size() >= 8) {
    const ScopeWindow window = scope_window(snapshot_->scope_cycles, snapshot_->scope_first_sample,
                                            snapshot_->scope.size() / 2, snapshot_->format.rate.hz * 0.02);
    if (window.cycle) {
      const AxisMap x{window.first_sample, window.last_sample, areas.data.left(), areas.data.right()};
      const double slot =
          (x.to_value(event->position().x()) - window.cycle->start_sample) / window.period * slot_count_;
      sensor = slot >= 0.0 && slot < slot_count_ - 1 ? static_cast<int>(slot) / 3 : -1;
    }
  }
  Q_EMIT sensor_clicked(sensor);
}

}  // namespace limbwave::ui
