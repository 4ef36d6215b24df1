/// What a driver box says of itself, and what it must be told: the air, how tall the wearer is, and where the delays of
/// its sources are known from.
#pragma once

#include "common/studio_context.h"
#include "common/widgets.h"
#include "workspaces/capture/capture_model.h"

class QComboBox;
class QDoubleSpinBox;

namespace limbwave::ui {

class BoxPanel : public Card {
  Q_OBJECT
 public:
  BoxPanel(StudioContext& context, CaptureModel& model, QWidget* parent = nullptr);
  /// The sources are as this take of the same box has them. Read in a job; says so when it has nothing for this rig.
  void use_take(const QString& folder);

 private:
  void refresh();
  void refresh_setup();
  void apply();
  void choose_sources(int index);
  StudioContext& context_;
  CaptureModel& model_;
  QLabel *state_, *figures_, *advice_;
  QDoubleSpinBox *temperature_, *humidity_, *height_;
  QComboBox* sources_;
};

}  // namespace limbwave::ui
