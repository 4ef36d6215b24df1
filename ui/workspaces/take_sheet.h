/// What can be changed about the open take after it was recorded: its name, who wore it, which sensor was worn where.
#pragma once

#include "common/studio_context.h"
#include "workspaces/form_sheet.h"

namespace limbwave::ui {

class SensorTable;

class TakeSheet : public FormSheet {
  Q_OBJECT
 public:
  /// Only with an open take. What is accepted becomes one step of undo.
  TakeSheet(StudioContext& context, QWidget* parent);

 private:
  void check();
  void apply();
  StudioContext& context_;
  int opening_;
  QLineEdit* name_;
  QLineEdit* subject_;
  SensorTable* sensors_;
};

}  // namespace limbwave::ui
