/// What must be known of recordings before they become a take: its name, the rig, and who wore it.
#pragma once

#include "common/studio_context.h"
#include "workspaces/form_sheet.h"

class QComboBox;

namespace limbwave::ui {

class ImportSheet : public FormSheet {
  Q_OBJECT
 public:
  ImportSheet(StudioContext& context, const QStringList& files, QWidget* parent);
  [[nodiscard]] QString take_name() const;
  [[nodiscard]] QString rig() const;
  [[nodiscard]] QString subject() const;

 private:
  void check();
  StudioContext& context_;
  QLineEdit* name_ = nullptr;
  QComboBox* rig_;
  QLineEdit* subject_ = nullptr;
};

/// A free name for the take of a recording: "STEM", "STEM-2" ...
QString import_name(const QString& takes_folder, const QString& file);

}  // namespace limbwave::ui
