/// Curves under the figure: for every sensor the elevation of its bone and how far its reading was trusted.
#pragma once

#include <QPixmap>
#include <QScrollBar>
#include <QWidget>
#include <vector>

#include "common/time_model.h"
#include "timeline/timeline_geometry.h"
#include "workspaces/solve/solve_run.h"

namespace limbwave::ui {

/// Shares playhead and visible range with the timeline; click and drag scrub, the wheel zooms. An hour is drawn as fast
/// as a second: whatever the range, a paint looks at a few values per pixel. More sensors than there is room for
/// scroll: by the bar, or the wheel over names and values.
class CurvesPanel : public QWidget {
  Q_OBJECT
 public:
  explicit CurvesPanel(TimeModel& time, QWidget* parent = nullptr);

  /// `times`: of the values, seconds in the clip, increasing.
  void set_curves(SensorCurves curves, std::vector<double> times);
  /// Highlights the rows of a segment; -1: none.
  void select_segment(int segment);

  [[nodiscard]] QSize sizeHint() const override { return {720, 212}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {320, 132}; }

 Q_SIGNALS:
  void segment_clicked(int segment);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  [[nodiscard]] std::size_t rows() const { return curves_ ? curves_->size() : 0; }
  /// Without the scroll bar.
  [[nodiscard]] double room() const;
  [[nodiscard]] double row_height() const;
  [[nodiscard]] TimeScale scale() const;
  [[nodiscard]] QRectF row_rect(std::size_t row) const;
  /// The value whose time is nearest to the playhead; -1 without values.
  [[nodiscard]] std::ptrdiff_t index_at(double time_s) const;
  void fit_bar();
  void redraw();
  void draw(QPainter& painter) const;
  void draw_row(QPainter& painter, std::size_t row) const;
  void draw_curve(QPainter& painter, const SensorCurve& curve, const QRectF& area) const;
  void draw_trust(QPainter& painter, const SensorCurve& curve, const QRectF& area) const;
  void draw_values(QPainter& painter) const;

  TimeModel& time_;
  QScrollBar* bar_;
  SensorCurves curves_;
  std::vector<double> times_;
  int selected_ = -1;
  QPixmap picture_;  ///< Everything but the playhead and its values.
};

/// A colour of an even map from dark violet (0) over green to yellow (1).
QColor confidence_color(double fraction);

}  // namespace limbwave::ui
