#include "workspaces/demo_picture.h"

#include <QPainter>
#include <QPainterPath>
#include <cmath>
#include <numbers>

#include "common/theme.h"

namespace limbwave::ui {
namespace {

constexpr double kUpperArm = 0.17, kForearm = 0.16, kHand = 0.06;

/// Angles in degrees from hanging down, counted outwards: upper arm, and forearm beyond it.
std::array<double, 2> arm_angles(const QString& motion, double phase) {
  const double wave = std::sin(2.0 * std::numbers::pi * phase);
  if (motion.contains(QLatin1String("wav"))) {
    return {75.0 + 6.0 * wave, 95.0 + 38.0 * wave};
  }
  if (motion.contains(QLatin1String("reach"))) {
    return {-5.0 + 80.0 * phase, 75.0 - 65.0 * phase};
  }
  if (motion.contains(QLatin1String("walk"))) {
    return {5.0 + 32.0 * wave, 24.0 + 14.0 * wave};
  }
  if (motion.contains(QLatin1String("box"))) {
    return {20.0 + 68.0 * phase, 120.0 - 118.0 * phase};
  }
  if (motion.contains(QLatin1String("exercise")) || motion.contains(QLatin1String("joint"))) {
    return {20.0 + 140.0 * phase, 15.0 + 60.0 * std::abs(wave)};
  }
  return {8.0 + 130.0 * phase, 6.0};
}

QPointF from_angle(double degrees, double length) {
  const double a = degrees * std::numbers::pi / 180.0;
  return {length * std::sin(a), length * std::cos(a)};
}

}  // namespace

std::array<QPointF, 3> demo_arm(const QString& motion, double phase) {
  const QPointF shoulder(0.105, 0.21);
  const auto [upper, fore] = arm_angles(motion, phase);
  const QPointF elbow = shoulder + from_angle(upper, kUpperArm);
  return {shoulder, elbow, elbow + from_angle(upper + fore, kForearm + kHand)};
}

DemoButton::DemoButton(const QString& motion, const QString& title, const QString& hint, QWidget* parent)
    : QPushButton(parent), motion_(motion), title_(title), hint_(hint) {
  setAccessibleName(title);
  setAccessibleDescription(hint);
  setToolTip(hint);
  setCursor(Qt::PointingHandCursor);
  setAttribute(Qt::WA_Hover);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize DemoButton::sizeHint() const {
  return {24 * kGrid, 30 * kGrid};
}

QSize DemoButton::minimumSizeHint() const {
  return {18 * kGrid, 30 * kGrid};
}

void DemoButton::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const ThemeColors& theme = theme_colors(palette());
  const QRectF card = QRectF(rect()).adjusted(1, 1, -1, -1);
  QPainterPath outline;
  outline.addRoundedRect(card, 6, 6);
  painter.fillPath(outline, theme.panel);
  const double text_height = 3.0 * fontMetrics().height();
  QRectF picture = card.adjusted(0, 0, 0, -text_height);
  painter.save();
  painter.setClipPath(outline);
  painter.fillRect(picture, theme.base);
  const double size = picture.height() * 0.98;
  const QPointF origin(picture.center().x() - 0.04 * size, picture.top() + 0.06 * size);
  const auto at = [&](QPointF p) { return origin + p * size; };
  const auto stroke = [&](const QColor& color, double width) {
    painter.setPen(QPen(color, width * size, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  };
  // The ground and the quiet body.
  painter.setPen(QPen(theme.grid, 1));
  const double ground = at({0, 0.90}).y();
  painter.drawLine(QPointF(picture.left(), ground), QPointF(picture.right(), ground));
  stroke(theme.raised, 0.045);
  painter.setBrush(theme.raised);
  painter.drawEllipse(at({0, 0.085}), 0.045 * size, 0.055 * size);
  painter.drawPolyline(QPolygonF{at({-0.055, 0.90}), at({-0.05, 0.68}), at({-0.045, 0.47}), at({0.045, 0.47}),
                                 at({0.05, 0.68}), at({0.055, 0.90})});
  painter.drawPolygon(QPolygonF{at({-0.09, 0.21}), at({0.09, 0.21}), at({0.05, 0.46}), at({-0.05, 0.46})});
  painter.drawPolyline(QPolygonF{at({-0.105, 0.21}), at({-0.13, 0.37}), at({-0.125, 0.53})});
  // The arm at five instants, the last one brightest, and the way of the wrist.
  constexpr int kInstants = 5;
  QPainterPath way;
  for (int i = 0; i <= 40; ++i) {
    const QPointF wrist = at(demo_arm(motion_, i / 40.0 * 0.8)[2]);
    i == 0 ? way.moveTo(wrist) : way.lineTo(wrist);
  }
  QColor trace = series_color(theme, 1);
  trace.setAlphaF(0.5F);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(trace, 1.5, Qt::DotLine));
  painter.drawPath(way);
  for (int i = 0; i < kInstants; ++i) {
    const auto [shoulder, elbow, wrist] = demo_arm(motion_, i / 5.0);
    const double share = (i + 1.0) / kInstants;
    QColor upper = series_color(theme, 0), fore = series_color(theme, 1);
    upper.setAlphaF(static_cast<float>(0.12 + 0.88 * share * share * share));
    fore.setAlphaF(upper.alphaF());
    stroke(upper, 0.034);
    painter.drawLine(at(shoulder), at(elbow));
    stroke(fore, 0.030);
    painter.drawLine(at(elbow), at(wrist));
  }
  painter.restore();

  painter.setPen(theme.text);
  QFont bold = font();
  bold.setWeight(QFont::DemiBold);
  painter.setFont(bold);
  const QRectF text(card.left() + 12, picture.bottom() + 8, card.width() - 24, fontMetrics().height() + 2);
  painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter,
                   QFontMetrics(bold).elidedText(title_, Qt::ElideRight, static_cast<int>(text.width())));
  painter.setFont(font());
  painter.setPen(theme.dim);
  painter.drawText(text.translated(0, fontMetrics().height() + 1), Qt::AlignLeft | Qt::AlignVCenter,
                   fontMetrics().elidedText(hint_, Qt::ElideRight, static_cast<int>(text.width())));
  if (hasFocus() || underMouse()) {
    painter.setPen(QPen(hasFocus() ? theme.accent : theme.line, 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(outline);
  }
}

}  // namespace limbwave::ui
