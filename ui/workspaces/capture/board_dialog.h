/// Which board hangs on the device: its name, and the serials of its sensors where they have any. Calibrations are kept
/// by them.
#pragma once

#include <QDialog>
#include <vector>

#include "take/board_book.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace limbwave::ui {

class BoardDialog : public QDialog {
  Q_OBJECT
 public:
  /// `rig` as its file has it.
  BoardDialog(const QString& device_title, const body::Rig& rig, const take::Board& board, QWidget* parent);
  [[nodiscard]] take::Board board() const;

 private:
  void check();
  QLineEdit* name_;
  std::vector<QLineEdit*> serials_;
  QLabel* problem_;
  QPushButton* keep_;
};

}  // namespace limbwave::ui
