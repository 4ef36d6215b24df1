/// Inspector of the selected bone: name, length, rotation about the vertical with its keys. Of the live figure the
/// rotation holds from the moment at which it is set (live_headings.h).
#pragma once

#include <QWidget>

#include "common/studio_context.h"
#include "common/widgets.h"
#include "workspaces/solve/live_headings.h"
#include "workspaces/solve/solve_model.h"

class QComboBox;
class QDoubleSpinBox;
class QListWidget;
class QSlider;

namespace limbwave::ui {

class BoneCard : public Card {
  Q_OBJECT
 public:
  BoneCard(StudioContext& context, SolveModel& model, QWidget* parent = nullptr);

  /// The segment that the selection belongs to, whatever is selected; -1: none.
  [[nodiscard]] int segment() const { return segment_; }

 private:
  void build();
  void follow_selection();
  void show_skeleton();
  void show_heading();
  void show_keys();
  void turn_to(double heading, int gesture);
  /// Of the selected bone now: at the playhead, or live.
  [[nodiscard]] double heading() const;

  StudioContext& context_;
  SolveModel& model_;
  LiveHeadings& live_headings_;
  int segment_ = -1;
  int gesture_ = kNoGesture;  ///< Of the slider while it is held.
  bool showing_ = false;      ///< Values come from the model: not an edit.
  QComboBox* bones_ = nullptr;
  QDoubleSpinBox *length_ = nullptr, *heading_ = nullptr;
  QSlider* slider_ = nullptr;
  QPushButton *set_key_ = nullptr, *delete_key_ = nullptr, *straight_ = nullptr;
  QListWidget* list_ = nullptr;
  QLabel* hint_ = nullptr;
};

/// The segment that a selection belongs to: of the sensor, of the key, or itself; -1: none.
int segment_of_selection(const SelectedItem& item, const SolveModel& model);

}  // namespace limbwave::ui
