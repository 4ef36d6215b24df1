#include "calibration/calibration_wizard.h"

#include <QHBoxLayout>
#include <QScrollArea>

#include "common/core_text.h"
#include "common/format.h"
#include "common/icons.h"
#include "common/theme.h"

namespace limbwave::ui {

CalibrationWizard::CalibrationWizard(WizardModel& model, const QString& title, bool with_map, QWidget* parent)
    : QWidget(parent),
      shared_(model),
      frame_(new WizardFrame(title, this)),
      sounds_(model.desk().context().settings()),
      sound_button_(icon_button(QStringLiteral("sound"), tr("Sounds"), this)),
      with_map_(with_map) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(frame_);
  sound_button_->setObjectName(QStringLiteral("sounds"));
  sound_button_->setCheckable(true);
  frame_->add_tool(sound_button_);
  auto* test_sound = new QPushButton(tr("Test the sound"), this);
  test_sound->setObjectName(QStringLiteral("test_sound"));
  test_sound->setProperty("flat", true);
  test_sound->setToolTip(tr("Plays the end of a countdown through the computer's output"));
  frame_->add_tool(test_sound);
  connect(test_sound, &QPushButton::clicked, &sounds_, &CueSounds::test);
  connect(&sounds_, &CueSounds::tested, this, [this](const Status& status) {
    frame_->set_note(status ? tr("Three sounds were played: two short ones, then a long one for “hold still”.")
                            : tr("No sound can be played: %1")
                                  .arg(as_sentence(core_text(status.error().message)) + QLatin1Char(' ') +
                                       as_sentence(core_text(status.error().remedy))));
  });
  connect(sound_button_, &QToolButton::toggled, this, [this](bool on) { sounds_.set_muted(!on); });
  connect(&sounds_, &CueSounds::muted_changed, this, &CalibrationWizard::refresh_sound_button);
  refresh_sound_button();

  connect(frame_, &WizardFrame::next, &shared_, &WizardModel::next);
  connect(frame_, &WizardFrame::back, &shared_, &WizardModel::back);
  connect(frame_, &WizardFrame::cancel, this, &CalibrationWizard::leave);
  connect(frame_, &WizardFrame::leave_anyway, &shared_, &WizardModel::cancel);
  connect(&shared_, &WizardModel::outcomes_changed, this, &CalibrationWizard::refresh_results);
  connect(&shared_, &WizardModel::device_lost, this, [this] { sounds_.play(CueSounds::Cue::kLost); });
  connect(&shared_, &WizardModel::save_failed, this,
          [this](const QString& text) { frame_->set_note(tr("Not saved: %1").arg(text)); });
  connect(&shared_.desk(), &CalibrationDesk::recording_note_changed, this,
          [this] { frame_->set_note(shared_.desk().recording_note()); });
}

void CalibrationWizard::refresh_sound_button() {
  const QSignalBlocker blocker(sound_button_);
  const bool on = !sounds_.muted();
  sound_button_->setChecked(on);
  sound_button_->setIcon(icon(on ? QStringLiteral("sound") : QStringLiteral("mute")));
  const QString words = on ? tr("Sounds are on: the countdown is heard. Press to mute.")
                           : tr("Sounds are off. Press to hear the countdown.");
  sound_button_->setToolTip(words);
  sound_button_->setAccessibleName(words);
}

QLabel* CalibrationWizard::paragraph(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setWordWrap(true);
  label->setStyleSheet(QStringLiteral("font-size: 16px;"));
  return label;
}

CalibrationWizard::Columns CalibrationWizard::make_columns() {
  Columns columns{new QWidget(this), nullptr, new QVBoxLayout};
  columns.both = new QHBoxLayout(columns.page);
  columns.both->setContentsMargins(0, 0, 0, 0);
  columns.both->setSpacing(4 * kGrid);
  columns.words->setSpacing(2 * kGrid);
  return columns;
}

