/// What is captured: device and rig.
#pragma once

#include <QWidget>

#include "common/studio_context.h"
#include "workspaces/capture/capture_model.h"

class QComboBox;
class QMenu;
class QToolButton;

namespace limbwave::ui {

class SourceBar : public QWidget {
  Q_OBJECT
 public:
  SourceBar(StudioContext& context, CaptureModel& model, QWidget* parent = nullptr);
  void focus_devices();

 private:
  void refresh();
  void refresh_format();
  void fill_format_menu();
  void fill();
  void ask_port();
  void edit_board(const body::Rig& rig, const take::Board& board);
  StudioContext& context_;
  CaptureModel& model_;
  QComboBox* devices_;
  QComboBox* rigs_;
  QToolButton* refresh_;
  QToolButton* format_;
  QMenu* format_menu_;
  QToolButton* board_;
  QStringList listed_devices_;  ///< As the box has them.
  QStringList listed_rigs_;
};

}  // namespace limbwave::ui
