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
  bool problem = false;     ///< Dropped samples, clipping: drawn as a warning, not as a marker.
  std::int64_t number = 0;  ///< Of a marker: it can be selected and moved. 0: it cannot.
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
  /// 0: none.
  void set_selected_mark(std::int64_t number);
  /// Where a mark is drawn, pixels from the left; while it is dragged, where it is dragged to.
  [[nodiscard]] double mark_x(std::int64_t number) const;
  [[nodiscard]] double visible_begin_s() const { return begin_s_; }
  [[nodiscard]] double visible_end_s() const { return end_s_; }
  void set_visible(double begin_s, double end_s);
  /// Of a driver box: the wire whose row is marked; -1: none.
  void set_selected_wire(int wire);
  /// The wire whose row is at a height, pixels; -1: none.
  [[nodiscard]] int wire_at(double y) const;
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 Q_SIGNALS:
  void visible_changed(double begin_s, double end_s);
  void mark_selected(std::int64_t number);
  /// It was dragged, or moved by a key: once at the end of the gesture.
  void mark_moved(std::int64_t number, double time_s);
  void mark_removed(std::int64_t number);
  void wire_clicked(int wire);               ///< Of a driver box.
  void mark_activated(std::int64_t number);  ///< Double click or Enter: its name is to be changed.
  void mark_wanted(double time_s);           ///< Double click beside the marks' band's marks.

 protected:
  void paintEvent(QPaintEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  [[nodiscard]] AxisMap time_axis() const;
  std::shared_ptr<const TakeOverview> overview_;
  std::vector<OverviewMark> marks_;
  double begin_s_ = 0.0, end_s_ = 0.0;
  [[nodiscard]] const OverviewMark* mark_at(const QPointF& position) const;
  [[nodiscard]] const OverviewMark* selected_mark() const;
  [[nodiscard]] double shown_time(const OverviewMark& mark) const;
  void paint_marks(QPainter& painter, const QRectF& band) const;
  void paint_signal(QPainter& painter, const QRectF& band) const;
  void paint_wires(QPainter& painter) const;
  [[nodiscard]] bool has_wires() const { return overview_ && overview_->box.wires() > 0; }
  [[nodiscard]] QRectF wire_row(std::size_t wire) const;
  bool mark_key(QKeyEvent* event);

  double drag_x_ = 0.0;
  std::int64_t selected_ = 0;
  int selected_wire_ = -1;
  std::int64_t dragged_ = 0;   ///< The marker under the pressed button.
  double dragged_to_s_ = 0.0;  ///< Where it would go.
  bool drag_moved_ = false;
  bool all_ = true;  ///< All of it is visible.
};

}  // namespace limbwave::ui
