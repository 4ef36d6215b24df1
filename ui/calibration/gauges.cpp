#include "calibration/gauges.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "common/icons.h"
#include "common/theme.h"

namespace limbwave::ui {

QColor finding_color(const QPalette& palette, Tone tone) {
  if (tone == Tone::kDanger) {
    return theme_colors(palette).dark ? QColor(0xf0, 0x7c, 0x3c) : QColor(0xb9, 0x4a, 0x00);
  }
  return tone_color(palette, tone);
}

RateGauge::RateGauge(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void RateGauge::set_rate(double rate, double limit, bool jerky, bool signal) {
  rate_ = rate;
  limit_ = limit;
  // 1 g/s is gravity turning by one radian in a second.
  const QString speed = tr("%1°/s").arg(qRound(degrees(rate)));
  if (!signal) {
    tone_ = Tone::kDanger;
    word_ = tr("No signal");
  } else if (rate > limit) {
    tone_ = Tone::kWarning;
    word_ = tr("Too fast: %1").arg(speed);
  } else if (jerky) {
    tone_ = Tone::kWarning;
    word_ = tr("Jerky: %1").arg(speed);
  } else {
    tone_ = Tone::kGood;
    word_ = tr("Steady: %1").arg(speed);
  }
  setAccessibleName(word_);
  update();
}

void RateGauge::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const ThemeColors& theme = theme_colors(palette());
  const QColor color = finding_color(palette(), tone_);
  const int size = 18;
  painter.drawPixmap(0, 2, icon_pixmap(tone_icon(tone_), color, size, devicePixelRatioF()));
  painter.setFont(tabular(font(), 1.25, QFont::DemiBold));
  painter.setPen(theme.text);
  painter.drawText(QRect(size + 8, 0, width() - size - 8, 22), Qt::AlignLeft | Qt::AlignVCenter, word_);
  const QRectF bar(0, 32, width(), 8);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme.raised);
  painter.drawRoundedRect(bar, 4, 4);
  // The limit stands at two thirds, so that too fast has room to show how much.
  const double fraction = std::clamp(rate_ / limit_ / 1.5, 0.0, 1.0);
  painter.setBrush(color);
  painter.drawRoundedRect(QRectF(bar.left(), bar.top(), std::max(8.0, bar.width() * fraction), bar.height()), 4, 4);
  const double limit_x = bar.left() + bar.width() / 1.5;
  painter.setPen(QPen(theme.text, 1.5));
  painter.drawLine(QPointF(limit_x, bar.top() - 4), QPointF(limit_x, bar.bottom() + 4));
}

MovementBars::MovementBars(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QString MovementBars::row_words(const Row& row, double threshold_g) {
  if (!row.heard) {
    return tr("waiting");
  }
  if (!row.has_signal) {
    return tr("no signal");
  }
  return row.movement_g > threshold_g ? tr("moves: %1").arg(format_mg(row.movement_g))
                                      : tr("still: %1").arg(format_mg(row.movement_g));
}

void MovementBars::set_rows(std::vector<Row> rows, double threshold_g) {
  const bool resized = rows.size() != rows_.size();
  rows_ = std::move(rows);
  threshold_g_ = threshold_g;
  QStringList words;
  for (const Row& row : rows_) {
    words << row.name + QStringLiteral(" ") + row_words(row, threshold_g_);
  }
  setAccessibleName(words.join(QStringLiteral("; ")));
  if (resized) {
    updateGeometry();
  }
  update();
}

QSize MovementBars::sizeHint() const {
  return {480, static_cast<int>(rows_.size()) * 34 + 22};
}

void MovementBars::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const ThemeColors& theme = theme_colors(palette());
  const int names = 120;
  const int words = 150;
  const double left = names;
  const double span = std::max(40, width() - names - words);
  // Square root scale: 5 mg and 200 mg are both to be seen, the threshold stands at 0.4.
  const auto x_of = [&](double g) { return left + span * std::min(1.0, 0.4 * std::sqrt(g / threshold_g_)); };
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    const double y = static_cast<double>(i) * 34.0;
    const Tone tone = !row.heard                      ? Tone::kUnknown
                      : !row.has_signal               ? Tone::kDanger
                      : row.movement_g > threshold_g_ ? Tone::kWarning
                                                      : Tone::kGood;
    const QColor color = finding_color(palette(), tone);
    QFont name_font = font();
    name_font.setPixelSize(15);
    painter.setFont(name_font);
    painter.setPen(theme.text);
    painter.drawText(QRectF(0, y, names - 12, 30), Qt::AlignLeft | Qt::AlignVCenter,
                     QFontMetrics(name_font).elidedText(row.name, Qt::ElideRight, names - 12));
    const QRectF bar(left, y + 9, span, 12);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.raised);
    painter.drawRoundedRect(bar, 4, 4);
    if (row.has_signal) {
      painter.setBrush(color);
      painter.drawRoundedRect(QRectF(left, bar.top(), std::max(8.0, x_of(row.movement_g) - left), bar.height()), 4, 4);
    }
    painter.drawPixmap(QPointF(left + span + 12, y + 6), icon_pixmap(tone_icon(tone), color, 18, devicePixelRatioF()));
    painter.setFont(tabular(name_font));
    painter.setPen(theme.text);
    painter.drawText(QRectF(left + span + 36, y, words - 36, 30), Qt::AlignLeft | Qt::AlignVCenter,
                     row_words(row, threshold_g_));
  }
  const double bottom = static_cast<double>(rows_.size()) * 34.0;
  painter.setPen(QPen(theme.text, 1.5));
  painter.drawLine(QPointF(x_of(threshold_g_), 2), QPointF(x_of(threshold_g_), bottom));
  painter.setFont(font());
  painter.setPen(theme.dim);
  painter.drawText(QRectF(x_of(threshold_g_) - 120, bottom, 240, 20), Qt::AlignCenter,
                   tr("still below %1").arg(format_mg(threshold_g_)));
}

