#include "plots/level_meter.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "common/format.h"
#include "common/theme.h"

namespace limbwave::ui {

double level_position(double fraction) {
  if (!(fraction > 0.0)) {
    return 0.0;
  }
  return std::clamp(1.0 + 20.0 * std::log10(fraction) / 60.0, 0.0, 1.0);
}

LevelMeter::LevelMeter(const QString& title, QWidget* parent) : QWidget(parent), title_(title) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(title);
}

void LevelMeter::set_level(double peak, bool clipping) {
  if (peak != peak_ || clipping != clipping_) {
    peak_ = peak;
    clipping_ = clipping;
    setAccessibleDescription(peak < 0.0 ? QString() : format_level(peak));
    update();
  }
}

void LevelMeter::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const ThemeColors& theme = theme_colors(palette());
  const QRectF text(0, 0, width(), 18);
  painter.setPen(theme.dim);
  painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter, title_);
  painter.setPen(theme.text);
  painter.setFont(tabular(font()));
  painter.drawText(text, Qt::AlignRight | Qt::AlignVCenter,
                   clipping_     ? tr("clips")
                   : peak_ < 0.0 ? QStringLiteral("–")
                                 : format_level(peak_));
  const QRectF bar(0, 22, width(), 8);
  painter.fillRect(bar, theme.base);
  // Where it should be: a quiet zone behind the bar.
  const double from = level_position(kLevelTooLow) * bar.width(), to = level_position(kLevelTooHigh) * bar.width();
  QColor zone = theme.good;
  zone.setAlphaF(0.22F);
  painter.fillRect(QRectF(from, bar.top(), to - from, bar.height()), zone);
  if (peak_ > 0.0) {
    const QColor color = clipping_                                       ? theme.danger
                         : peak_ < kLevelTooLow || peak_ > kLevelTooHigh ? theme.warning
                                                                         : theme.good;
    painter.fillRect(QRectF(0, bar.top() + 2, level_position(peak_) * bar.width(), bar.height() - 4), color);
  }
  painter.setPen(theme.dim);
  for (const double mark : {from, to}) {
    painter.drawLine(QPointF(std::floor(mark) + 0.5, bar.top()), QPointF(std::floor(mark) + 0.5, bar.bottom()));
  }
}

}  // namespace limbwave::ui
