#include "workspaces/capture/source_bar.h"

#include <QActionGroup>
#include <QComboBox>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>

#include "common/core_services.h"
#include "common/format.h"
#include "common/icons.h"
#include "common/shown_names.h"
#include "common/theme.h"
#include "common/widgets.h"
#include "workspaces/capture/board_dialog.h"
#include "workspaces/capture/device_format.h"

namespace limbwave::ui {
namespace {

constexpr auto kOtherPort = "other-port";

}  // namespace

SourceBar::SourceBar(StudioContext& context, CaptureModel& model, QWidget* parent)
    : QWidget(parent),
      context_(context),
      model_(model),
      devices_(new QComboBox(this)),
      rigs_(new QComboBox(this)),
      refresh_(icon_button(QStringLiteral("refresh"), tr("Look for devices again"), this)),
      format_(new QToolButton(this)),
      format_menu_(new QMenu(format_)),
      board_(icon_button(QStringLiteral("sensor"), tr("Name the sensor board, and say which sensor is worn where"),
                         this)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  auto* device_label = dim_label(tr("&Device"), this);
  device_label->setBuddy(devices_);
  devices_->setObjectName(QStringLiteral("device_box"));
  devices_->setAccessibleName(tr("Device"));
  devices_->setToolTip(tr("Where the signal comes from: a sound card's line input, a driver box, or the simulator"));
  devices_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  devices_->setMinimumContentsLength(16);
  auto* rig_label = dim_label(tr("R&ig"), this);
  rig_label->setBuddy(rigs_);
  rigs_->setObjectName(QStringLiteral("rig_box"));
  rigs_->setAccessibleName(tr("Rig"));
  rigs_->setToolTip(tr("What is worn where"));
  rigs_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  rigs_->setMinimumContentsLength(12);
  refresh_->setObjectName(QStringLiteral("refresh_devices"));
  format_->setObjectName(QStringLiteral("format_button"));
  format_->setPopupMode(QToolButton::InstantPopup);
  format_->setMenu(format_menu_);
  format_->setFocusPolicy(Qt::TabFocus);
  format_menu_->setObjectName(QStringLiteral("format_menu"));
  format_menu_->setToolTipsVisible(true);
  connect(format_menu_, &QMenu::aboutToShow, this, &SourceBar::fill_format_menu);
  layout->addWidget(device_label);
  layout->addWidget(devices_, 3);
  layout->addWidget(refresh_);
  layout->addWidget(format_);
  layout->addSpacing(2 * kGrid);
  layout->addWidget(rig_label);
  layout->addWidget(rigs_, 2);
  board_->setObjectName(QStringLiteral("edit_board"));
  layout->addWidget(board_);
  connect(board_, &QToolButton::clicked, &model_, &CaptureModel::read_board);
  connect(&model_, &CaptureModel::board_ready, this, &SourceBar::edit_board);

  connect(refresh_, &QToolButton::clicked, &model_, &CaptureModel::refresh_devices);
  connect(devices_, &QComboBox::activated, this, [this](int index) {
    const QString id = devices_->itemData(index).toString();
    id == QLatin1String(kOtherPort) ? ask_port() : model_.open_device(id);
  });
  connect(rigs_, &QComboBox::activated, this, [this](int index) { model_.set_rig(rigs_->itemData(index).toString()); });
  connect(&model_, &CaptureModel::devices_changed, this, &SourceBar::refresh);
  connect(&model_, &CaptureModel::setup_changed, this, &SourceBar::refresh);
  connect(&context_.live(), &LiveModel::state_changed, this, &SourceBar::refresh);
  connect(&context_.live(), &LiveModel::recording_changed, this, &SourceBar::refresh);
  connect(&context_.live(), &LiveModel::snapshot_changed, this, &SourceBar::refresh_format);
  refresh();
}

void SourceBar::focus_devices() {
  devices_->setFocus();
}

void SourceBar::edit_board(const body::Rig& rig, const take::Board& board) {
  auto* dialog = new BoardDialog(context_.live().device_title(), rig, board, window());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this,
          [this, dialog, board, device = context_.live().device_id(), name = rig.name] {
            model_.set_board(device, name, board, dialog->board());
          });
  dialog->open();
}

void SourceBar::ask_port() {
  refresh();  // The list shows what is open, not this entry.
  auto* dialog = new QInputDialog(window());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setObjectName(QStringLiteral("port_dialog"));
  dialog->setWindowTitle(tr("Driver box at another port"));
  dialog->setLabelText(tr("Serial port of the driver box, or the link of an emulator:"));
  dialog->setTextValue(QStringLiteral("/dev/ttyACM0"));
  dialog->setOkButtonText(tr("Open"));
  dialog->setCancelButtonText(tr("Cancel"));
  connect(dialog, &QInputDialog::textValueSelected, &model_, &CaptureModel::open_box_port);
  dialog->open();
}

