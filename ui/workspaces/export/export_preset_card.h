/// Which program the file is for, what that means in plain words, and its format.
#pragma once

#include "common/widgets.h"
#include "workspaces/export/export_model.h"

class QComboBox;

namespace limbwave::ui {

class ExportPresetCard : public Card {
  Q_OBJECT
 public:
  explicit ExportPresetCard(ExportModel& model, QWidget* parent = nullptr);

 private:
  QToolButton* make_menu();
  void show_choices();
  /// Opens the user's folder of such files, which is made when it is not there.
  void open_folder(const char* name);

  ExportModel& model_;
  QComboBox *presets_, *formats_;
  QLabel *comment_, *facts_, *format_hint_;
};

}  // namespace limbwave::ui
