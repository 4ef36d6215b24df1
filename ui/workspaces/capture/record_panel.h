/// Recording: the time in figures that can be read from two metres away, the button, the take's name, the disk.
#pragma once

#include <QWidget>

#include "common/studio_context.h"
#include "common/widgets.h"
#include "workspaces/capture/capture_model.h"

class QLineEdit;

namespace limbwave::ui {

class RecordPanel : public Card {
  Q_OBJECT
 public:
  RecordPanel(StudioContext& context, CaptureModel& model, QWidget* parent = nullptr);
  void focus_record();

 private:
  void refresh();
  void refresh_time();
  void choose_folder();
  StudioContext& context_;
  CaptureModel& model_;
  QLabel* time_;
  QLabel* state_;
  QPushButton* record_;
  QPushButton* later_;
  QLineEdit* subject_;
  QLineEdit* name_;
  QLabel* name_problem_;
  QLabel* calibration_;
  ElidedLabel* folder_;
  QLabel* disk_;
};

}  // namespace limbwave::ui
