/// Everything about the file that may differ from the preset: frames, time, root, rest pose, names, unit, keys, body.
#pragma once

#include "common/widgets.h"
#include "workspaces/export/export_model.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QProgressBar;

namespace limbwave::ui {

class ExportOptionsCard : public Card {
  Q_OBJECT
 public:
  ExportOptionsCard(StudioContext& context, ExportModel& model, QWidget* parent = nullptr);

 protected:
  /// The wheel scrolls the page; it changes only what has the focus.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void make_time_rows(QFormLayout* form);
  void make_figure_rows(QFormLayout* form);
  void make_body_rows(QFormLayout* form);
  void follow();
  void show_choices();
  [[nodiscard]] QString own_rate_text() const;
  [[nodiscard]] QString proposed_rate_text() const;
  [[nodiscard]] QString visible_text() const;
  void show_time(const ExportChoices& choices);
  void show_figure(const ExportChoices& choices, const interchange::Preset& preset);
  void show_body(const ExportChoices& choices);
  void show_preparing();
  /// What the widgets say now.
  void read();
  void choose_mesh();

  StudioContext& context_;
  ExportModel& model_;
  bool showing_ = false, any_rate_ = false;
  QComboBox *rates_ = nullptr, *ranges_ = nullptr, *root_ = nullptr, *rest_ = nullptr, *names_ = nullptr,
            *units_ = nullptr, *bodies_ = nullptr;
  QDoubleSpinBox *any_ = nullptr, *from_ = nullptr, *to_ = nullptr, *tolerance_ = nullptr;
  QCheckBox* rest_frame_ = nullptr;
  QWidget *part_ = nullptr, *mesh_row_ = nullptr, *skinning_ = nullptr;
  ElidedLabel* mesh_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QLabel* step_ = nullptr;
  QPushButton* stop_ = nullptr;
};

}  // namespace limbwave::ui
