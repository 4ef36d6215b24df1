#include "calibration/sensor_cube.h"

#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "common/theme.h"

namespace limbwave::ui {
namespace {

using Eigen::Vector3d;

// Where the viewer stands: a little to the right and above.
const Eigen::Matrix3d& camera() {
  static const Eigen::Matrix3d R_CW =
      (Eigen::AngleAxisd(0.42, Vector3d::UnitX()) * Eigen::AngleAxisd(0.5, Vector3d::UnitZ())).toRotationMatrix();
  return R_CW;
}

// In the camera's frame: x right, z up, y away from the viewer.
Vector3d seen(const Vector3d& v_W) {
  return camera() * v_W;
}

}  // namespace

SensorCube::SensorCube(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("How the sensor is held"));
}

void SensorCube::set_up(const Vector3d& up_S) {
  if (up_S.norm() < 1e-6) {
    return;
  }
  const Vector3d up_W = R_WS_ * up_S.normalized();
  R_WS_ = (Eigen::Quaterniond::FromTwoVectors(up_W, Vector3d::UnitZ()) * R_WS_).normalized();
  update();
}

void SensorCube::set_wanted(const std::optional<Vector3d>& wanted_S) {
  wanted_S_ = wanted_S;
  update();
}

void SensorCube::set_orientation(const Eigen::Quaterniond& R_WS) {
  R_WS_ = R_WS;
  update();
}

QPointF SensorCube::place(const Vector3d& v_W) const {
  const Vector3d v = seen(v_W);
  // With an arrow there must be room for it beyond a corner.
  const double scale = std::min(width(), height()) / (wanted_S_ ? 4.8 : 3.7);
  return {width() / 2.0 + scale * v.x(), height() / 2.0 + 0.1 * scale - scale * v.z()};
}

void SensorCube::paint_face(QPainter& painter, int axis, double sign) const {
  const Vector3d normal_S = sign * Vector3d::Unit(axis);
  const Vector3d u_S = Vector3d::Unit((axis + 1) % 3);
  const Vector3d v_S = Vector3d::Unit((axis + 2) % 3);
  const ThemeColors& theme = theme_colors(palette());
  QPolygonF face;
  for (const auto& [a, b] : std::array<std::pair<double, double>, 4>{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}}) {
    face << place(R_WS_ * (normal_S + a * u_S + b * v_S));
  }
  const double light = std::clamp((R_WS_ * normal_S).dot(Vector3d(0.35, -0.5, 0.79)), 0.0, 1.0);
  const QColor low = theme.dark ? theme.raised.darker(115) : theme.raised.darker(112);
  const QColor high = theme.dark ? theme.raised.lighter(165) : theme.panel;
  const auto mix = [light](int a, int b) { return static_cast<int>(a + (b - a) * light); };
  painter.setPen(QPen(theme.window, 1.5));
  painter.setBrush(QColor(mix(low.red(), high.red()), mix(low.green(), high.green()), mix(low.blue(), high.blue())));
  painter.drawPolygon(face);
  // The letter lies on the face: that is what the technician compares with the sensor in the hand. Of the four ways to
  // write it, the one that stands most upright on the screen; from outside, right × up is the outward normal.
  const QPointF middle = place(R_WS_ * normal_S);
  QPointF right;
  QPointF up(0.0, 1e9);
  for (int quarter = 0; quarter < 4; ++quarter) {
    const Vector3d up_S =
        quarter % 2 == 0 ? (quarter == 0 ? u_S : Vector3d(-u_S)) : (quarter == 1 ? v_S : Vector3d(-v_S));
    const QPointF up_here = place(R_WS_ * (normal_S + up_S)) - middle;
    if (up_here.y() < up.y()) {
      up = up_here;
      right = place(R_WS_ * (normal_S + up_S.cross(normal_S))) - middle;
    }
  }
  painter.save();
  painter.setTransform(
      QTransform(right.x() / 32.0, right.y() / 32.0, -up.x() / 32.0, -up.y() / 32.0, middle.x(), middle.y()), true);
  QFont letters = font();
  letters.setPixelSize(30);
  letters.setBold(true);
  painter.setFont(letters);
  painter.setPen(series_color(theme, axis));
  painter.drawText(QRectF(-32, -24, 64, 48), Qt::AlignCenter,
                   (sign > 0 ? QStringLiteral("+") : QString(QChar(0x2212))) + QLatin1Char("xyz"[axis]));
  painter.restore();
}

void SensorCube::paint_arrow(QPainter& painter, const Vector3d& from_W, const Vector3d& to_W,
                             const QColor& color) const {
  const QPointF a = place(from_W);
  const QPointF b = place(to_W);
  QPointF along = b - a;
  const double length = std::hypot(along.x(), along.y());
  if (length < 1.0) {
    return;
  }
  along /= length;
  const QPointF across(-along.y(), along.x());
  painter.setPen(QPen(color, 3.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(a, b - along * 4.0);
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawPolygon(QPolygonF{b + along * 4.0, b - along * 9.0 + across * 7.0, b - along * 9.0 - across * 7.0});
}

void SensorCube::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const ThemeColors& theme = theme_colors(palette());
  if (wanted_S_) {
    // Where the arrow's head should come to.
    painter.setPen(QPen(theme.accent, 1.5, Qt::DotLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(place(1.9 * Vector3d::UnitZ()), 12.0, 6.0);
  }
  const bool behind = wanted_S_ && seen(R_WS_ * wanted_S_->normalized()).y() > 0.0;
  const auto wanted_arrow = [&] {
    if (wanted_S_) {
      const Vector3d d = R_WS_ * wanted_S_->normalized();
      const Vector3d on_face = d / (R_WS_.conjugate() * d).cwiseAbs().maxCoeff();
      paint_arrow(painter, on_face, on_face + 0.75 * d, theme.accent);
    }
  };
  if (behind) {
    wanted_arrow();
  }
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      // Only what faces the viewer.
      if (seen(R_WS_ * (sign * Vector3d::Unit(axis))).y() < -1e-3) {
        paint_face(painter, axis, sign);
      }
    }
  }
  if (!behind) {
    wanted_arrow();
  }
}

}  // namespace limbwave::ui
