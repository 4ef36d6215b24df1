#include "calibration/wizard_model.h"

#include <utility>

#include "common/core_text.h"

namespace limbwave::ui {

WizardModel::WizardModel(CalibrationDesk& desk, QObject* parent) : QObject(parent), desk_(desk) {}

int WizardModel::accepted() const {
  int number = 0;
  for (int i = 0; i < count(); ++i) {
    number += outcome(i).decision == Decision::kAccepted ? 1 : 0;
  }
  return number;
}

int WizardModel::bad() const {
  int number = 0;
  for (int i = 0; i < count(); ++i) {
    const std::optional<calibrate::Verdict> found = verdict(i);
    number += !found || *found == calibrate::Verdict::kRepeat ? 1 : 0;
  }
  return number;
}

bool WizardModel::has_open_verdicts() const {
  for (int i = 0; i < count(); ++i) {
    if (verdict(i) && outcome(i).decision != Decision::kDiscarded) {
      return true;
    }
  }
  return false;
}

void WizardModel::accept_good() {
  for (int i = 0; i < count(); ++i) {
    const std::optional<calibrate::Verdict> found = verdict(i);
    if (found && *found != calibrate::Verdict::kRepeat) {
      outcome_at(i).decision = Decision::kAccepted;
    }
  }
}

void WizardModel::decide(int sensor, Decision decision) {
  for (int i = 0; i < count(); ++i) {
    if (outcome(i).sensor == sensor && (verdict(i) || decision != Decision::kAccepted)) {
      outcome_at(i).decision = decision;
    }
  }
  Q_EMIT outcomes_changed();
}

void WizardModel::take_on(CalibrationDesk::Target target) {
  target_ = std::move(target);
  from_take_ = interrupted_ = false;
}

void WizardModel::notice_loss(bool moving) {
  if (moving && !interrupted_ && !desk_.source().running()) {
    interrupted_ = true;
    keep_stretch();
    Q_EMIT device_lost();
  }
}

void WizardModel::save() {
  const int number = accepted();
  saving_ = true;
  Q_EMIT outcomes_changed();
  desk_.save(target_, accepted_change(), [this, number](const Status& status) {
    saving_ = false;
    if (!status) {
      Q_EMIT save_failed(core_text(status.error().text()));
      Q_EMIT outcomes_changed();
      return;
    }
    clear_outcomes();
    Q_EMIT saved(number);
    Q_EMIT left();
  });
}

}  // namespace limbwave::ui
