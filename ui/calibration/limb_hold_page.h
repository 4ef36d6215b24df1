/// Countdown and holding of one pose: to be read from two metres away, no key
/// needed.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "calibration/gauges.h"
#include "calibration/limb_wizard_model.h"
#include "calibration/pose_picture.h"

namespace limbwave::ui {

class LimbHoldPage : public QWidget {
  Q_OBJECT
 public:
  explicit LimbHoldPage(LimbWizardModel& model, QWidget* parent = nullptr);
  /// Another pose or another phase of it.
  void restart();
  void refresh();
  [[nodiscard]] QString big_text() const { return big_->text(); }
  [[nodiscard]] CountdownDial* dial() const { return dial_; }

 private:
  void show_countdown();
  void show_hold();
  void show_lost();
  [[nodiscard]] QString names(bool (*wanted)(const HolderState&)) const;
  LimbWizardModel& model_;
  PosePicture* picture_;
  QLabel* which_;
  QLabel* big_;
  QLabel* sentence_;
  CountdownDial* dial_;
  MovementBars* bars_;
  QPushButton* stillest_;
  QPushButton* leave_out_;
  int lost_ = -1;
};

}  // namespace limbwave::ui
