/// How the body filter solves a take: direction in time, sensors, root, noises. Part of the settings' card.
#pragma once

#include <QWidget>

#include "workspaces/solve/solve_model.h"

class QCheckBox;
class QComboBox;
class QLabel;

namespace limbwave::ui {

class BodyChoiceForm : public QWidget {
  Q_OBJECT
 public:
  explicit BodyChoiceForm(SolveModel& model, QWidget* parent = nullptr);
  /// Shows the model's settings.
  void refresh();

 private:
  void change(const std::function<void(solve::BodyChoice&)>& edit, const QString& what);
  void fill_roots(const solve::BodyChoice& choice);

  SolveModel& model_;
  QComboBox *method_, *sensors_, *root_;
  QCheckBox* tune_;
  QLabel *method_hint_, *root_hint_;
};

}  // namespace limbwave::ui
