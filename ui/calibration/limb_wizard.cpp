#include "calibration/limb_wizard.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QSignalBlocker>
#include <algorithm>

#include "common/theme.h"

namespace limbwave::ui {
namespace {

QLabel* paragraph(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setWordWrap(true);
  label->setStyleSheet(QStringLiteral("font-size: 16px;"));
  return label;
}

}  // namespace

LimbWizard::LimbWizard(LimbWizardModel& model, QWidget* parent)
    : QWidget(parent), model_(model), frame_(new WizardFrame(tr("Calibrate mounting"), this)) {
  setObjectName(QStringLiteral("limb_wizard"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(frame_);
  frame_->add_page(make_choose_page());
  frame_->add_page(make_prepare_page());
  hold_ = new LimbHoldPage(model_, this);
  frame_->add_page(hold_);
  frame_->add_page(make_result_page());
  frame_->add_page(make_check_page());

  connect(frame_, &WizardFrame::next, &model_, &LimbWizardModel::next);
  connect(frame_, &WizardFrame::back, &model_, &LimbWizardModel::back);
  connect(frame_, &WizardFrame::cancel, this, &LimbWizard::leave);
  connect(frame_, &WizardFrame::leave_anyway, &model_, &LimbWizardModel::cancel);
  connect(&model_, &LimbWizardModel::page_changed, this, &LimbWizard::show_page);
  connect(&model_, &LimbWizardModel::choice_changed, this, &LimbWizard::refresh_choice);
  connect(&model_, &LimbWizardModel::held, this, &LimbWizard::refresh_buttons);
  connect(&model_, &LimbWizardModel::outcomes_changed, this, &LimbWizard::refresh_results);
  // Whoever wears the suit may not see the screen: the last three seconds, the start and the capture are heard.
  connect(&model_, &LimbWizardModel::counted, this, [](int left) {
    if (left <= 3) {
      QApplication::beep();
    }
  });
  connect(&model_, &LimbWizardModel::captured, this, [] { QApplication::beep(); });
  connect(&model_, &LimbWizardModel::save_failed, this,
          [this](const QString& text) { frame_->set_note(tr("Not saved: %1").arg(text)); });
  connect(&model_.desk(), &CalibrationDesk::recording_note_changed, this,
          [this] { frame_->set_note(model_.desk().recording_note()); });
}

QWidget* LimbWizard::make_choose_page() {
  auto* page = new QWidget(this);
  auto* columns = new QHBoxLayout(page);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(4 * kGrid);
  auto* card = new Card(tr("Which limb, and which of its sensors?"), page);
  groups_ = new QComboBox(card);
  groups_->setObjectName(QStringLiteral("groups"));
  groups_->setMinimumHeight(4 * kGrid);
  connect(groups_, &QComboBox::activated, &model_, &LimbWizardModel::choose_group);
  card->body()->addWidget(groups_);
  chooser_ = new SensorChooser(card);
  connect(chooser_, &SensorChooser::toggled, &model_, &LimbWizardModel::choose_sensor);
  card->body()->addWidget(chooser_);
  card->body()->addStretch();
  columns->addWidget(card, 3);
  auto* words = new QVBoxLayout;
  words->setSpacing(2 * kGrid);
  words->addWidget(paragraph(tr("Mounting calibration finds how every sensor sits on its limb, from two poses a right "
                                "angle apart. It is done each time the sensors are put on."),
                             page));
  words->addWidget(heading_label(tr("Who wears them"), page));
  wearer_ = new QLineEdit(page);
  wearer_->setObjectName(QStringLiteral("wearer"));
  wearer_->setPlaceholderText(tr("Name (may stay empty)"));
  connect(wearer_, &QLineEdit::editingFinished, this, [this] { model_.desk().set_wearer(wearer_->text()); });
  words->addWidget(wearer_);
  range_warning_ = new Card({}, page);
  auto* warning = static_cast<Card*>(range_warning_)->body();
  range_text_ = paragraph({}, range_warning_);
  warning->addWidget(range_text_);
  auto* first = new QPushButton(tr("Calibrate their range first"), range_warning_);
  first->setObjectName(QStringLiteral("range_first"));
  connect(first, &QPushButton::clicked, this, [this] { Q_EMIT range_wanted(model_.sensors()); });
  warning->addWidget(first, 0, Qt::AlignLeft);
  words->addWidget(range_warning_);
  source_line_ = paragraph({}, page);
  words->addWidget(source_line_);
  open_device_ = new QPushButton(tr("Open a device in Capture"), page);
  connect(open_device_, &QPushButton::clicked, this, &LimbWizard::device_wanted);
  words->addWidget(open_device_, 0, Qt::AlignLeft);
  words->addStretch();
  columns->addLayout(words, 2);
  return page;
}

QWidget* LimbWizard::make_prepare_page() {
  auto* page = new QWidget(this);
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2 * kGrid);
  auto* pair = new QHBoxLayout;
  pair->setSpacing(2 * kGrid);
  for (std::size_t pose = 0; pose < 2; ++pose) {
    auto* card = new Card({}, page);
    captions_.at(pose) = new QLabel(card);
    captions_.at(pose)->setStyleSheet(QStringLiteral("font-size: 24px; font-weight: 600;"));
    pictures_.at(pose) = new PosePicture(card);
    instructions_.at(pose) = paragraph({}, card);
    instructions_.at(pose)->setMinimumHeight(6 * kGrid);
    card->body()->addWidget(captions_.at(pose));
    card->body()->addWidget(pictures_.at(pose), 1);
    card->body()->addWidget(instructions_.at(pose));
    pair->addWidget(card, 1);
  }
  layout->addLayout(pair, 1);
  how_ =
      paragraph(tr("After Start you have the time below to take the first pose. It is captured by itself as soon as "
                   "everything is still for a second; a sound tells, and the second pose follows. No key is needed."),
                page);
  layout->addWidget(how_);
  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel(tr("Time to take a pose"), page));
  seconds_ = new QSpinBox(page);
  seconds_->setObjectName(QStringLiteral("seconds"));
  seconds_->setRange(2, 30);
  seconds_->setSuffix(tr(" s"));
  connect(seconds_, &QSpinBox::valueChanged, &model_, [this](int s) { model_.set_countdown_s(s); });
  row->addWidget(seconds_);
  row->addStretch();
  layout->addLayout(row);
  return page;
}

QWidget* LimbWizard::make_result_page() {
  auto* page = new QWidget(this);
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2 * kGrid);
  summary_ = distance_label(page);
  summary_->setObjectName(QStringLiteral("summary"));
  layout->addWidget(summary_);
  findings_ = paragraph({}, page);
  findings_->setObjectName(QStringLiteral("findings"));
  layout->addWidget(findings_);
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
  auto* row = new QHBoxLayout;
  row->setSpacing(kGrid);
  repeat_both_ = new QPushButton(tr("Repeat both poses"), page);
  repeat_both_->setObjectName(QStringLiteral("repeat_both"));
  connect(repeat_both_, &QPushButton::clicked, &model_, &LimbWizardModel::repeat_both);
  row->addWidget(repeat_both_);
  for (int pose = 0; pose < 2; ++pose) {
    auto* check = new QPushButton(page);
    check->setObjectName(QStringLiteral("check_%1").arg(pose));
    connect(check, &QPushButton::clicked, &model_, [this, pose] { model_.check(pose); });
    check_buttons_.at(static_cast<std::size_t>(pose)) = check;
    row->addWidget(check);
  }
  row->addStretch();
  layout->addLayout(row);
  return page;
}

