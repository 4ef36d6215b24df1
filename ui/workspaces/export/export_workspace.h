/// The Export workspace: which solve, as what, at which rate, where to; and what the written file holds.
#pragma once

#include "common/widgets.h"
#include "workspaces/export/export_plan.h"
#include "workspaces/export/export_preview.h"
#include "workspaces/solve/solve_model.h"
#include "workspaces/workspace.h"

class QComboBox;
class QDoubleSpinBox;
class QLineEdit;
class QProgressBar;
class QStackedWidget;

namespace limbwave::ui {

class ExportWorkspace : public Workspace {
  Q_OBJECT
 public:
  explicit ExportWorkspace(StudioContext& context, QWidget* parent = nullptr);
  void activate() override;
  void deactivate() override;
  [[nodiscard]] ExportPreview& preview() { return *preview_; }

 private:
  QWidget* make_form();
  QWidget* make_source_rows();
  QWidget* make_result();
  void follow();
  void show_take();
  void show_solves();
  void show_plan();
  void show_ranges();
  void browse();
  void start();
  void show_result(const Result<ExportResult>& result);
  [[nodiscard]] ExportPlan plan() const;
  [[nodiscard]] ExportFormat format() const;

  StudioContext& context_;
  SolveModel& model_;
  QStackedWidget* pages_ = nullptr;
  EmptyState* empty_ = nullptr;
  QPushButton* empty_button_ = nullptr;
  QComboBox *solves_ = nullptr, *formats_ = nullptr, *rates_ = nullptr, *units_ = nullptr, *ranges_ = nullptr;
  ExportPreview* preview_ = nullptr;
  QDoubleSpinBox* custom_rate_ = nullptr;
  QLineEdit* file_ = nullptr;
  QLabel *facts_ = nullptr, *problem_ = nullptr, *format_hint_ = nullptr, *step_ = nullptr;
  QPushButton *export_ = nullptr, *cancel_ = nullptr, *show_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QWidget* result_ = nullptr;
  QLabel *result_icon_ = nullptr, *result_text_ = nullptr, *result_detail_ = nullptr;
  QPointer<Job> job_;
  QString suggested_;  ///< The name we put there: replaced while the user has not typed another.
  std::filesystem::path written_;
};

}  // namespace limbwave::ui
