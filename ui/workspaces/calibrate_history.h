/// The inspector of Calibrate: what the library remembers of the selected sensor, newest first, and where it is.
#pragma once

#include <QLabel>
#include <QVBoxLayout>
#include <QWidget>
#include <functional>

#include "calibration/calibration_desk.h"
#include "calibration/calibration_words.h"

namespace limbwave::ui {

class CalibrateHistory : public QWidget {
  Q_OBJECT
 public:
  explicit CalibrateHistory(CalibrationDesk& desk, QWidget* parent = nullptr);
  void refresh();

 private:
  void add_entry(const CalibrationState& state, bool in_use, std::function<void()> use);
  CalibrationDesk& desk_;
  QLabel* title_;
  QLabel* serial_;
  QVBoxLayout* entries_;
  QWidget* list_ = nullptr;
  QVBoxLayout* list_layout_ = nullptr;
  QLabel* folder_;
};

}  // namespace limbwave::ui
