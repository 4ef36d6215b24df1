/// The range calibration wizard: pages over RangeWizardModel.
#pragma once

#include "calibration/calibration_wizard.h"
#include "calibration/range_turn_page.h"
#include "calibration/range_wizard_model.h"
#include "calibration/sensor_chooser.h"

namespace limbwave::ui {

class RangeWizard : public CalibrationWizard {
  Q_OBJECT
 public:
  explicit RangeWizard(RangeWizardModel& model, QWidget* parent = nullptr);
  [[nodiscard]] RangeTurnPage* turn_page() const { return turn_; }

 protected:
  [[nodiscard]] VerdictRowContent row_content(int i) const override;
  void refresh_own_results() override;
  void refresh_own_buttons() override;
  [[nodiscard]] QString movement_lost() const override;
  [[nodiscard]] bool on_verdicts() const override { return model_.page() == RangePage::kResult; }

 private:
  QWidget* make_choose_page();
  QWidget* make_instruction_page();
  void show_page();
  void refresh_chooser();

  RangeWizardModel& model_;
  SensorChooser* chooser_ = nullptr;
  RangeTurnPage* turn_ = nullptr;
};

/// What one outcome says, in the words of its row.
VerdictRowContent range_row(const RangeOutcome& outcome, const body::Rig& rig, bool live);

}  // namespace limbwave::ui
