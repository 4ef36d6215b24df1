/// The sphere of directions that a sensor was held in, as two equal-area discs that touch at the +x rim.
#pragma once

#include <Eigen/Core>
#include <QPainterPath>
#include <QWidget>
#include <array>
#include <deque>
#include <optional>

#include "calibrate/sphere_coverage.h"

namespace limbwave::ui {

/// A place on one of the two discs; both have radius 1, y points up.
struct DiscPoint {
  int disc = 0;  ///< 0: the half in which z is positive, seen from +z; 1: the other, seen from −z.
  double x = 0.0, y = 0.0;
};

/// Lambert's azimuthal equal-area projection of each half. `direction` must not be zero.
DiscPoint disc_point(const Eigen::Vector3d& direction);
/// The outline of one cell of SphereCoverage on its disc, closed.
std::vector<DiscPoint> cell_outline(int cell);

class SphereMap : public QWidget {
  Q_OBJECT
 public:
  using Cells = std::array<bool, calibrate::SphereCoverage::kCells>;

  /// `small` leaves out words and marks, for a row of a list.
  explicit SphereMap(bool small = false, QWidget* parent = nullptr);
  void set_visited(const Cells& visited);
  /// The direction that points up now, and the one that should next; empty: none.
  void set_directions(const std::optional<Eigen::Vector3d>& now, const std::optional<Eigen::Vector3d>& wanted);
  void clear_trail() { trail_.clear(); }
  [[nodiscard]] QSize sizeHint() const override { return small_ ? QSize(88, 44) : QSize(640, 340); }
  [[nodiscard]] QSize minimumSizeHint() const override { return small_ ? QSize(72, 36) : QSize(360, 200); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] QPointF place(const DiscPoint& point) const;
  [[nodiscard]] double radius() const;
  void paint_cells(QPainter& painter) const;
  void paint_words(QPainter& painter) const;
  void paint_directions(QPainter& painter) const;

  bool small_;
  Cells visited_{};
  std::optional<Eigen::Vector3d> now_, wanted_;
  std::deque<Eigen::Vector3d> trail_;
};

}  // namespace limbwave::ui
