/// Inspector of how good the solve is: a verdict, the sensors, the line, findings with remedies, errors against the
/// truth.
#pragma once

#include "common/widgets.h"
#include "workspaces/solve/quality_text.h"
#include "workspaces/solve/solve_model.h"

class QGridLayout;
class QVBoxLayout;

namespace limbwave::ui {

class QualityCard : public Card {
  Q_OBJECT
 public:
  explicit QualityCard(SolveModel& model, QWidget* parent = nullptr);

 private:
  void rebuild();
  void add_uncertainty(QVBoxLayout* layout, QWidget* content);
  void add_sensors(QVBoxLayout* layout, const solve::QualityReport& report, const Verdict& headline, QWidget* content);
  SolveModel& model_;
  QWidget* content_ = nullptr;
};

class TruthCard : public Card {
  Q_OBJECT
 public:
  explicit TruthCard(SolveModel& model, QWidget* parent = nullptr);

 private:
  void rebuild();
  SolveModel& model_;
  QWidget* content_ = nullptr;
};

}  // namespace limbwave::ui
