/// What a driver box says of itself, and what it must be told: the air, and how tall the wearer is.
#pragma once

#include "common/studio_context.h"
#include "common/widgets.h"
#include "workspaces/capture/capture_model.h"

class QDoubleSpinBox;

namespace limbwave::ui {

class BoxPanel : public Card {
  Q_OBJECT
 public:
  BoxPanel(StudioContext& context, CaptureModel& model, QWidget* parent = nullptr);

 private:
  void refresh();
  void refresh_setup();
  void apply();
  StudioContext& context_;
  CaptureModel& model_;
  QLabel *state_, *figures_, *advice_;
  QDoubleSpinBox *temperature_, *humidity_, *height_;
};

}  // namespace limbwave::ui
