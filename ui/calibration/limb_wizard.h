/// The limb calibration wizard: pages over LimbWizardModel.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QVBoxLayout>
#include <QWidget>
#include <vector>

#include "calibration/limb_hold_page.h"
#include "calibration/limb_wizard_model.h"
#include "calibration/sensor_chooser.h"
#include "calibration/verdict_row.h"
#include "calibration/wizard_frame.h"

namespace limbwave::ui {

class LimbWizard : public QWidget {
  Q_OBJECT
 public:
  explicit LimbWizard(LimbWizardModel& model, QWidget* parent = nullptr);
  [[nodiscard]] WizardFrame* frame() const { return frame_; }
  [[nodiscard]] LimbHoldPage* hold_page() const { return hold_; }

 Q_SIGNALS:
  void device_wanted();
  /// The chosen sensors should first have their range calibrated.
  void range_wanted(const std::vector<int>& sensors);

 private:
  QWidget* make_choose_page();
  QWidget* make_prepare_page();
  QWidget* make_result_page();
  QWidget* make_check_page();
  void show_page();
  void refresh_choice();
  void refresh_prepare();
  void refresh_buttons();
  void refresh_results();
  void refresh_checks();
  void leave();

  LimbWizardModel& model_;
  WizardFrame* frame_;
  QComboBox* groups_ = nullptr;
  QLineEdit* wearer_ = nullptr;
  SensorChooser* chooser_ = nullptr;
  QWidget* range_warning_ = nullptr;
  QLabel* range_text_ = nullptr;
  QLabel* source_line_ = nullptr;
  QPushButton* open_device_ = nullptr;
  std::array<PosePicture*, 2> pictures_{};
  std::array<QLabel*, 2> captions_{};
  std::array<QLabel*, 2> instructions_{};
  QLabel* how_ = nullptr;
  QSpinBox* seconds_ = nullptr;
  LimbHoldPage* hold_ = nullptr;
  QLabel* summary_ = nullptr;
  QLabel* findings_ = nullptr;
  QVBoxLayout* rows_layout_ = nullptr;
  std::vector<VerdictRow*> rows_;
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
