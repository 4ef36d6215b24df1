/// One sensor's three axes over a whole take, the take's named segments above
/// them, and the stretches that are chosen: dragged as a whole or at their
/// ends. Wheel: zoom; drag beside a stretch: move; double click: show all.
#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "calibration/take_segments.h"
#include "plots/plot_geometry.h"
#include "solve/decoded_take.h"

namespace limbwave::ui {

class StretchPlot : public QWidget {
  Q_OBJECT
 public:
  struct Chosen {
    QString title;
    Stretch stretch;
  };

  explicit StretchPlot(QWidget* parent = nullptr);
  /// Null readings: `message` is shown instead.
  void set_take(std::shared_ptr<const take::Take> take, std::shared_ptr<const solve::DecodedTake> decoded,
                const QString& message);
  void set_sensor(int sensor);
  void set_named(std::vector<NamedStretch> named);
  void set_chosen(std::vector<Chosen> chosen);
  [[nodiscard]] Stretch visible() const { return visible_; }
  void set_visible(Stretch stretch);
  /// Of a time, pixels from the left.
  [[nodiscard]] double x_of(double time_s) const { return axis().to_pixel(time_s); }

  [[nodiscard]] QSize sizeHint() const override { return {800, 280}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {320, 160}; }

 Q_SIGNALS:
  void drag_begun();  ///< All of `stretch_dragged` until the next one are one drag.
  void stretch_dragged(int i, limbwave::ui::Stretch stretch);
  void named_clicked(int named);
  void visible_changed(limbwave::ui::Stretch visible);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  enum class Part { kNone, kPan, kBegin, kEnd, kWhole };
  struct Grip {
    Part part = Part::kNone;
    int i = -1;
  };
  [[nodiscard]] AxisMap axis() const;
  [[nodiscard]] double duration_s() const;
  [[nodiscard]] Grip grip_at(const QPointF& position) const;
  [[nodiscard]] int named_at(const QPointF& position) const;
  void paint_named(QPainter& painter) const;
  void paint_curves(QPainter& painter, const QRectF& area) const;
  void paint_chosen(QPainter& painter, const QRectF& area) const;
  void fill_curves();

  std::shared_ptr<const take::Take> take_;
  std::shared_ptr<const solve::DecodedTake> decoded_;
  QString message_;
  int sensor_ = 0;
  std::vector<NamedStretch> named_;
  std::vector<Chosen> chosen_;
  Stretch visible_;
  std::vector<double> times_;
  std::array<std::vector<double>, 3> curves_;  ///< In nominal g.
  Grip grip_;
  double grip_s_ = 0.0;  ///< Time under the pressed button.
};

}  // namespace limbwave::ui