CountdownDial::CountdownDial(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void CountdownDial::set_state(const QString& text, double fraction, Tone tone) {
  text_ = text;
  fraction_ = std::clamp(fraction, 0.0, 1.0);
  tone_ = tone;
  setAccessibleName(text);
  update();
}

int CountdownDial::text_pixels() const {
  const int side = std::min(width(), height());
  // A figure fills the ring; a word has to share it.
  return std::max(48,
                  text_.size() <= 2 ? side / 2 : static_cast<int>(1.15 * side / std::max<qsizetype>(4, text_.size())));
}

void CountdownDial::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const ThemeColors& theme = theme_colors(palette());
  const double side = std::min(width(), height()) - 16.0;
  const QRectF ring(width() / 2.0 - side / 2.0, height() / 2.0 - side / 2.0, side, side);
  const double pen = std::max(8.0, side / 22.0);
  const QRectF inner = ring.adjusted(pen / 2, pen / 2, -pen / 2, -pen / 2);
  painter.setPen(QPen(theme.raised, pen));
  painter.drawEllipse(inner);
  painter.setPen(
      QPen(tone_ == Tone::kUnknown ? theme.accent : finding_color(palette(), tone_), pen, Qt::SolidLine, Qt::RoundCap));
  painter.drawArc(inner, 90 * 16, -static_cast<int>(std::lround(fraction_ * 360.0 * 16.0)));
  QFont figures = font();
  figures.setPixelSize(text_pixels());
  figures.setWeight(QFont::DemiBold);
  painter.setFont(figures);
  painter.setPen(theme.text);
  painter.drawText(ring, Qt::AlignCenter, text_);
}

VerdictBadge::VerdictBadge(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void VerdictBadge::set_state(const CalibrationState& state) {
  state_ = state;
  setAccessibleName(text());
  setToolTip(state.detail);
  updateGeometry();
  update();
}

QString VerdictBadge::text() const {
  return state_.number.isEmpty() ? state_.word : state_.word + QStringLiteral(" ") + state_.number;
}

QSize VerdictBadge::sizeHint() const {
  const QFontMetrics bold(tabular(font(), 1.15, QFont::DemiBold));
  const int words = bold.horizontalAdvance(text()) + 32;
  return {std::max(words, fontMetrics().horizontalAdvance(state_.detail) + 28), state_.detail.isEmpty() ? 24 : 44};
}

void VerdictBadge::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const ThemeColors& theme = theme_colors(palette());
  painter.drawPixmap(
      0, 3, icon_pixmap(tone_icon(state_.tone), finding_color(palette(), state_.tone), 18, devicePixelRatioF()));
  const QFont bold = tabular(font(), 1.15, QFont::DemiBold);
  painter.setFont(bold);
  painter.setPen(state_.tone == Tone::kUnknown ? theme.dim : finding_color(palette(), state_.tone));
  painter.drawText(QRect(26, 0, width() - 26, 24), Qt::AlignLeft | Qt::AlignVCenter, state_.word);
  const int advance = QFontMetrics(bold).horizontalAdvance(state_.word + QStringLiteral(" "));
  painter.setPen(theme.text);
  painter.drawText(QRect(26 + advance, 0, width() - 26 - advance, 24), Qt::AlignLeft | Qt::AlignVCenter, state_.number);
  painter.setFont(font());
  painter.setPen(theme.dim);
  painter.drawText(QRect(26, 24, width() - 26, 20), Qt::AlignLeft | Qt::AlignVCenter,
                   fontMetrics().elidedText(state_.detail, Qt::ElideRight, width() - 26));
}

}  // namespace limbwave::ui
