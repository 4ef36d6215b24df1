/// Calibrating from a recording: choose the take, the movement and its stretch,
/// then look at the verdict.
#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QWidget>
#include <array>

#include "calibration/stretch_model.h"
#include "calibration/stretch_plot.h"
#include "common/widgets.h"

class QMenu;

namespace limbwave::ui {

class StretchPage : public QWidget {
  Q_OBJECT
 public:
  explicit StretchPage(StretchModel& model, QWidget* parent = nullptr);
  [[nodiscard]] StretchPlot* plot() const { return plot_; }

 Q_SIGNALS:
  void left();

 private:
  /// What one stretch is edited with.
  struct Row {
    QWidget* widget;
    QLabel* title;
    QComboBox* named;
    QDoubleSpinBox* begin;
    QDoubleSpinBox* end;
    QLabel* length;
    QPushButton* visible;
  };
  QWidget* make_head();
  Row make_row(int i);
  void fill_takes();
  void browse();
  void refresh();
  void refresh_stretches();
  void refresh_row(int i);
  void choose_named(int i, int entry);
  void use_named(int named);

  StretchModel& model_;
  ElidedLabel* take_;
  QPushButton* other_take_;
  QMenu* takes_;
  QComboBox* procedure_;
  QComboBox* sensor_;
  StretchPlot* plot_;
  std::array<Row, 2> rows_{};
  QLabel* obstacle_;
  QPushButton* compute_;
  int gesture_ = -1;  ///< Of the newest drag.
  int active_ = 0;    ///< The stretch that a click on a named segment changes.
};

}  // namespace limbwave::ui
