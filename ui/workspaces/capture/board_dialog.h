/// Which board hangs on the device: its name, where its sensors are worn, and their serials where they have any.
/// Calibrations are kept by them.
#pragma once

#include "take/board_book.h"
#include "workspaces/form_sheet.h"

namespace limbwave::ui {

class SensorTable;

class BoardDialog : public FormSheet {
  Q_OBJECT
 public:
  /// `rig` as its file has it.
  BoardDialog(const QString& device_title, const body::Rig& rig, const take::Board& board, QWidget* parent);
  [[nodiscard]] take::Board board() const;

 private:
  std::vector<std::string> own_places_;
  QLineEdit* name_;
  SensorTable* sensors_;
};

}  // namespace limbwave::ui
