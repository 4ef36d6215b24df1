#include "workspaces/capture/record_panel.h"

#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QShortcut>

#include "calibration/calibration_words.h"
#include "common/format.h"
#include "common/health_text.h"
#include "common/icons.h"
#include "common/theme.h"

namespace limbwave::ui {

RecordPanel::RecordPanel(StudioContext& context, CaptureModel& model, QWidget* parent)
    : Card({}, parent),
      context_(context),
      model_(model),
      time_(new QLabel(this)),
      state_(dim_label({}, this)),
      record_(new QPushButton(this)),
      later_(new QPushButton(tr("Record in %1 s").arg(CaptureModel::kCountdown_s), this)),
      subject_(new QLineEdit(this)),
      name_(new QLineEdit(this)),
      name_problem_(new QLabel(this)),
      calibration_(new QLabel(this)),
      folder_(new ElidedLabel({}, this)),
      disk_(dim_label({}, this)) {
  time_->setFont(tabular(time_->font(), 64.0 / 13.0, QFont::Light));
  time_->setAlignment(Qt::AlignCenter);
  time_->setAccessibleName(tr("Recorded time"));
  time_->setObjectName(QStringLiteral("record_time"));
  time_->setMinimumHeight(72);
  state_->setAlignment(Qt::AlignCenter);
  record_->setMinimumHeight(48);
  record_->setIconSize(QSize(20, 20));
  record_->setObjectName(QStringLiteral("record_button"));
  QFont larger = record_->font();
  larger.setPixelSize(16);
  record_->setFont(larger);
  body()->addWidget(time_);
  body()->addWidget(state_);
  body()->addWidget(record_);
  later_->setObjectName(QStringLiteral("record_later"));
  later_->setToolTip(tr("Counts down aloud before it records, for people alone in the suit (Shift+R)"));
  body()->addWidget(later_);

  auto* form = new QFormLayout;
  form->setHorizontalSpacing(2 * kGrid);
  form->setVerticalSpacing(kGrid);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  subject_->setObjectName(QStringLiteral("subject_edit"));
  subject_->setAccessibleName(tr("Subject"));
  subject_->setPlaceholderText(tr("Who wears the sensors"));
  subject_->setMaxLength(200);
  subject_->setText(model_.subject());
  name_->setObjectName(QStringLiteral("take_name_edit"));
  name_->setAccessibleName(tr("Name of the take"));
  name_->setMaxLength(200);
  form->addRow(dim_label(tr("Subject"), this), subject_);
  form->addRow(dim_label(tr("Take"), this), name_);
  body()->addLayout(form);
  name_problem_->setWordWrap(true);
  name_problem_->setProperty("role", "danger");
  name_problem_->setObjectName(QStringLiteral("take_name_problem"));
  body()->addWidget(name_problem_);
  calibration_->setWordWrap(true);
  calibration_->setObjectName(QStringLiteral("calibration_in_use"));
  calibration_->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
  calibration_->setAccessibleName(tr("Calibration of the next take"));
  body()->addWidget(calibration_);
  connect(calibration_, &QLabel::linkActivated, this, [this] { context_.reveal(QStringLiteral("calibrate")); });
  connect(&context_.live(), &LiveModel::calibration_changed, this, &RecordPanel::refresh);

  auto* disk_row = new QHBoxLayout;
  disk_row->setSpacing(kGrid);
  folder_->setProperty("role", "dim");
  auto* choose = icon_button(QStringLiteral("folder"), tr("Choose the folder for takes"), this);
  disk_row->addWidget(choose);
  disk_row->addWidget(folder_, 1);
  disk_row->addWidget(disk_);
  body()->addLayout(disk_row);

  connect(choose, &QToolButton::clicked, this, &RecordPanel::choose_folder);
  connect(record_, &QPushButton::clicked, &model_, &CaptureModel::toggle_recording);
  connect(later_, &QPushButton::clicked, &model_, &CaptureModel::toggle_countdown);
  connect(&model_, &CaptureModel::countdown_changed, this, &RecordPanel::refresh);
  // Done with a name, the keys are commands again: R records.
  setFocusPolicy(Qt::ClickFocus);
  setAccessibleName(tr("Recording"));
  for (QLineEdit* edit : {subject_, name_}) {
    connect(edit, &QLineEdit::returnPressed, this, [this] { setFocus(); });
    auto* escape = new QShortcut(Qt::Key_Escape, edit);
    escape->setContext(Qt::WidgetShortcut);
    connect(escape, &QShortcut::activated, this, [this] { setFocus(); });
  }
  connect(subject_, &QLineEdit::textEdited, &model_, &CaptureModel::set_subject);
  connect(name_, &QLineEdit::textEdited, &model_, &CaptureModel::set_take_name);
  connect(&model_, &CaptureModel::setup_changed, this, &RecordPanel::refresh);
  connect(&context_.live(), &LiveModel::recording_changed, this, &RecordPanel::refresh);
  connect(&context_.live(), &LiveModel::state_changed, this, &RecordPanel::refresh);
  connect(&context_.live(), &LiveModel::snapshot_changed, this, &RecordPanel::refresh_time);
  connect(&context_, &StudioContext::disk_changed, this, &RecordPanel::refresh_time);
  refresh();
}

void RecordPanel::focus_record() {
  record_->setFocus();
}

void RecordPanel::choose_folder() {
  const QString folder = QFileDialog::getExistingDirectory(window(), tr("Folder for takes"), context_.takes_folder());
  if (!folder.isEmpty()) {
    model_.set_takes_folder(folder);
  }
}

void RecordPanel::refresh() {
  const LiveModel& live = context_.live();
  const bool aside = live.recording() && live.aside();
  const bool recording = live.recording() && !aside;
  const bool busy = live.starting() || live.finishing() || aside;
  const bool counting = model_.countdown() > 0;
  record_->setText(counting ? tr("Cancel") : recording ? tr("Stop") : tr("Record"));
  record_->setAccessibleName(counting ? tr("Cancel the countdown") : recording ? tr("Stop recording") : tr("Record"));
  record_->setIcon(recording || counting ? icon(QStringLiteral("stop")) : accent_icon(QStringLiteral("record")));
  later_->setVisible(!recording && !busy);
  later_->setEnabled(!counting && model_.can_record());
  set_style_property(record_, "primary", !recording);
  record_->setEnabled(recording ? !busy : model_.can_record());
  subject_->setEnabled(!recording && !busy);
  name_->setEnabled(!recording && !busy);
  if (subject_->text() != model_.subject()) {
    subject_->setText(model_.subject());
  }
  if (name_->text() != model_.take_name()) {
    name_->setText(model_.take_name());
    name_->setCursorPosition(0);
  }
  name_->setToolTip(model_.take_folder());
  const QString problem = recording || busy ? QString() : model_.take_name_problem();
  name_problem_->setText(problem);
  name_problem_->setVisible(!problem.isEmpty());
  folder_->set_text(context_.takes_folder());
  const CalibrationLine calibration = calibration_line(live.settings().calibration, live.wearer());
  calibration_->setVisible(live.state() == LiveState::kRunning && !model_.is_box());
  calibration_->setText(calibration.whole ? calibration.text
                                          : tr("%1 <a href=\"calibrate\">Calibrate</a>").arg(calibration.text));
  set_style_property(calibration_, "role", calibration.whole ? QStringLiteral("dim") : QStringLiteral("warning"));
  record_->setToolTip(recording                             ? tr("Stop recording and close the take (R)")
                      : model_.can_record()                 ? tr("Record a new take (R)")
                      : live.state() != LiveState::kRunning ? tr("Choose a device first")
                                                            : problem);
  refresh_time();
}

void RecordPanel::refresh_time() {
  const LiveModel& live = context_.live();
  const auto& snapshot = live.snapshot();
  const bool aside = live.aside() && (live.recording() || live.starting() || live.finishing());
  const bool recording = live.recording() && !aside;
  const int countdown = model_.countdown();
  time_->setText(countdown > 0 ? QString::number(countdown)
                               : format_clock_tenths(recording && snapshot ? snapshot->recorded_s : 0.0));
  time_->setForegroundRole(recording || countdown > 0 ? QPalette::Text : QPalette::PlaceholderText);
  const Loss loss = recording && snapshot ? loss_of(*snapshot) : Loss::kNone;
  if (loss != Loss::kNone) {
    state_->setText(loss == Loss::kNow ? tr("Recording, but samples are being lost")
                                       : tr("Recording; samples were lost"));
  } else {
    state_->setText(aside                                 ? tr("A calibration is under way")
                    : recording                           ? tr("Recording")
                    : countdown > 0                       ? tr("Recording begins in %n second(s)", nullptr, countdown)
                    : live.finishing()                    ? tr("Closing the take")
                    : live.starting()                     ? tr("Making the take")
                    : model_.can_record()                 ? tr("Ready")
                    : live.state() == LiveState::kOpening ? tr("Opening the device")
                    : live.state() == LiveState::kRunning ? tr("Not ready")
                                                          : tr("No device"));
  }
  const double disk_left_s = context_.disk_left_s();
  disk_->setText(disk_left_s >= 0.0 ? tr("disk: %1").arg(format_left(disk_left_s)) : tr("disk: –"));
  disk_->setToolTip(tr("How long recording lasts until the disk is full"));
  const bool can = recording || model_.can_record();
  if (record_->isEnabled() != can && !live.starting() && !live.finishing()) {
    refresh();
  }
}

}  // namespace limbwave::ui
