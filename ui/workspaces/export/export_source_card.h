/// Which motion is exported, and who else is in the file.
#pragma once

#include "common/widgets.h"
#include "workspaces/export/export_model.h"

class QComboBox;
class QListWidget;

namespace limbwave::ui {

class ExportSourceCard : public Card {
  Q_OBJECT
 public:
  ExportSourceCard(StudioContext& context, ExportModel& model, QWidget* parent = nullptr);

  /// Asks for an animation file and opens it.
  void choose_animation(bool as_actor = false);

 private:
  QWidget* make_others();
  void show_sources();
  void choose_take();

  StudioContext& context_;
  ExportModel& model_;
  QComboBox* source_;
  QWidget* others_box_ = nullptr;
  QListWidget* others_ = nullptr;
  QPushButton* remove_ = nullptr;
};

/// "Animations (*.bvh *.fbx ...)" for file dialogs.
QString animation_filter();

}  // namespace limbwave::ui
