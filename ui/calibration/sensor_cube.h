/// The sensor as a box with its axes on the faces, as it is held now, and the side that should come to the top.
#pragma once

#include <Eigen/Geometry>
#include <QWidget>
#include <optional>

namespace limbwave::ui {

class SensorCube : public QWidget {
  Q_OBJECT
 public:
  explicit SensorCube(QWidget* parent = nullptr);
  /// Direction that points up, sensor frame; gravity says nothing about the heading, so the box is turned by the
  /// shortest arc from how it lay before.
  void set_up(const Eigen::Vector3d& up_S);
  /// Direction of the box that should come to the top; empty: none.
  void set_wanted(const std::optional<Eigen::Vector3d>& wanted_S);
  /// A fixed picture.
  void set_orientation(const Eigen::Quaterniond& R_WS);
  [[nodiscard]] const Eigen::Quaterniond& orientation() const { return R_WS_; }
  [[nodiscard]] QSize sizeHint() const override { return {200, 200}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {72, 72}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] QPointF place(const Eigen::Vector3d& v_W) const;
  void paint_face(QPainter& painter, int axis, double sign) const;
  void paint_arrow(QPainter& painter, const Eigen::Vector3d& from_W, const Eigen::Vector3d& to_W,
                   const QColor& color) const;
  Eigen::Quaterniond R_WS_ = Eigen::Quaterniond::Identity();
  std::optional<Eigen::Vector3d> wanted_S_;
};

}  // namespace limbwave::ui
