// The second half of limb_wizard.h: what the pages show.
#include <QGridLayout>
#include <QLocale>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

#include "calibration/limb_wizard.h"
#include "common/core_text.h"
#include "common/shown_names.h"
#include "common/theme.h"

namespace limbwave::ui {
namespace {

QString sensor_name(const body::Rig& rig, int sensor) {
  return shown_name(rig.accelerometers.at(static_cast<std::size_t>(sensor)).name);
}

QString sentence(const Error& error) {
  QString text = core_text(error.message);
  if (!text.isEmpty()) {
    text[0] = text[0].toUpper();
  }
  if (!error.remedy.empty()) {
    text += LimbWizard::tr(". Remedy: %1.").arg(core_text(error.remedy));
  }
  return text;
}

}  // namespace

VerdictRowContent limb_row(const LimbOutcome& outcome, const body::Rig& rig, bool live) {
  VerdictRowContent content;
  const body::Accelerometer& accelerometer = rig.accelerometers.at(static_cast<std::size_t>(outcome.sensor));
  content.title = shown_name(accelerometer.name);
  content.serial = QString::fromStdString(accelerometer.serial);
  content.decision = outcome.decision;
  content.repeatable = live;
  if (!outcome.result) {
    content.state = refused_state();
    content.text = core_text(outcome.error.message);
    content.comparison = core_text(outcome.error.remedy);
    return content;
  }
  const calibrate::SensorLimbResult& result = *outcome.result;
  content.acceptable = result.mount.method != "nominal";  // the poses may have given none
  content.state = {verdict_tone(result.verdict), verdict_word(result.verdict),
                   format_degrees(result.mount.pose_angle_deg), LimbWizard::tr("between poses")};
  content.text = LimbWizard::tr("%1 from 90°, held within %2.")
                     .arg(format_degrees(result.angle_error_deg, true), format_mg(result.movement_g));
  const calibrate::LimbParameters limits;
  if (std::abs(result.angle_error_deg) > limits.good_angle_deg) {
    content.text += LimbWizard::tr(" The poses were not a right angle apart: each may be %1 off.")
                        .arg(format_degrees(0.5 * std::abs(result.angle_error_deg)));
  }
  if (result.movement_g > limits.good_movement_g) {
    content.text += LimbWizard::tr(" It moved while it was held.");
  }
  if (std::abs(result.norm_error_g) > limits.good_norm_g) {
    content.text += LimbWizard::tr(" It reads %1 g at rest: calibrate its range, or the volume was moved.")
                        .arg(QLocale().toString(1.0 + result.norm_error_g, 'f', 2));
  }
  QStringList rest{LimbWizard::tr("sits %1 from how the rig shows it").arg(format_degrees(result.from_nominal_deg))};
  if (outcome.before_deg) {
    rest << LimbWizard::tr("attempt before: %1").arg(format_degrees(*outcome.before_deg, true));
  }
  content.comparison = rest.join(QStringLiteral(" · "));
  return content;
}

void LimbWizard::refresh_choice() {
  const body::Rig& rig = model_.rig();
  {
    const QSignalBlocker blocker(groups_);
    groups_->clear();
    for (const body::CalibrationGroup& group : rig.groups) {
      groups_->addItem(tr("%1: %2, then %3")
                           .arg(shown_name(group.name), shown_name(group.first.name), shown_name(group.second.name)));
    }
    groups_->setCurrentIndex(model_.group());
  }
  if (!wearer_->hasFocus()) {
    wearer_->setText(model_.desk().wearer());
  }
  const std::vector<int> members = model_.group() < static_cast<int>(rig.groups.size())
                                       ? rig.groups[static_cast<std::size_t>(model_.group())].sensors
                                       : std::vector<int>{};
  chooser_->set_sensors(rig, members, model_.sensors(), [this](int sensor) {
    return mount_state(model_.desk().calibration_of(model_.target()).mounts.at(static_cast<std::size_t>(sensor)));
  });
  const QStringList without = model_.without_range();
  range_warning_->setVisible(!without.isEmpty());
  range_text_->setText(
      tr("Range never calibrated: %1. Their directions may be several degrees off.").arg(without.join(tr(", "))));
  refresh_buttons();
}

void LimbWizard::refresh_prepare() {
  for (int pose = 0; pose < 2; ++pose) {
    const auto at = static_cast<std::size_t>(pose);
    const body::LimbPose& text = model_.pose_text(pose);
    captions_.at(at)->setText(QStringLiteral("%1  %2").arg(pose + 1).arg(shown_name(text.name)));
    instructions_.at(at)->setText(QString::fromStdString(text.instruction));
    pictures_.at(at)->set_pose(model_.rig(), model_.skeleton(), model_.group(), pose, model_.sensors());
  }
  const QSignalBlocker blocker(seconds_);
  seconds_->setValue(static_cast<int>(std::lround(model_.countdown_s())));
}

void LimbWizard::refresh_own_buttons() {
  const LimbPage page = model_.page();
  const bool second = model_.pose() == 1;
  frame()->set_steps({tr("Limb"), tr("How"), tr("First pose"), tr("Second pose"), tr("Verdict")},
                     page == LimbPage::kChoose                                 ? 0
                     : page == LimbPage::kPrepare                              ? 1
                     : page == LimbPage::kCountdown || page == LimbPage::kHold ? (second ? 3 : 2)
                                                                               : 4);
  const QString obstacle = model_.obstacle();
  switch (page) {
    case LimbPage::kChoose:
      frame()->set_next(tr("Continue"), obstacle);
      frame()->set_back({}, false);
      break;
    case LimbPage::kPrepare:
      frame()->set_next(tr("Start"), obstacle);
      frame()->set_back(tr("Back"), true);
      break;
    case LimbPage::kCountdown:
      frame()->set_next(tr("Skip the wait"), obstacle);
      frame()->set_back(tr("Back"), true);
      break;
    case LimbPage::kHold:
      frame()->set_next(tr("Take the stillest second"), obstacle, false);
      frame()->set_back(tr("Back"), true);
      break;
    case LimbPage::kComputing:
      frame()->set_next(tr("Computing…"), obstacle);
      frame()->set_back({}, false);
      break;
    case LimbPage::kResult:
      frame()->set_next(model_.accepted() > 0 ? tr("Save %1").arg(counted_calibrations(model_.accepted())) : tr("Save"),
                        obstacle);
      frame()->set_back({}, false);
      break;
    case LimbPage::kCheck:
      frame()->set_next(tr("Back to the verdict"), obstacle);
      frame()->set_back({}, false);
      break;
  }
}

VerdictRowContent LimbWizard::row_content(int i) const {
  return limb_row(model_.outcomes().at(static_cast<std::size_t>(i)), model_.rig(), model_.repeatable());
}

void LimbWizard::refresh_own_results() {
  const bool live = model_.repeatable();
  QStringList findings;
  if (!model_.refusal().message.empty()) {
    findings << sentence(model_.refusal());
  }
  for (const Diagnostic& diagnostic : model_.diagnostics()) {
    findings << tr("%1 %2; %3.")
                    .arg(QString::fromStdString(diagnostic.place), core_text(diagnostic.message),
                         core_text(diagnostic.remedy));
  }
  set_findings(findings.join(QLatin1Char('\n')));
  repeat_both_->setEnabled(live);
  for (int pose = 0; pose < 2 && !model_.rig().groups.empty(); ++pose) {
    QPushButton* check = check_buttons_.at(static_cast<std::size_t>(pose));
    check->setText(tr("Check: hold \"%1\" again").arg(shown_name(model_.pose_text(pose).name)));
    check->setEnabled(live && model_.accepted() > 0);
  }
}

void LimbWizard::refresh_checks() {
  check_rows_->hide();
  check_rows_->deleteLater();
  check_rows_ = new QWidget(this);
  auto* grid = new QGridLayout(check_rows_);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(3 * kGrid);
  grid->setVerticalSpacing(kGrid);
  double worst = 0.0;
  int row = 0;
  for (const calibrate::PoseCheck& check : model_.checks()) {
    worst = std::max(worst, check.error_deg);
    auto* name = new QLabel(sensor_name(model_.rig(), check.sensor), check_rows_);
    name->setStyleSheet(QStringLiteral("font-size: 18px;"));
    grid->addWidget(name, row, 0);
    auto* badge = new VerdictBadge(check_rows_);
    badge->setObjectName(QStringLiteral("check_badge_%1").arg(check.sensor));
    badge->set_state({verdict_tone(check.verdict), verdict_word(check.verdict), format_degrees(check.error_deg),
                      tr("held within %1").arg(format_mg(check.movement_g))});
    grid->addWidget(badge, row++, 1);
  }
  grid->setColumnStretch(2, 1);
  check_layout_->insertWidget(2, check_rows_);
  const bool failed = model_.checks().empty();
  check_summary_->setText(failed ? tr("Not checked") : tr("At most %1 off").arg(format_degrees(worst)));
  check_text_->setText(failed ? sentence(model_.refusal())
                              : tr("Angle between gravity as each sensor now sees it on its limb and as the pose asks "
                                   "for. It holds the wearer's own inexactness too."));
}

}  // namespace limbwave::ui
