/// Inspector of how the take is solved: smoothing, calibration, and the button that does it.
#pragma once

#include "common/widgets.h"
#include "workspaces/solve/solve_model.h"

class QComboBox;
class QSlider;
class QSpinBox;

namespace limbwave::ui {

class BodyChoiceForm;

class SettingsCard : public Card {
  Q_OBJECT
 public:
  explicit SettingsCard(SolveModel& model, QWidget* parent = nullptr);

 private:
  std::vector<QWidget*> for_inclination_;  ///< Hidden where the body filter solves.
  void build();
  void show_settings();
  void show_state();
  void set_strength(int milliseconds, int gesture);

  SolveModel& model_;
  bool showing_ = false;
  int gesture_ = kNoGesture;
  QComboBox *smoothing_ = nullptr, *calibration_ = nullptr;
  QSlider* slider_ = nullptr;
  QSpinBox* strength_ = nullptr;
  QLabel *hint_ = nullptr, *source_ = nullptr;
  QPushButton* solve_ = nullptr;
  BodyChoiceForm* body_choice_ = nullptr;  ///< Shown where the body filter solves.
};

}  // namespace limbwave::ui