void CalibrationWizard::add_source_line(QVBoxLayout* words, QWidget* page, const QString& chapter) {
  source_line_ = paragraph({}, page);
  words->addWidget(source_line_);
  open_device_ = new QPushButton(tr("Open a device in Capture"), page);
  connect(open_device_, &QPushButton::clicked, this, &CalibrationWizard::device_wanted);
  words->addWidget(open_device_, 0, Qt::AlignLeft);
  QLabel* learn = link_label(tr("Learn how"), page);
  words->addWidget(learn, 0, Qt::AlignLeft);
  connect(learn, &QLabel::linkActivated, this,
          [this, chapter] { shared_.desk().context().reveal(QStringLiteral("manual"), chapter); });
}

QWidget* CalibrationWizard::make_result_page(QHBoxLayout** buttons) {
  auto* page = new QWidget(this);
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2 * kGrid);
  summary_ = distance_label(page);
  summary_->setObjectName(QStringLiteral("summary"));
  layout->addWidget(summary_);
  findings_ = paragraph({}, page);
  findings_->setObjectName(QStringLiteral("findings"));
  findings_->hide();
  layout->addWidget(findings_);
  auto* scroll = new QScrollArea(page);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* content = new QWidget(scroll);
  content->setProperty("scroll", true);
  rows_layout_ = new QVBoxLayout(content);
  rows_layout_->setContentsMargins(0, 0, 0, 0);
  rows_layout_->setSpacing(kGrid);
  rows_layout_->addStretch(1);
  scroll->setWidget(content);
  layout->addWidget(scroll, 1);
  *buttons = new QHBoxLayout;
  (*buttons)->setSpacing(kGrid);
  layout->addLayout(*buttons);
  return page;
}

void CalibrationWizard::set_findings(const QString& text) {
  findings_->setText(text);
  findings_->setVisible(!text.isEmpty());
}

void CalibrationWizard::refresh_results() {
  const int count = shared_.count();
  bool same = static_cast<int>(rows_.size()) == count;
  for (int i = 0; same && i < count; ++i) {
    same = row(i)->sensor() == shared_.outcome(i).sensor;
  }
  if (!same) {
    for (VerdictRow* old : rows_) {
      old->hide();
      old->deleteLater();
    }
    rows_.clear();
    for (int i = 0; i < count; ++i) {
      auto* fresh = new VerdictRow(shared_.outcome(i).sensor, with_map_, this);
      connect(fresh, &VerdictRow::accept, &shared_, [this](int s) { shared_.decide(s, Decision::kAccepted); });
      connect(fresh, &VerdictRow::discard, &shared_, [this](int s) { shared_.decide(s, Decision::kDiscarded); });
      connect(fresh, &VerdictRow::repeat, &shared_, &WizardModel::repeat);
      rows_layout_->insertWidget(rows_layout_->count() - 1, fresh);
      rows_.push_back(fresh);
    }
  }
  for (int i = 0; i < count; ++i) {
    row(i)->set_content(row_content(i));
  }
  const int bad = shared_.bad();
  summary_->setText(bad == 0       ? tr("%1 calibrated").arg(counted_sensors(count))
                    : bad == count ? tr("Repeat")
                                   : tr("%1 of %2 calibrated, repeat the others").arg(count - bad).arg(count));
  refresh_own_results();
  refresh_buttons();
}

void CalibrationWizard::refresh_buttons() {
  const bool running = shared_.desk().source().running();
  open_device_->setVisible(!running);
  source_line_->setText(running ? tr("Signal: <b>%1</b>").arg(shared_.desk().source().title().toHtmlEscaped())
                                : tr("<b>No signal comes in.</b>"));
  refresh_own_buttons();
}

void CalibrationWizard::show_note(bool relevant) {
  frame_->set_note(relevant && !shared_.from_take() ? shared_.desk().recording_note() : QString());
}

void CalibrationWizard::leave() {
  if (!shared_.would_lose()) {
    shared_.cancel();
    return;
  }
  frame_->ask_leave(on_verdicts() ? tr("The verdicts of %1 are not saved yet.").arg(counted_sensors(shared_.count()))
                                  : movement_lost());
}

}  // namespace limbwave::ui
