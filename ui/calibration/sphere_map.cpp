#include "calibration/sphere_map.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "common/theme.h"

namespace limbwave::ui {
namespace {

constexpr std::size_t kTrail = 45;

// Bands of SphereCoverage from +z down: cells in each, and the z at which it ends.
constexpr std::array<int, 6> kBandCells{4, 8, 12, 12, 8, 4};
constexpr std::array<double, 7> kBandEdges{1.0, 5.0 / 6.0, 0.5, 0.0, -0.5, -5.0 / 6.0, -1.0};

Eigen::Vector3d on_sphere(double z, double azimuth) {
  const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
  return {r * std::cos(azimuth), r * std::sin(azimuth), z};
}

}  // namespace

DiscPoint disc_point(const Eigen::Vector3d& direction) {
  const Eigen::Vector3d d = direction.normalized();
  const double planar = std::hypot(d.x(), d.y());
  const double r = std::sqrt(std::max(0.0, 1.0 - std::abs(d.z())));
  const double scale = planar > 1e-12 ? r / planar : 0.0;
  // Seen from below x runs the other way, so that +x of both discs is where they touch.
  return d.z() >= 0.0 ? DiscPoint{0, d.x() * scale, d.y() * scale} : DiscPoint{1, -d.x() * scale, d.y() * scale};
}

std::vector<DiscPoint> cell_outline(int cell) {
  const Eigen::Vector3d centre = calibrate::SphereCoverage::centre(cell);
  std::size_t band = 0;
  while (band < 5 && centre.z() < kBandEdges.at(band + 1)) {
    ++band;
  }
  const double half = kPi / kBandCells.at(band);
  const double middle = std::atan2(centre.y(), centre.x());
  // Just off the equator, so that both halves keep their own rim.
  const auto edge = [&](double z) { return centre.z() > 0.0 ? std::max(z, 1e-9) : std::min(z, -1e-9); };
  constexpr int kSteps = 12;
  std::vector<DiscPoint> outline;
  for (int i = 0; i <= kSteps; ++i) {
    outline.push_back(disc_point(on_sphere(edge(kBandEdges.at(band)), middle - half + 2.0 * half * i / kSteps)));
  }
  for (int i = kSteps; i >= 0; --i) {
    outline.push_back(disc_point(on_sphere(edge(kBandEdges.at(band + 1)), middle - half + 2.0 * half * i / kSteps)));
  }
  return outline;
}

SphereMap::SphereMap(bool small, QWidget* parent) : QWidget(parent), small_(small) {
  setObjectName(QStringLiteral("sphere_map"));
  setAccessibleName(tr("Directions that were visited"));
  if (small) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  } else {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  }
}

void SphereMap::set_visited(const Cells& visited) {
  visited_ = visited;
  const auto count = std::count(visited.begin(), visited.end(), true);
  setAccessibleDescription(tr("%1 of %2 directions").arg(count).arg(visited.size()));
  update();
}

void SphereMap::set_directions(const std::optional<Eigen::Vector3d>& now,
                               const std::optional<Eigen::Vector3d>& wanted) {
  now_ = now;
  wanted_ = wanted;
  if (now && now->norm() > 0.0) {
    trail_.push_back(*now);
    if (trail_.size() > kTrail) {
      trail_.pop_front();
    }
  }
  update();
}

double SphereMap::radius() const {
  const double margin = small_ ? 1.0 : 26.0;
  return std::max(8.0, std::min(width() / 4.0 - margin, height() / 2.0 - margin));
}

QPointF SphereMap::place(const DiscPoint& point) const {
  const double r = radius();
  const double gap = small_ ? 1.0 : 24.0;
  const double x = width() / 2.0 + (point.disc == 0 ? -(r + gap) : r + gap);
  return {x + r * point.x, height() / 2.0 - r * point.y};
}

void SphereMap::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  paint_cells(painter);
  if (!small_) {
    paint_words(painter);
    paint_directions(painter);
  }
}

void SphereMap::paint_cells(QPainter& painter) const {
  const ThemeColors& theme = theme_colors(palette());
  QColor fill = theme.good;
  fill.setAlphaF(small_ ? 0.9F : 0.75F);
  for (int cell = 0; cell < calibrate::SphereCoverage::kCells; ++cell) {
    QPolygonF polygon;
    for (const DiscPoint& point : cell_outline(cell)) {
      polygon << place(point);
    }
    const bool visited = visited_.at(static_cast<std::size_t>(cell));
    painter.setPen(QPen(visited ? theme.panel : theme.line, 1.0));
    painter.setBrush(visited ? QBrush(fill) : QBrush(theme.base));
    painter.drawPolygon(polygon);
    // Shape says it too: what is missing carries a small open dot.
    if (!visited && !small_) {
      painter.setPen(QPen(theme.dim, 1.0));
      painter.setBrush(Qt::NoBrush);
      painter.drawEllipse(place(disc_point(calibrate::SphereCoverage::centre(cell))), 2.5, 2.5);
    }
  }
}

void SphereMap::paint_words(QPainter& painter) const {
  const ThemeColors& theme = theme_colors(palette());
  const auto write = [&](const QPointF& at, const QString& text, const QColor& color) {
    painter.setPen(color);
    painter.drawText(QRectF(at.x() - 60.0, at.y() - 10.0, 120.0, 20.0), Qt::AlignCenter, text);
  };
  const QString minus(QChar(0x2212));
  for (int disc = 0; disc < 2; ++disc) {
    const double out = 1.0 + 13.0 / radius();
    const QString right = disc == 0 ? QStringLiteral("+x") : minus + QStringLiteral("x");
    const QString left = disc == 0 ? minus + QStringLiteral("x") : QStringLiteral("+x");
    write(place({disc, out, 0.0}), right, theme.dim);
    write(place({disc, -out, 0.0}), left, theme.dim);
    write(place({disc, 0.0, out}), QStringLiteral("+y"), theme.dim);
    write(place({disc, 0.0, -out}), minus + QStringLiteral("y"), theme.dim);
    painter.setPen(QPen(theme.text, 1.0));
    QFont bold = font();
    bold.setBold(true);
    painter.setFont(bold);
    write(place({disc, 0.0, 0.0}), disc == 0 ? QStringLiteral("+z") : minus + QStringLiteral("z"), theme.text);
    painter.setFont(font());
  }
}

void SphereMap::paint_directions(QPainter& painter) const {
  const ThemeColors& theme = theme_colors(palette());
  for (std::size_t i = 1; i < trail_.size(); ++i) {
    const DiscPoint a = disc_point(trail_[i - 1]);
    const DiscPoint b = disc_point(trail_[i]);
    if (a.disc == b.disc) {
      QColor color = theme.text;
      color.setAlphaF(0.7F * static_cast<float>(i) / static_cast<float>(trail_.size()));
      painter.setPen(QPen(color, 1.5));
      painter.drawLine(place(a), place(b));
    }
  }
  if (wanted_) {
    const QPointF at = place(disc_point(*wanted_));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.accent, 3.0));
    painter.drawEllipse(at, 13.0, 13.0);
    painter.drawEllipse(at, 5.0, 5.0);
  }
  if (now_ && now_->norm() > 0.0) {
    const QPointF at = place(disc_point(*now_));
    painter.setPen(QPen(theme.window, 2.0));
    painter.setBrush(theme.text);
    painter.drawEllipse(at, 8.0, 8.0);
  }
}

}  // namespace limbwave::ui
