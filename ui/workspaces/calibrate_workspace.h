/// Calibrate: the overview of all sensors, and the two wizards in its place
/// while they run.
#pragma once

#include <QStackedWidget>
#include <memory>

#include "calibration/limb_wizard.h"
#include "calibration/range_wizard.h"
#include "calibration/stretch_page.h"
#include "common/widgets.h"
#include "workspaces/calibrate_overview.h"
#include "workspaces/workspace.h"

namespace limbwave::ui {

class CalibrateWorkspace : public Workspace {
  Q_OBJECT
 public:
  /// `context` outlives this. Without `source` it is the studio's live capture.
  CalibrateWorkspace(StudioContext& context, take::CalibrationLibrary library,
                     std::unique_ptr<CalibrationSource> source = nullptr, QWidget* parent = nullptr);
  ~CalibrateWorkspace() override;

  void activate() override;
  QWidget* create_inspector() override;
  /// "range", "mounting", "recording", "sensor:2".
  void reveal(const QString& topic) override;

  [[nodiscard]] CalibrationDesk& desk() { return *desk_; }
  [[nodiscard]] RangeWizardModel& range_model() { return *range_model_; }
  [[nodiscard]] LimbWizardModel& limb_model() { return *limb_model_; }
  [[nodiscard]] StretchModel& stretch_model() { return *stretch_model_; }
  [[nodiscard]] StretchPage* stretch_page() const { return stretch_page_; }
  [[nodiscard]] RangeWizard* range_wizard() const { return range_wizard_; }
  [[nodiscard]] LimbWizard* limb_wizard() const { return limb_wizard_; }

 private:
  void show_overview();
  void start_range(const std::vector<int>& sensors);
  void start_limb(int sensor, bool only);
  void start_stretch();
  void leave_wizard();
  void tell_saved(int count, const QString& what, const WizardModel& model);

  StudioContext& context_;
  std::unique_ptr<CalibrationSource> source_;
  std::unique_ptr<CalibrationDesk> desk_;
  std::unique_ptr<RangeWizardModel> range_model_;
  std::unique_ptr<LimbWizardModel> limb_model_;
  std::unique_ptr<StretchModel> stretch_model_;
  QStackedWidget* pages_;
  EmptyState* empty_;
  CalibrateOverview* overview_;
  RangeWizard* range_wizard_;
  LimbWizard* limb_wizard_;
  StretchPage* stretch_page_;
  bool just_saved_ = false;
};

/// Row of the workspace table.
WorkspaceEntry calibrate_entry();

}  // namespace limbwave::ui
