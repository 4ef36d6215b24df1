/// The recorded signal of the open take, drawn from its min/max pyramid: scrolls and zooms an hour as easily as a
/// second.
#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "common/time_model.h"
#include "plots/plot_geometry.h"
#include "plots/take_overview.h"

namespace limbwave::ui {

struct OverviewMark {
  double time_s = 0.0;
  QString text;
  bool problem = false;  ///< Dropped samples, clipping: drawn as a warning, not as a marker.
};

class OverviewView : public QWidget {
  Q_OBJECT
 public:
  explicit OverviewView(QWidget* parent = nullptr);
  /// Null: nothing to draw. All of it becomes visible.
  void set_overview(std::shared_ptr<const TakeOverview> overview);
  /// The overview that was set has become longer: what showed all of it goes on showing all of it.
  void grown();
  void set_marks(std::vector<OverviewMark> marks);
  [[nodiscard]] double visible_begin_s() const { return begin_s_; }
  [[nodiscard]] double visible_end_s() const { return end_s_; }
  void set_visible(double begin_s, double end_s);
  [[nodiscard]] QSize sizeHint() const override { return {600, 96}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {300, 80}; }

 Q_SIGNALS:
  void visible_changed(double begin_s, double end_s);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  [[nodiscard]] AxisMap time_axis() const;
  std::shared_ptr<const TakeOverview> overview_;
  std::vector<OverviewMark> marks_;
  double begin_s_ = 0.0, end_s_ = 0.0;
  double drag_x_ = 0.0;
  bool all_ = true;  ///< All of it is visible.
};

}  // namespace limbwave::ui
