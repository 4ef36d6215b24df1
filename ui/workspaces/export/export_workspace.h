/// The Export workspace: which motion, for which program, how and where to; and what is going to be in the file.
#pragma once

#include "workspaces/export/export_model.h"
#include "workspaces/export/export_preview.h"
#include "workspaces/workspace.h"

class QPushButton;
class QStackedWidget;

namespace limbwave::ui {

class EmptyState;
class ExportSourceCard;

class ExportWorkspace : public Workspace {
  Q_OBJECT
 public:
  explicit ExportWorkspace(StudioContext& context, QWidget* parent = nullptr);
  void activate() override;
  void deactivate() override;
  /// "animation:FILE" opens an animation file.
  void reveal(const QString& topic) override;
  [[nodiscard]] ExportPreview& preview() { return *preview_; }
  [[nodiscard]] ExportModel& model() { return *model_; }

 private:
  QWidget* make_page();
  void show_state();

  StudioContext& context_;
  SolveModel& solves_;
  ExportModel* model_;
  QStackedWidget* pages_ = nullptr;
  EmptyState* empty_ = nullptr;
  QPushButton *open_button_ = nullptr, *solve_button_ = nullptr;
  ExportSourceCard* source_ = nullptr;
  ExportPreview* preview_ = nullptr;
};

}  // namespace limbwave::ui
