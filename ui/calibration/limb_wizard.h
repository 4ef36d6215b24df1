/// The limb calibration wizard: pages over LimbWizardModel.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <array>

#include "calibration/calibration_wizard.h"
#include "calibration/limb_hold_page.h"
#include "calibration/limb_wizard_model.h"
#include "calibration/sensor_chooser.h"

namespace limbwave::ui {

class LimbWizard : public CalibrationWizard {
  Q_OBJECT
 public:
  explicit LimbWizard(LimbWizardModel& model, QWidget* parent = nullptr);
  [[nodiscard]] LimbHoldPage* hold_page() const { return hold_; }

 Q_SIGNALS:
  /// The chosen sensors should first have their range calibrated.
  void range_wanted(const std::vector<int>& sensors);

 protected:
  [[nodiscard]] VerdictRowContent row_content(int i) const override;
  void refresh_own_results() override;
  void refresh_own_buttons() override;
  [[nodiscard]] QString movement_lost() const override;
  [[nodiscard]] bool on_verdicts() const override {
    return model_.page() == LimbPage::kResult || model_.page() == LimbPage::kCheck;
  }

 private:
  QWidget* make_choose_page();
  QWidget* make_prepare_page();
  QWidget* make_verdict_page();
  QWidget* make_check_page();
  void show_page();
  void refresh_choice();
  void refresh_prepare();
  void refresh_checks();

  LimbWizardModel& model_;
  QComboBox* groups_ = nullptr;
  QLineEdit* wearer_ = nullptr;
  SensorChooser* chooser_ = nullptr;
  QWidget* range_warning_ = nullptr;
  QLabel* range_text_ = nullptr;
  std::array<PosePicture*, 2> pictures_{};
  std::array<QLabel*, 2> captions_{};
  std::array<QLabel*, 2> instructions_{};
  QLabel* how_ = nullptr;
  QSpinBox* seconds_ = nullptr;
  LimbHoldPage* hold_ = nullptr;
  QPushButton* repeat_both_ = nullptr;
  std::array<QPushButton*, 2> check_buttons_{};
  QLabel* check_summary_ = nullptr;
  QLabel* check_text_ = nullptr;
  QVBoxLayout* check_layout_ = nullptr;
  QWidget* check_rows_ = nullptr;
};

/// What one outcome says, in the words of its row.
VerdictRowContent limb_row(const LimbOutcome& outcome, const body::Rig& rig, bool live);

}  // namespace limbwave::ui
