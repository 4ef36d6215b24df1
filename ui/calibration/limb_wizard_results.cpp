// The second half of limb_wizard_model.h: computing, verdicts, saving.
#include <algorithm>

#include "calibration/calibration_words.h"
#include "calibration/limb_wizard_model.h"
#include "common/core_text.h"

namespace limbwave::ui {

void LimbWizardModel::compute() {
  desk_.end_recording();
  set_page(LimbPage::kComputing);
  const std::uint64_t attempt = ++attempt_;
  const std::shared_ptr<const calibrate::LimbCalibrator> calibrator(std::move(calibrator_));
  desk_.context().jobs().compute<calibrate::LimbResult>(
      tr("Computing the mounting"), this,
      [calibrator, date = now_iso()](const Progress&) { return calibrator->finish(date); },
      [this, attempt](const Result<calibrate::LimbResult>& result) {
        if (attempt != attempt_) {
          return;
        }
        merge(result);
        set_page(LimbPage::kResult);
      });
}

void LimbWizardModel::merge(const Result<calibrate::LimbResult>& result) {
  refusal_ = result ? Error{} : result.error();
  diagnostics_ = result ? result->diagnostics : Diagnostics{};
  for (const int sensor : held_by_) {
    LimbOutcome outcome;
    outcome.sensor = sensor;
    if (result) {
      const auto found = std::find_if(result->sensors.begin(), result->sensors.end(),
                                      [sensor](const auto& candidate) { return candidate.sensor == sensor; });
      if (found != result->sensors.end()) {
        outcome.result = *found;
      }
    } else {
      outcome.error = result.error();
    }
    // What is good or usable is accepted unless the technician says otherwise.
    if (outcome.result && outcome.result->verdict != calibrate::Verdict::kRepeat) {
      outcome.decision = Decision::kAccepted;
    }
    const auto same = std::find_if(outcomes_.begin(), outcomes_.end(),
                                   [sensor](const LimbOutcome& old) { return old.sensor == sensor; });
    if (same == outcomes_.end()) {
      outcomes_.push_back(std::move(outcome));
    } else if (outcome.result || !same->result) {
      // A failed repetition leaves the attempt before it standing.
      if (same->result) {
        outcome.before_deg = same->result->angle_error_deg;
      }
      *same = std::move(outcome);
    }
  }
  Q_EMIT outcomes_changed();
}

void LimbWizardModel::show_outcomes(int group, std::vector<LimbOutcome> outcomes, Error refusal,
                                    const CalibrationDesk::Target& target) {
  ++attempt_;
  take_on(target);
  from_take_ = true;
  saving_ = checking_ = false;
  checks_.clear();
  diagnostics_.clear();
  choose_group(group);
  outcomes_ = std::move(outcomes);
  refusal_ = std::move(refusal);
  accept_good();
  Q_EMIT outcomes_changed();
  set_page(LimbPage::kResult);
}

std::optional<calibrate::Verdict> LimbWizardModel::verdict(int i) const {
  const auto& result = outcomes_.at(static_cast<std::size_t>(i)).result;
  return result ? std::optional(result->verdict) : std::nullopt;
}

calibrate::RigCalibration LimbWizardModel::with_accepted() const {
  calibrate::RigCalibration calibration = desk_.calibration_of(target_);
  for (const LimbOutcome& outcome : outcomes_) {
    if (outcome.decision == Decision::kAccepted && outcome.result) {
      calibration.mounts.at(static_cast<std::size_t>(outcome.sensor)) = outcome.result->mount;
    }
  }
  return calibration;
}

void LimbWizardModel::compute_check() {
  checking_ = false;
  set_page(LimbPage::kComputing);
  const std::uint64_t attempt = ++attempt_;
  const std::shared_ptr<const calibrate::LimbCalibrator> calibrator(std::move(calibrator_));
  using Checks = std::vector<calibrate::PoseCheck>;
  desk_.context().jobs().compute<Checks>(
      tr("Checking the mounting"), this,
      [calibrator, pose = pose_, calibration = with_accepted()](const Progress&) {
        return calibrator->check(pose, calibration);
      },
      [this, attempt](Result<Checks> checks) {
        if (attempt != attempt_) {
          return;
        }
        checks_.clear();
        refusal_ = checks ? Error{} : checks.error();
        if (checks) {
          checks_ = std::move(checks).value();
        }
        set_page(LimbPage::kCheck);
      });
}

CalibrationChange LimbWizardModel::accepted_change() const {
  CalibrationChange change;
  for (const LimbOutcome& outcome : outcomes_) {
    if (outcome.decision == Decision::kAccepted && outcome.result) {
      change.mounts.push_back(outcome.result->mount);
    }
  }
  return change;
}

}  // namespace limbwave::ui