QWidget* LimbWizard::make_check_page() {
  auto* page = new QWidget(this);
  check_layout_ = new QVBoxLayout(page);
  check_layout_->setContentsMargins(0, 0, 0, 0);
  check_layout_->setSpacing(2 * kGrid);
  check_summary_ = distance_label(page);
  check_summary_->setObjectName(QStringLiteral("check_summary"));
  check_layout_->addWidget(check_summary_);
  check_text_ = paragraph({}, page);
  check_layout_->addWidget(check_text_);
  check_rows_ = new QWidget(page);
  check_layout_->addWidget(check_rows_);
  check_layout_->addStretch();
  return page;
}

void LimbWizard::show_page() {
  frame_->set_note(model_.page() == LimbPage::kChoose || model_.page() == LimbPage::kPrepare
                       ? QString()
                       : model_.desk().recording_note());
  switch (model_.page()) {
    case LimbPage::kChoose:
      refresh_choice();
      frame_->show_page(0);
      break;
    case LimbPage::kPrepare:
      refresh_prepare();
      frame_->show_page(1);
      break;
    case LimbPage::kCountdown:
    case LimbPage::kHold:
      hold_->restart();
      frame_->show_page(2);
      break;
    case LimbPage::kComputing:
      break;  // It takes a moment; the page stays.
    case LimbPage::kResult:
      refresh_results();
      frame_->show_page(3);
      break;
    case LimbPage::kCheck:
      refresh_checks();
      frame_->show_page(4);
      break;
  }
  refresh_buttons();
}

void LimbWizard::leave() {
  if (model_.would_lose()) {
    frame_->ask_leave(model_.page() == LimbPage::kResult || model_.page() == LimbPage::kCheck
                          ? tr("The verdicts of %1 are not saved yet.")
                                .arg(counted_sensors(static_cast<int>(model_.outcomes().size())))
                          : tr("The pose that was held would not be used."));
  } else {
    model_.cancel();
  }
}

}  // namespace limbwave::ui
