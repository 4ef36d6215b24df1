/// What must be known of recordings before they become a take: its name, the rig, and who wore it.
#pragma once

#include <QDialog>

#include "common/studio_context.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace limbwave::ui {

class ImportSheet : public QDialog {
  Q_OBJECT
 public:
  ImportSheet(StudioContext& context, const QStringList& files, QWidget* parent);
  [[nodiscard]] QString take_name() const;
  [[nodiscard]] QString rig() const;
  [[nodiscard]] QString subject() const;

 private:
  void check();
  StudioContext& context_;
  QLineEdit* name_;
  QComboBox* rig_;
  QLineEdit* subject_;
  QLabel* problem_;
  QPushButton* import_ = nullptr;
};

/// A free name for the take of a recording: "STEM", "STEM-2" ...
QString import_name(const QString& takes_folder, const QString& file);

}  // namespace limbwave::ui
