/// Markers: set by key while recording; those of the open take otherwise.
#pragma once

#include "common/studio_context.h"
#include "common/widgets.h"
#include "workspaces/capture/capture_model.h"

class QListWidget;

namespace limbwave::ui {

class MarkerPanel : public Card {
  Q_OBJECT
 public:
  MarkerPanel(StudioContext& context, CaptureModel& model, QWidget* parent = nullptr);

 private:
  void refresh();
  void refresh_button();
  StudioContext& context_;
  CaptureModel& model_;
  QListWidget* list_;
  QPushButton* mark_;
  QLabel* hint_;
};

}  // namespace limbwave::ui
