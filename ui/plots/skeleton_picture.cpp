#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "plots/take_pictures.h"

namespace limbwave::ui {
namespace {

const QColor kBackground(24, 27, 31);
const QColor kGrid(58, 64, 72);
const QColor kText(200, 205, 212);
const QColor kTrail(230, 159, 0);
const QColor kBones[] = {QColor(150, 158, 170), QColor(86, 180, 233), QColor(0, 158, 115), QColor(230, 159, 0),
                         QColor(204, 121, 167)};

// Orthographic view from the front right, slightly above.
struct Camera {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double scale = 1.0;
  QPointF middle;
  Eigen::Vector3d right, up, toward;

  Camera() {
    const double azimuth = radians(-55.0);
    const double elevation = radians(14.0);
    toward = {std::cos(azimuth) * std::cos(elevation), std::sin(azimuth) * std::cos(elevation), std::sin(elevation)};
    right = Eigen::Vector3d::UnitZ().cross(toward).normalized();
    up = toward.cross(right);
  }
  [[nodiscard]] QPointF project(const Eigen::Vector3d& p) const {
    const Eigen::Vector3d d = p - centre;
    return middle + QPointF(scale * right.dot(d), -scale * up.dot(d));
  }
  [[nodiscard]] double depth(const Eigen::Vector3d& p) const { return toward.dot(p - centre); }
};

Eigen::Vector3d bone_end(const body::Segment& segment, const body::SegmentPose& pose) {
  return pose.p_WL + pose.R_WL * Eigen::Vector3d(segment.length, 0.0, 0.0);
}

void draw_floor(QPainter& painter, const Camera& camera) {
  painter.setPen(QPen(kGrid, 1.0));
  for (int i = -4; i <= 4; ++i) {
    const double at = 0.25 * i;
    painter.drawLine(camera.project({at, -1.0, 0.0}), camera.project({at, 1.0, 0.0}));
    painter.drawLine(camera.project({-1.0, at, 0.0}), camera.project({1.0, at, 0.0}));
  }
}

// A bone as a tapered shape with its widest place a fifth of the way along, as animators know it.
void draw_bone(QPainter& painter, const QPointF& a, const QPointF& b, double width, const QColor& colour) {
  const QPointF along = b - a;
  const double length = std::hypot(along.x(), along.y());
  const QPointF side = length > 1e-6 ? QPointF(-along.y(), along.x()) * (width / length) : QPointF(width, 0.0);
  const QPointF wide = a + 0.2 * along;
  QPainterPath lit;
  lit.moveTo(a);
  lit.lineTo(wide + side);
  lit.lineTo(b);
  lit.closeSubpath();
  QPainterPath shade;
  shade.moveTo(a);
  shade.lineTo(wide - side);
  shade.lineTo(b);
  shade.closeSubpath();
  painter.setPen(Qt::NoPen);
  painter.fillPath(lit, colour);
  painter.fillPath(shade, colour.darker(140));
  painter.setBrush(colour.lighter(125));
  painter.drawEllipse(a, 0.45 * width, 0.45 * width);
}

}  // namespace

QImage skeleton_picture(const motion::Clip& clip, int instants, QSize panel) {
  QImage image(panel.width() * instants, panel.height(), QImage::Format_ARGB32_Premultiplied);
  image.fill(kBackground);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  const double duration = clip.duration();

  // One scale for all panels, so that the whole motion fits.
  Camera camera;
  double reach = 0.5;
  camera.centre = {0.0, 0.0, 0.85};
  constexpr int kProbes = 60;
  for (int i = 0; i <= kProbes; ++i) {
    const std::vector<body::SegmentPose> pose = motion::pose_at(clip, duration * i / kProbes);
    for (std::size_t s = 0; s < pose.size(); ++s) {
      const Eigen::Vector3d end = bone_end(clip.skeleton.segments[s], pose[s]) - camera.centre;
      reach = std::max({reach, std::abs(camera.right.dot(end)), std::abs(camera.up.dot(end))});
    }
  }
  reach = std::max(reach, 0.95);
  camera.scale = 0.46 * std::min(panel.width(), panel.height() - 40) / reach;

  for (int i = 0; i < instants; ++i) {
    const double time = instants > 1 ? duration * i / (instants - 1) : 0.0;
    const QRect frame(i * panel.width(), 0, panel.width(), panel.height());
    painter.save();
    painter.setClipRect(frame);
    camera.middle = QPointF(frame.center()) + QPointF(0.0, -8.0);
    draw_floor(painter, camera);

    // Where the end of the chain came from during the last half second.
    QPainterPath trail;
    constexpr int kTrailPoints = 30;
    for (int k = 0; k <= kTrailPoints; ++k) {
      const double past = std::max(0.0, time - 0.5 * (kTrailPoints - k) / kTrailPoints);
      const std::vector<body::SegmentPose> pose = motion::pose_at(clip, past);
      const QPointF point = camera.project(bone_end(clip.skeleton.segments.back(), pose.back()));
      k == 0 ? trail.moveTo(point) : trail.lineTo(point);
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(kTrail, 1.5, Qt::DotLine));
    painter.drawPath(trail);

    const std::vector<body::SegmentPose> pose = motion::pose_at(clip, time);
    std::vector<std::size_t> order(pose.size());
    for (std::size_t s = 0; s < order.size(); ++s) {
      order[s] = s;
    }
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return camera.depth(pose[a].p_WL) < camera.depth(pose[b].p_WL); });
    for (const std::size_t s : order) {
      const body::Segment& segment = clip.skeleton.segments[s];
      // What does not hang on its parent's end (a shoulder beside the spine) is joined to it by a thin line.
      if (segment.parent >= 0) {
        const auto p = static_cast<std::size_t>(segment.parent);
        const QPointF end = camera.project(bone_end(clip.skeleton.segments[p], pose[p]));
        painter.setPen(QPen(kBones[p % std::size(kBones)].darker(130), 2.0));
        painter.drawLine(end, camera.project(pose[s].p_WL));
      }
      const double width = std::clamp(0.11 * segment.length, 0.012, 0.06) * camera.scale;
      draw_bone(painter, camera.project(pose[s].p_WL), camera.project(bone_end(segment, pose[s])), width,
                kBones[s % std::size(kBones)]);
    }
    painter.setPen(kText);
    QFont font = painter.font();
    font.setPixelSize(15);
    painter.setFont(font);
    painter.drawText(frame.adjusted(0, 0, 0, -10), Qt::AlignHCenter | Qt::AlignBottom,
                     QStringLiteral("%1 s").arg(time, 0, 'f', 2));
    if (i > 0) {
      painter.setPen(kGrid);
      painter.drawLine(frame.topLeft(), frame.bottomLeft());
    }
    painter.restore();
  }
  return image;
}

}  // namespace limbwave::ui
