#include "calibration/pose_picture.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "common/theme.h"

namespace limbwave::ui {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

// A limb's thickness from its length: hands are flat, trunks are wide.
double thickness(double length) {
  return std::clamp(0.32 * length, 0.045, 0.17);
}

QPointF seen(const Vector3d& p) {
  return {p.x(), p.z()};
}

}  // namespace

std::vector<body::SegmentPose> figure_in_pose(const body::Rig& rig, const body::Skeleton& skeleton, int group,
                                              int pose) {
  const Vector3d root = skeleton.segments.empty() ? Vector3d::Zero() : skeleton.segments.front().p_PL;
  const std::vector<body::SegmentPose> rest = body::poses_from_joints(
      skeleton, std::vector<Quaterniond>(skeleton.segments.size(), Quaterniond::Identity()), root);
  std::vector<Quaterniond> R_WL;
  R_WL.reserve(rest.size());
  for (const body::SegmentPose& segment : rest) {
    R_WL.push_back(segment.R_WL);
  }
  const body::CalibrationGroup& limb = rig.groups.at(static_cast<std::size_t>(group));
  const Vector3d gravity_L = pose == 0 ? limb.first.gravity_L : limb.second.gravity_L;
  for (const int sensor : limb.sensors) {
    const int segment = skeleton.find(rig.accelerometers.at(static_cast<std::size_t>(sensor)).segment);
    if (segment < 0) {
      continue;
    }
    Quaterniond R = Quaterniond::FromTwoVectors(gravity_L, -Vector3d::UnitZ());
    // Gravity leaves the heading open: what can point forward does.
    const Vector3d bone = R * Vector3d::UnitX();
    if (std::hypot(bone.x(), bone.y()) > 0.1) {
      R = Quaterniond(Eigen::AngleAxisd(-std::atan2(bone.y(), bone.x()), Vector3d::UnitZ())) * R;
    }
    R_WL[static_cast<std::size_t>(segment)] = R;
  }
  return body::poses_from_orientations(skeleton, R_WL, root);
}

PosePicture::PosePicture(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void PosePicture::set_pose(const body::Rig& rig, const body::Skeleton& skeleton, int group, int pose,
                           std::vector<int> sensors) {
  bones_.clear();
  sensors_.clear();
  whole_figure_ = false;
  if (skeleton.segments.empty() || group >= static_cast<int>(rig.groups.size())) {
    update();
    return;
  }
  const body::CalibrationGroup& limb = rig.groups.at(static_cast<std::size_t>(group));
  const body::LimbPose& text = pose == 0 ? limb.first : limb.second;
  setAccessibleName(QString::fromStdString(text.instruction));
  const std::vector<body::SegmentPose> poses = figure_in_pose(rig, skeleton, group, pose);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const body::Segment& segment = skeleton.segments[i];
    const bool marked = std::any_of(sensors.begin(), sensors.end(), [&](int sensor) {
      return rig.accelerometers.at(static_cast<std::size_t>(sensor)).segment == segment.name;
    });
    const Vector3d end = poses[i].p_WL + poses[i].R_WL * (segment.length * Vector3d::UnitX());
    bones_.push_back({seen(poses[i].p_WL), seen(end), poses[i].p_WL.y(), thickness(segment.length), marked});
  }
  for (const int sensor : sensors) {
    const body::Accelerometer& accelerometer = rig.accelerometers.at(static_cast<std::size_t>(sensor));
    const int segment = skeleton.find(accelerometer.segment);
    if (segment >= 0) {
      const body::SegmentPose& on = poses[static_cast<std::size_t>(segment)];
      sensors_.push_back(seen(on.p_WL + on.R_WL * accelerometer.p_LS));
    }
  }
  const body::Segment& root = skeleton.segments.front();
  const Vector3d trunk = poses.front().R_WL * Vector3d::UnitX();
  const Vector3d rest_trunk = root.R_PL_rest * Vector3d::UnitX();
  whole_figure_ = root.length > 0.3 && rest_trunk.z() > 0.8 && poses.front().p_WL.z() > 0.5;
  hip_ = seen(poses.front().p_WL);
  head_ = seen(poses.front().p_WL + (root.length + 0.21) * trunk);
  update();
}

void PosePicture::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const ThemeColors& theme = theme_colors(palette());
  if (bones_.empty()) {
    return;
  }
  QRectF extent(hip_, QSizeF(0.001, 0.001));
  const auto include = [&extent](const QPointF& p, double r) {
    extent = extent.united(QRectF(p.x() - r, p.y() - r, 2 * r, 2 * r));
  };
  for (const Bone& bone : bones_) {
    include(bone.from, 0.12);
    include(bone.to, 0.12);
  }
  if (whole_figure_) {
    include(head_, 0.14);
    include(QPointF(hip_.x(), 0.0), 0.02);
    // Room for an arm stretched forward, so that both pictures of a pair have one scale.
    include(QPointF(hip_.x() + 0.85, 1.6), 0.05);
    include(QPointF(hip_.x() - 0.3, 0.5), 0.05);
  }
  const double scale = std::min((width() - 16.0) / extent.width(), (height() - 24.0) / extent.height());
  const QPointF origin(width() / 2.0 - extent.center().x() * scale, height() - 14.0 + extent.top() * scale);
  const auto place = [&](const QPointF& p) { return QPointF(origin.x() + p.x() * scale, origin.y() - p.y() * scale); };
  const auto capsule = [&](const QPointF& a, const QPointF& b, double width_m, const QColor& color) {
    painter.setPen(QPen(color, width_m * scale, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(place(a), place(b));
  };
  const QColor ghost = theme.dark ? theme.raised.lighter(125) : theme.line;
  if (whole_figure_) {
    painter.setPen(QPen(theme.line, 2.0));
    painter.drawLine(QPointF(8, origin.y() + 1), QPointF(width() - 8, origin.y() + 1));
    const QPointF knee(hip_.x() + 0.012, hip_.y() * 0.52);
    const QPointF ankle(hip_.x() - 0.01, 0.07);
    capsule(hip_, knee, 0.14, ghost);
    capsule(knee, ankle, 0.105, ghost);
    // The neck.
    capsule(head_, head_ - 0.24 * (head_ - hip_) / std::hypot(head_.x() - hip_.x(), head_.y() - hip_.y()), 0.075,
            ghost);
    capsule(ankle, QPointF(ankle.x() + 0.14, 0.045), 0.07, ghost);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ghost);
    const double r = 0.115 * scale;
    painter.drawEllipse(place(head_), r * 0.88, r);
    // A nose says which way it looks.
    const QPointF up = (head_ - hip_) / std::hypot(head_.x() - hip_.x(), head_.y() - hip_.y());
    const QPointF forward(up.y(), -up.x());
    painter.drawEllipse(place(head_ + 0.105 * forward), 0.022 * scale, 0.022 * scale);
  }
  // What is marked lies on top of the rest: it is what the picture is about.
  for (const bool marked : {false, true}) {
    for (const Bone& bone : bones_) {
      if (bone.marked == marked) {
        capsule(bone.from, bone.to, bone.width, marked ? theme.accent : ghost);
      }
    }
  }
  painter.setPen(QPen(theme.panel, 1.5));
  painter.setBrush(series_color(theme, 0));
  const double half = std::max(4.0, 0.022 * scale);
  for (const QPointF& sensor : sensors_) {
    const QPointF at = place(sensor);
    painter.drawRoundedRect(QRectF(at.x() - half, at.y() - half, 2 * half, 2 * half), 2, 2);
  }
}

}  // namespace limbwave::ui
