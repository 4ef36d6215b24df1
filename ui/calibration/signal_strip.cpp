#include "calibration/signal_strip.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "calibration/calibration_words.h"
#include "common/theme.h"

namespace limbwave::ui {
namespace {

constexpr double kSpanG = 1.5;  ///< Half of what the strip shows.
constexpr int kLegend = 92;

}  // namespace

SignalStrip::SignalStrip(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  setAccessibleName(tr("Accelerations of the newest seconds"));
}

void SignalStrip::set_readings(const std::deque<decode::AccelerationFrame>& frames, int sensor,
                               const body::LineInSignal& signal, double seconds) {
  const double zero = signal.zero_g_volts - signal.reference_volts;
  seconds_ = seconds;
  readings_.clear();
  readings_.reserve(frames.size());
  const auto at = static_cast<std::size_t>(sensor);
  for (const decode::AccelerationFrame& frame : frames) {
    readings_.push_back({frame.time_s, (frame.volts.at(at) - Eigen::Vector3d::Constant(zero)) / signal.volts_per_g,
                         (frame.usable >> at & 1U) != 0});
  }
  update();
}

void SignalStrip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const ThemeColors& theme = theme_colors(palette());
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme.base);
  painter.drawRoundedRect(rect(), 4, 4);
  const QRectF plot(32, 6, width() - 32 - kLegend, height() - 12);
  const auto y_of = [&plot](double g) { return plot.center().y() - g / kSpanG * plot.height() / 2.0; };
  for (const double g : {-1.0, 0.0, 1.0}) {
    painter.setPen(theme.grid);
    painter.drawLine(QPointF(plot.left(), y_of(g)), QPointF(plot.right(), y_of(g)));
    painter.setPen(theme.dim);
    painter.drawText(QRectF(0, y_of(g) - 9, 27, 18), Qt::AlignRight | Qt::AlignVCenter,
                     g < 0 ? QString(QChar(0x2212)) + QStringLiteral("1 g") : tr("%1 g").arg(g));
  }
  if (readings_.empty()) {
    painter.setPen(theme.dim);
    painter.drawText(plot, Qt::AlignCenter, tr("No readings yet"));
    return;
  }
  const double newest = readings_.back().time_s;
  for (int axis = 0; axis < 3; ++axis) {
    painter.setPen(QPen(series_color(theme, axis), 1.0));
    QPolygonF line;
    const auto flush = [&] {
      painter.drawPolyline(line);
      line.clear();
    };
    for (const Reading& reading : readings_) {
      if (!reading.usable || !std::isfinite(reading.g[axis])) {
        flush();
        continue;
      }
      const double x = plot.right() - (newest - reading.time_s) / seconds_ * plot.width();
      line << QPointF(x, y_of(std::clamp(reading.g[axis], -kSpanG, kSpanG)));
    }
    flush();
    // The legend carries the present values, so that colours need not be learnt.
    const Reading& last = readings_.back();
    const QRectF row(width() - kLegend + 10, plot.center().y() + (axis - 1) * 24 - 12, kLegend - 18, 24);
    painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter, QString(QLatin1Char("xyz"[axis])));
    painter.setPen(theme.text);
    const double g = last.g[axis];
    painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter,
                     last.usable ? (g < 0 ? QString(QChar(0x2212)) : QStringLiteral("+")) +
                                       QLocale().toString(std::abs(g), 'f', 2) + tr(" g")
                                 : tr("none"));
  }
}

}  // namespace limbwave::ui
