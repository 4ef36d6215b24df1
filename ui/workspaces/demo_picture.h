/// The picture of a demo take: the figure at several instants of its motion, drawn from joint angles.
#pragma once

#include <QPointF>
#include <QPushButton>
#include <QString>
#include <array>

namespace limbwave::ui {

/// Shoulder, elbow and wrist of the moving arm in units of the figure's height, y down, at `phase` 0..1 of a motion of
/// the simulator; an unknown motion raises the arm.
std::array<QPointF, 3> demo_arm(const QString& motion, double phase);

/// A button with that picture and the name of the motion.
class DemoButton : public QPushButton {
  Q_OBJECT
 public:
  DemoButton(const QString& motion, const QString& title, const QString& hint, QWidget* parent = nullptr);
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString motion_, title_, hint_;
};

}  // namespace limbwave::ui
