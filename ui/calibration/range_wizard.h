/// The range calibration wizard: pages over RangeWizardModel.
#pragma once

#include <QLabel>
#include <QVBoxLayout>
#include <QWidget>
#include <vector>

#include "calibration/range_turn_page.h"
#include "calibration/range_wizard_model.h"
#include "calibration/sensor_chooser.h"
#include "calibration/verdict_row.h"
#include "calibration/wizard_frame.h"

namespace limbwave::ui {

class RangeWizard : public QWidget {
  Q_OBJECT
 public:
  explicit RangeWizard(RangeWizardModel& model, QWidget* parent = nullptr);
  [[nodiscard]] WizardFrame* frame() const { return frame_; }
  [[nodiscard]] RangeTurnPage* turn_page() const { return turn_; }

 Q_SIGNALS:
  /// No signal: the technician wants to open a device.
  void device_wanted();

 private:
  QWidget* make_choose_page();
  QWidget* make_instruction_page();
  QWidget* make_result_page();
  void show_page();
  void refresh_buttons();
  void refresh_chooser();
  void refresh_results();
  void leave();

  RangeWizardModel& model_;
  WizardFrame* frame_;
  SensorChooser* chooser_ = nullptr;
  QLabel* source_line_ = nullptr;
  QPushButton* open_device_ = nullptr;
  RangeTurnPage* turn_ = nullptr;
  QLabel* summary_ = nullptr;
  QVBoxLayout* rows_layout_ = nullptr;
  std::vector<VerdictRow*> rows_;
};

/// What one outcome says, in the words of its row.
VerdictRowContent range_row(const RangeOutcome& outcome, const body::Rig& rig, bool live);

}  // namespace limbwave::ui
