#include "calibration/range_wizard.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <algorithm>
#include <numeric>

#include "base/units.h"
#include "common/core_text.h"
#include "common/shown_names.h"
#include "common/theme.h"

namespace limbwave::ui {
VerdictRowContent range_row(const RangeOutcome& outcome, const body::Rig& rig, bool live) {
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
  const calibrate::RangeResult& result = *outcome.result;
  content.acceptable = true;
  content.state = {verdict_tone(result.verdict), verdict_word(result.verdict), format_mg(result.calibration.residual_g),
                   RangeWizard::tr("RMS off 1 g")};
  const bool ellipsoid = result.calibration.method == "ellipsoid";
  content.text = ellipsoid ? RangeWizard::tr("Ellipsoid is better: %1 against %2 by extremes.")
                                 .arg(format_mg(result.ellipsoid.residual_g), format_mg(result.extremes.residual_g))
                           : RangeWizard::tr("Extremes are better: %1 against %2 by ellipsoid.")
                                 .arg(format_mg(result.extremes.residual_g), format_mg(result.ellipsoid.residual_g));
  QStringList rest{RangeWizard::tr("%1 % of the sphere, %2 s steady")
                       .arg(qRound(100.0 * result.calibration.coverage))
                       .arg(result.steady_s, 0, 'f', 0)};
  if (outcome.before_g) {
    rest << RangeWizard::tr("attempt before: %1").arg(format_mg(*outcome.before_g));
  }
  for (const Diagnostic& diagnostic : result.diagnostics) {
    rest << core_text(diagnostic.message);
  }
  content.comparison = rest.join(QStringLiteral(" · "));
  return content;
}

RangeWizard::RangeWizard(RangeWizardModel& model, QWidget* parent)
    : CalibrationWizard(model, tr("Calibrate range"), true, parent), model_(model) {
  setObjectName(QStringLiteral("range_wizard"));
  frame()->add_page(make_choose_page());
  frame()->add_page(make_instruction_page());
  turn_ = new RangeTurnPage(model_, this);
  frame()->add_page(turn_);
  QHBoxLayout* buttons = nullptr;
  frame()->add_page(make_result_page(&buttons));
  connect(&model_, &WizardModel::page_changed, this, &RangeWizard::show_page);
  connect(&model_, &WizardModel::choice_changed, this, &RangeWizard::refresh_buttons);
  connect(&model_, &RangeWizardModel::turned, this, &RangeWizard::refresh_buttons);
  connect(&model_, &RangeWizardModel::sufficed, this, [this] { sounds().play(CueSounds::Cue::kDone); });
}

QWidget* RangeWizard::make_choose_page() {
  const auto [page, columns, words] = make_columns();
  auto* card = new Card(tr("Which sensors?"), page);
  chooser_ = new SensorChooser(card);
  connect(chooser_, &SensorChooser::toggled, &model_, &RangeWizardModel::choose);
  card->body()->addWidget(chooser_);
  card->body()->addStretch();
  columns->addWidget(card, 3);
  words->addWidget(paragraph(tr("Range calibration finds each sensor's zero and scale from gravity. It is done <b>once "
                                "in a sensor's life</b>, not on the body, and takes about a minute."),
                             page));
  words->addWidget(paragraph(tr("Several sensors can be calibrated at once: fix them in one small box so that none can "
                                "slip, and turn the box."),
                             page));
  add_source_line(words, page, QStringLiteral("range"));
  words->addStretch();
  columns->addLayout(words, 2);
  return page;
}

QWidget* RangeWizard::make_instruction_page() {
  const auto [page, columns, words] = make_columns();
  auto* pictures = new QGridLayout;
  pictures->setSpacing(kGrid);
  const std::array<Eigen::Vector3d, 6> ups{Eigen::Vector3d::UnitZ(), -Eigen::Vector3d::UnitZ(),
                                           Eigen::Vector3d::UnitX(), -Eigen::Vector3d::UnitX(),
                                           Eigen::Vector3d::UnitY(), -Eigen::Vector3d::UnitY()};
  for (int i = 0; i < 6; ++i) {
    auto* cell = new Card({}, page);
    auto* cube = new SensorCube(cell);
    cube->set_up(ups.at(static_cast<std::size_t>(i)));
    cell->body()->addWidget(cube, 1);
    auto* caption = new QLabel(up_words(ups.at(static_cast<std::size_t>(i))), cell);
    caption->setAlignment(Qt::AlignCenter);
    cell->body()->addWidget(caption);
    pictures->addWidget(cell, i / 3, i % 3);
  }
  columns->addLayout(pictures, 3);
  const QStringList steps{
      tr("<b>Hold the box in both hands</b>, cables slack. Sit down: it takes about a minute."),
      tr("<b>Turn it slowly until every face has looked up once</b>, then every edge and corner between them."),
      tr("<b>Slowly</b> means about ten seconds for a full turn, without knocks. Only steady turning counts; what is "
         "too fast is left out by itself."),
      tr("The map fills up as you turn. It always names the direction that is missing most.")};
  for (int i = 0; i < steps.size(); ++i) {
    words->addWidget(paragraph(QStringLiteral("%1. %2").arg(i + 1).arg(steps[i]), page));
  }
  words->addStretch();
  columns->addLayout(words, 2);
  return page;
}

void RangeWizard::show_page() {
  const RangePage page = model_.page();
  show_note(page == RangePage::kTurn || page == RangePage::kResult);
  switch (page) {
    case RangePage::kChoose:
      refresh_chooser();
      frame()->show_page(0);
      break;
    case RangePage::kInstructions:
      frame()->show_page(1);
      break;
    case RangePage::kTurn:
      turn_->restart();
      frame()->show_page(2);
      break;
    case RangePage::kComputing:
      break;  // It takes a moment; the page stays.
    case RangePage::kResult:
      refresh_results();
      frame()->show_page(3);
      break;
  }
  refresh_buttons();
}

void RangeWizard::refresh_chooser() {
  std::vector<int> all(model_.rig().accelerometers.size());
  std::iota(all.begin(), all.end(), 0);
  chooser_->set_sensors(model_.rig(), all, model_.chosen(), [this](int sensor) {
    return range_state(model_.desk().calibration_of(model_.target()).sensors.at(static_cast<std::size_t>(sensor)));
  });
}

void RangeWizard::refresh_own_buttons() {
  frame()->set_steps({tr("Sensors"), tr("How"), tr("Turn"), tr("Verdict")}, model_.page() == RangePage::kChoose ? 0
                                                                            : model_.page() == RangePage::kInstructions
                                                                                ? 1
                                                                            : model_.page() == RangePage::kResult ? 3
                                                                                                                  : 2);
  const QString obstacle = model_.obstacle();
  switch (model_.page()) {
    case RangePage::kChoose:
      frame()->set_next(tr("Continue"), obstacle);
      frame()->set_back({}, false);
      break;
    case RangePage::kInstructions:
      frame()->set_next(tr("Start turning"), obstacle);
      frame()->set_back(tr("Back"), true);
      break;
    case RangePage::kTurn:
      frame()->set_next(model_.all_enough() ? tr("Finish") : tr("Finish early"), obstacle);
      set_style_property(frame()->next_button(), "primary", model_.all_enough());
      frame()->set_back(tr("Back"), true);
      return;
    case RangePage::kComputing:
      frame()->set_next(tr("Computing…"), obstacle);
      frame()->set_back({}, false);
      break;
    case RangePage::kResult:
      frame()->set_next(model_.accepted() > 0 ? tr("Save %1").arg(counted_calibrations(model_.accepted())) : tr("Save"),
                        obstacle);
      frame()->set_back({}, false);
      break;
  }
  set_style_property(frame()->next_button(), "primary", true);
}

VerdictRowContent RangeWizard::row_content(int i) const {
  return range_row(model_.outcomes().at(static_cast<std::size_t>(i)), model_.rig(), model_.repeatable());
}

void RangeWizard::refresh_own_results() {
  for (int i = 0; i < model_.count(); ++i) {
    row(i)->set_visited(model_.outcomes()[static_cast<std::size_t>(i)].visited);
  }
}

QString RangeWizard::movement_lost() const {
  return tr("What was turned until now would not be used.");
}

}  // namespace limbwave::ui