void SourceBar::fill() {
  // Only when there are others: an open list would close under the mouse.
  QStringList wanted{model_.searching() ? tr("Looking for devices…") : tr("Choose a device")};
  for (const acquire::DeviceInfo& device : model_.devices()) {
    wanted << QString::fromStdString(device.id) + QLatin1Char('\n') + QString::fromStdString(device.title);
  }
  if (wanted != listed_devices_) {
    listed_devices_ = wanted;
    devices_->clear();
    devices_->addItem(wanted.first(), QString());
    for (const acquire::DeviceInfo& device : model_.devices()) {
      devices_->addItem(QString::fromStdString(device.title), QString::fromStdString(device.id));
      devices_->setItemData(devices_->count() - 1, QString::fromStdString(device.id), Qt::ToolTipRole);
    }
    devices_->addItem(tr("Driver box at another port…"), QString::fromLatin1(kOtherPort));
  }
  const std::vector<RigChoice> rigs = model_.rigs();
  QStringList wanted_rigs;
  for (const RigChoice& rig : rigs) {
    wanted_rigs << QString::fromStdString(rig.name);
  }
  if (wanted_rigs != listed_rigs_) {
    listed_rigs_ = wanted_rigs;
    rigs_->clear();
    for (const RigChoice& rig : rigs) {
      rigs_->addItem(shown_name(rig.title), QString::fromStdString(rig.name));
      rigs_->setItemData(rigs_->count() - 1,
                         tr("%1 (file %2)").arg(shown_name(rig.title), QString::fromStdString(rig.name)),
                         Qt::ToolTipRole);
    }
  }
}

void SourceBar::refresh() {
  const LiveModel& live = context_.live();
  const QSignalBlocker block_devices(devices_), block_rigs(rigs_);
  fill();
  const int chosen = live.state() == LiveState::kOff ? 0 : devices_->findData(live.device_id());
  devices_->setCurrentIndex(std::max(0, chosen));
  rigs_->setCurrentIndex(rigs_->findData(model_.rig()));
  const bool free = !live.recording() && !live.starting() && !live.finishing();
  devices_->setEnabled(free);
  rigs_->setEnabled(free && rigs_->count() > 0);
  refresh_->setEnabled(free && !model_.searching());
  rigs_->setToolTip(free ? tr("What is worn where: %1").arg(rigs_->currentText())
                         : tr("Stop recording to choose another rig"));
  devices_->setToolTip(
      free ? tr("Where the signal comes from: a sound card's line input, a driver box, or the simulator")
           : tr("Stop recording to choose another device"));
  // The simulator's sensors have serials of their own.
  const LiveModel& running = context_.live();
  board_->setEnabled(free && running.running() && !running.device_id().startsWith(QLatin1String(kSimulatorPrefix)) &&
                     !model_.is_box());
  refresh_format();
}

void SourceBar::refresh_format() {
  const LiveModel& live = context_.live();
  const bool free = !live.recording() && !live.starting() && !live.finishing();
  const acquire::DeviceInfo* device = model_.device();
  // The real format is known with the first samples.
  const QString text = live.snapshot() && live.running() && live.snapshot()->format.rate.hz > 0.0
                           ? format_words(live.snapshot()->format, model_.device_setup())
                           : tr("Format");
  if (format_->text() != text) {
    format_->setText(text);
    format_->setAccessibleName(tr("Sampling rate, sample format and inputs: %1").arg(text));
  }
  // A driver box samples as it is built.
  format_->setVisible(device != nullptr && !model_.is_box());
  board_->setVisible(!model_.is_box());
  format_->setEnabled(free && device != nullptr);
  format_->setToolTip(free ? tr("Sampling rate, sample format and inputs")
                           : tr("Stop recording to choose another format"));
}

void SourceBar::fill_format_menu() {
  format_menu_->clear();
  const acquire::DeviceInfo* device = model_.device();
  if (device == nullptr) {
    return;
  }
  const FormatChoices choices = format_choices(*device, model_.device_setup());
  const auto add = [this](const QString& title, const std::vector<FormatChoice>& list) {
    if (!format_menu_->isEmpty()) {
      format_menu_->addSeparator();
    }
    // A disabled entry as heading: styles do not agree on whether they show a section's title.
    QAction* heading = format_menu_->addAction(title);
    heading->setEnabled(false);
    QFont bold = heading->font();
    bold.setBold(true);
    heading->setFont(bold);
    auto* group = new QActionGroup(format_menu_);
    connect(format_menu_, &QMenu::aboutToHide, group, &QObject::deleteLater);
    for (const FormatChoice& choice : list) {
      QAction* action = format_menu_->addAction(
          choice.why_not.isEmpty() ? choice.text : tr("%1: %2").arg(choice.text, choice.why_not));
      action->setCheckable(true);
      action->setChecked(choice.chosen);
      action->setEnabled(choice.why_not.isEmpty());
      group->addAction(action);
      connect(action, &QAction::triggered, this, [this, setup = choice.setup] { model_.set_device_setup(setup); });
    }
  };
  add(tr("Sampling rate"), choices.rates);
  add(tr("Sample format"), choices.types);
  add(tr("Inputs"), choices.inputs);
}

}  // namespace limbwave::ui
