#include "calibration/range_wizard.h"

#include <QApplication>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QScrollArea>
#include <algorithm>
#include <numeric>

#include "base/units.h"
#include "common/theme.h"

namespace limbwave::ui {
namespace {

QLabel* paragraph(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setWordWrap(true);
  label->setTextFormat(Qt::RichText);
  label->setStyleSheet(QStringLiteral("font-size: 16px;"));
  return label;
}

}  // namespace

VerdictRowContent range_row(const RangeOutcome& outcome, const body::Rig& rig, bool live) {
  VerdictRowContent content;
  const body::Accelerometer& accelerometer = rig.accelerometers.at(static_cast<std::size_t>(outcome.sensor));
  content.title = QString::fromStdString(accelerometer.name);
  content.serial = QString::fromStdString(accelerometer.serial);
  content.decision = outcome.decision;
  content.repeatable = live;
  if (!outcome.result) {
    content.state = refused_state();
    content.text = QString::fromStdString(outcome.error.message);
    content.comparison = QString::fromStdString(outcome.error.remedy);
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
    rest << QString::fromStdString(diagnostic.message);
  }
  content.comparison = rest.join(QStringLiteral(" · "));
  return content;
}

RangeWizard::RangeWizard(RangeWizardModel& model, QWidget* parent)
    : QWidget(parent), model_(model), frame_(new WizardFrame(tr("Calibrate range"), this)) {
  setObjectName(QStringLiteral("range_wizard"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(frame_);
  frame_->add_page(make_choose_page());
  frame_->add_page(make_instruction_page());
  turn_ = new RangeTurnPage(model_, this);
  frame_->add_page(turn_);
  frame_->add_page(make_result_page());

  connect(frame_, &WizardFrame::next, &model_, &RangeWizardModel::next);
  connect(frame_, &WizardFrame::back, &model_, &RangeWizardModel::back);
  connect(frame_, &WizardFrame::cancel, this, &RangeWizard::leave);
  connect(frame_, &WizardFrame::leave_anyway, &model_, &RangeWizardModel::cancel);
  connect(&model_, &RangeWizardModel::page_changed, this, &RangeWizard::show_page);
  connect(&model_, &RangeWizardModel::choice_changed, this, &RangeWizard::refresh_buttons);
  connect(&model_, &RangeWizardModel::turned, this, &RangeWizard::refresh_buttons);
  connect(&model_, &RangeWizardModel::outcomes_changed, this, &RangeWizard::refresh_results);
  connect(&model_, &RangeWizardModel::sufficed, this, [] { QApplication::beep(); });
  connect(&model_, &RangeWizardModel::save_failed, this,
          [this](const QString& text) { frame_->set_note(tr("Not saved: %1").arg(text)); });
  connect(&model_.desk(), &CalibrationDesk::recording_note_changed, this,
          [this] { frame_->set_note(model_.desk().recording_note()); });
}

QWidget* RangeWizard::make_choose_page() {
  auto* page = new QWidget(this);
  auto* columns = new QHBoxLayout(page);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(4 * kGrid);
  auto* card = new Card(tr("Which sensors?"), page);
  chooser_ = new SensorChooser(card);
  connect(chooser_, &SensorChooser::toggled, &model_, &RangeWizardModel::choose);
  card->body()->addWidget(chooser_);
  card->body()->addStretch();
  columns->addWidget(card, 3);
  auto* words = new QVBoxLayout;
  words->setSpacing(2 * kGrid);
  words->addWidget(paragraph(tr("Range calibration finds each sensor's zero and scale from gravity. It is done <b>once "
                                "in a sensor's life</b>, "
                                "not on the body, and takes about a minute."),
                             page));
  words->addWidget(paragraph(tr("Several sensors can be calibrated at once: fix them in one small box so that none can "
                                "slip, and turn the box."),
                             page));
  source_line_ = paragraph({}, page);
  words->addWidget(source_line_);
  open_device_ = new QPushButton(tr("Open a device in Capture"), page);
  connect(open_device_, &QPushButton::clicked, this, &RangeWizard::device_wanted);
  words->addWidget(open_device_, 0, Qt::AlignLeft);
  words->addStretch();
  columns->addLayout(words, 2);
  return page;
}

QWidget* RangeWizard::make_instruction_page() {
  auto* page = new QWidget(this);
  auto* columns = new QHBoxLayout(page);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(4 * kGrid);
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
  auto* words = new QVBoxLayout;
  words->setSpacing(2 * kGrid);
  const QStringList steps{
      tr("<b>Hold the box in both hands</b>, cables slack. Sit down: it takes about a minute."),
      tr("<b>Turn it slowly until every face has looked up once</b>, then every edge and corner between them."),
      tr("<b>Slowly</b> means about ten seconds for a full turn, without knocks. Only steady turning counts; what is "
         "too "
         "fast is left out by itself."),
      tr("The map fills up as you turn. It always names the direction that is missing most.")};
  for (int i = 0; i < steps.size(); ++i) {
    words->addWidget(paragraph(QStringLiteral("%1.&nbsp; %2").arg(i + 1).arg(steps[i]), page));
  }
  words->addStretch();
  columns->addLayout(words, 2);
  return page;
}

QWidget* RangeWizard::make_result_page() {
  auto* page = new QWidget(this);
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2 * kGrid);
  summary_ = distance_label(page);
  summary_->setObjectName(QStringLiteral("summary"));
  layout->addWidget(summary_);
  auto* scroll = new QScrollArea(page);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  auto* content = new QWidget(scroll);
  content->setProperty("scroll", true);
  rows_layout_ = new QVBoxLayout(content);
  rows_layout_->setContentsMargins(0, 0, 0, 0);
  rows_layout_->setSpacing(kGrid);
  rows_layout_->addStretch(1);
  scroll->setWidget(content);
  layout->addWidget(scroll, 1);
  return page;
}

void RangeWizard::show_page() {
  const RangePage page = model_.page();
  frame_->set_note(page == RangePage::kTurn || page == RangePage::kResult ? model_.desk().recording_note() : QString());
  switch (page) {
    case RangePage::kChoose:
      refresh_chooser();
      frame_->show_page(0);
      break;
    case RangePage::kInstructions:
      frame_->show_page(1);
      break;
    case RangePage::kTurn:
      turn_->restart();
      frame_->show_page(2);
      break;
    case RangePage::kComputing:
      break;  // It takes a moment; the page stays.
    case RangePage::kResult:
      refresh_results();
      frame_->show_page(3);
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

void RangeWizard::refresh_buttons() {
  const bool running = model_.desk().source().running();
  open_device_->setVisible(!running);
  source_line_->setText(running ? tr("Signal: <b>%1</b>").arg(model_.desk().source().title().toHtmlEscaped())
                                : tr("<b>No signal comes in.</b>"));
  frame_->set_steps({tr("Sensors"), tr("How"), tr("Turn"), tr("Verdict")}, model_.page() == RangePage::kChoose ? 0
                                                                           : model_.page() == RangePage::kInstructions
                                                                               ? 1
                                                                           : model_.page() == RangePage::kResult ? 3
                                                                                                                 : 2);
  const QString obstacle = model_.obstacle();
  switch (model_.page()) {
    case RangePage::kChoose:
      frame_->set_next(tr("Continue"), obstacle);
      frame_->set_back({}, false);
      break;
    case RangePage::kInstructions:
      frame_->set_next(tr("Start turning"), obstacle);
      frame_->set_back(tr("Back"), true);
      break;
    case RangePage::kTurn:
      frame_->set_next(model_.all_enough() ? tr("Finish") : tr("Finish early"), obstacle);
      set_style_property(frame_->next_button(), "primary", model_.all_enough());
      frame_->set_back(tr("Back"), true);
      return;
    case RangePage::kComputing:
      frame_->set_next(tr("Computing…"), obstacle);
      frame_->set_back({}, false);
      break;
    case RangePage::kResult:
      frame_->set_next(tr("Save %1").arg(counted_calibrations(model_.accepted())), obstacle);
      frame_->set_back({}, false);
      break;
  }
  set_style_property(frame_->next_button(), "primary", true);
}

void RangeWizard::refresh_results() {
  const auto& outcomes = model_.outcomes();
  const bool same = rows_.size() == outcomes.size() && std::equal(rows_.begin(), rows_.end(), outcomes.begin(),
                                                                  [](const VerdictRow* row, const auto& outcome) {
                                                                    return row->sensor() == outcome.sensor;
                                                                  });
  if (!same) {
    for (VerdictRow* row : rows_) {
      row->hide();
      row->deleteLater();
    }
    rows_.clear();
    for (const RangeOutcome& outcome : outcomes) {
      auto* row = new VerdictRow(outcome.sensor, true, this);
      connect(row, &VerdictRow::accept, &model_, [this](int sensor) { model_.decide(sensor, Decision::kAccepted); });
      connect(row, &VerdictRow::discard, &model_, [this](int sensor) { model_.decide(sensor, Decision::kDiscarded); });
      connect(row, &VerdictRow::repeat, &model_, &RangeWizardModel::repeat);
      rows_layout_->insertWidget(rows_layout_->count() - 1, row);
      rows_.push_back(row);
    }
  }
  const bool live = model_.desk().source().running();
  int bad = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows_[i]->set_content(range_row(outcomes[i], model_.rig(), live));
    rows_[i]->set_visited(outcomes[i].visited);
    bad += !outcomes[i].result || outcomes[i].result->verdict == calibrate::Verdict::kRepeat ? 1 : 0;
  }
  const int count = static_cast<int>(outcomes.size());
  summary_->setText(bad == 0       ? tr("%1 calibrated").arg(counted_sensors(count))
                    : bad == count ? tr("Repeat")
                                   : tr("%1 of %2 calibrated, repeat the others").arg(count - bad).arg(count));
  refresh_buttons();
}

void RangeWizard::leave() {
  if (model_.would_lose()) {
    frame_->ask_leave(model_.page() == RangePage::kResult
                          ? tr("The verdicts of %1 are not saved yet.")
                                .arg(counted_sensors(static_cast<int>(model_.outcomes().size())))
                          : tr("What was turned until now would not be used."));
  } else {
    model_.cancel();
  }
}

}  // namespace limbwave::ui
