#include "calibration/limb_wizard.h"

#include <QHBoxLayout>

#include "common/theme.h"

namespace limbwave::ui {

LimbWizard::LimbWizard(LimbWizardModel& model, QWidget* parent)
    : CalibrationWizard(model, tr("Calibrate mounting"), false, parent), model_(model) {
  setObjectName(QStringLiteral("limb_wizard"));
  frame()->add_page(make_choose_page());
  frame()->add_page(make_prepare_page());
  hold_ = new LimbHoldPage(model_, this);
  frame()->add_page(hold_);
  frame()->add_page(make_verdict_page());
  frame()->add_page(make_check_page());
  connect(&model_, &WizardModel::page_changed, this, &LimbWizard::show_page);
  connect(&model_, &WizardModel::choice_changed, this, &LimbWizard::refresh_choice);
  connect(&model_, &LimbWizardModel::held, this, &LimbWizard::refresh_buttons);
  // Whoever wears the suit may not see the screen: the last three seconds, the
  // start and the capture are heard.
  connect(&model_, &LimbWizardModel::counted, this, [this](int left) {
    if (left <= 3) {
      sounds().play(left == 0 ? CueSounds::Cue::kGo : CueSounds::Cue::kTick);
    }
  });
  connect(&model_, &LimbWizardModel::captured, this, [this] { sounds().play(CueSounds::Cue::kDone); });
}

QWidget* LimbWizard::make_choose_page() {
  const auto [page, columns, words] = make_columns();
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
  add_source_line(words, page, QStringLiteral("mounting"));
  words->addStretch(1);  // All that is left: the warning is as tall as its words.
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

QWidget* LimbWizard::make_verdict_page() {
  QHBoxLayout* row = nullptr;
  QWidget* page = make_result_page(&row);
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
  show_note(model_.page() != LimbPage::kChoose && model_.page() != LimbPage::kPrepare);
  switch (model_.page()) {
    case LimbPage::kChoose:
      refresh_choice();
      frame()->show_page(0);
      break;
    case LimbPage::kPrepare:
      refresh_prepare();
      frame()->show_page(1);
      break;
    case LimbPage::kCountdown:
    case LimbPage::kHold:
      hold_->restart();
      frame()->show_page(2);
      break;
    case LimbPage::kComputing:
      break;  // It takes a moment; the page stays.
    case LimbPage::kResult:
      refresh_results();
      frame()->show_page(3);
      break;
    case LimbPage::kCheck:
      refresh_checks();
      frame()->show_page(4);
      break;
  }
  refresh_buttons();
}

QString LimbWizard::movement_lost() const {
  return tr("The pose that was held would not be used.");
}

}  // namespace limbwave::ui
