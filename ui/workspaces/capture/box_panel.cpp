#include "workspaces/capture/box_panel.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLocale>
#include <QSignalBlocker>
#include <cmath>

#include "common/core_text.h"
#include "common/format.h"
#include "common/theme.h"
#include "solve/live_body_session.h"
#include "take/box_opening.h"

namespace limbwave::ui {
namespace {

constexpr auto kChoose = "choose";  // no folder of a take

QDoubleSpinBox* spin(const QString& name, double least, double most, double step, int decimals, const QString& unit,
                     QWidget* parent) {
  auto* box = new QDoubleSpinBox(parent);
  box->setObjectName(name);
  box->setRange(least, most);
  box->setSingleStep(step);
  box->setDecimals(decimals);
  box->setSuffix(unit);
  box->setKeyboardTracking(false);
  box->setButtonSymbols(QAbstractSpinBox::NoButtons);
  return box;
}

}  // namespace

BoxPanel::BoxPanel(StudioContext& context, CaptureModel& model, QWidget* parent)
    : Card(tr("Driver box"), parent),
      context_(context),
      model_(model),
      state_(new QLabel(this)),
      figures_(dim_label({}, this)),
      advice_(new QLabel(this)),
      temperature_(spin(QStringLiteral("box_temperature"), -30.0, 60.0, 0.5, 1, tr(" °C"), this)),
      humidity_(spin(QStringLiteral("box_humidity"), 0.0, 100.0, 5.0, 0, tr(" %"), this)),
      height_(spin(QStringLiteral("box_height"), 0.0, 2.6, 0.01, 2, tr(" m"), this)),
      sources_(new QComboBox(this)) {
  setObjectName(QStringLiteral("box_panel"));
  QFont bold = state_->font();
  bold.setWeight(QFont::DemiBold);
  state_->setFont(bold);
  state_->setObjectName(QStringLiteral("box_state"));
  figures_->setObjectName(QStringLiteral("box_figures"));
  advice_->setObjectName(QStringLiteral("box_advice"));
  advice_->setProperty("role", "warning");
  for (QLabel* label : {state_, figures_, advice_}) {
    label->setWordWrap(true);
    body()->addWidget(label);
  }
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(2 * kGrid);
  form->setVerticalSpacing(kGrid);
  temperature_->setAccessibleName(tr("Temperature of the air"));
  temperature_->setToolTip(tr("The speed of sound follows from it: one degree is 0.2 per cent of every range"));
  humidity_->setAccessibleName(tr("Humidity of the air"));
  humidity_->setToolTip(tr("Relative; it matters little"));
  height_->setAccessibleName(tr("Height of the wearer"));
  height_->setToolTip(tr("Skeleton and places of the boards are scaled to it"));
  height_->setSpecialValueText(tr("as the rig says"));
  form->addRow(dim_label(tr("Air"), this), temperature_);
  form->addRow(dim_label(tr("Humidity"), this), humidity_);
  form->addRow(dim_label(tr("Height"), this), height_);
  sources_->setObjectName(QStringLiteral("box_sources"));
  sources_->setAccessibleName(tr("Delays of the sources"));
  sources_->setToolTip(
      tr("Nominal: every source fires when its slot begins. A take of this box in which they were measured tells "
         "by how much each is late, and its phase and level."));
  sources_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  sources_->setMinimumContentsLength(10);
  form->addRow(dim_label(tr("Sources"), this), sources_);
  connect(sources_, &QComboBox::activated, this, &BoxPanel::choose_sources);
  body()->addLayout(form);
  QLabel* learn = link_label(tr("What the words mean, and what to do"), this);
  learn->setObjectName(QStringLiteral("learn_box"));
  body()->addWidget(learn);
  connect(learn, &QLabel::linkActivated, this,
          [this] { context_.reveal(QStringLiteral("manual"), QStringLiteral("driver-box")); });
  for (QDoubleSpinBox* box : {temperature_, humidity_, height_}) {
    connect(box, &QDoubleSpinBox::valueChanged, this, &BoxPanel::apply);
  }
  connect(&context_.live(), &LiveModel::snapshot_changed, this, &BoxPanel::refresh);
  connect(&context_.live(), &LiveModel::state_changed, this, &BoxPanel::refresh);
  connect(&context_.live(), &LiveModel::recording_changed, this, &BoxPanel::refresh_setup);
  connect(&context_.live(), &LiveModel::state_changed, this, &BoxPanel::refresh_setup);
  connect(&model_, &CaptureModel::setup_changed, this, &BoxPanel::refresh_setup);
  refresh();
  refresh_setup();
}

void BoxPanel::refresh_setup() {
  const DeviceSetup setup = model_.device_setup();
  const QSignalBlocker blocks[] = {QSignalBlocker(temperature_), QSignalBlocker(humidity_), QSignalBlocker(height_)};
  temperature_->setValue(setup.temperature_c);
  humidity_->setValue(setup.humidity);
  height_->setValue(setup.height_m);
  const LiveModel& live = context_.live();
  const bool free = !live.recording() && !live.starting() && !live.finishing();
  for (QWidget* box : std::initializer_list<QWidget*>{temperature_, humidity_, height_, sources_}) {
    box->setEnabled(free);
  }
  const QString take = QString::fromStdString(setup.ranging_take);
  sources_->clear();
  sources_->addItem(tr("Nominal delays"), QString());
  if (!take.isEmpty()) {
    sources_->addItem(tr("As in “%1”").arg(QFileInfo(take).completeBaseName()), take);
    sources_->setItemData(1, take, Qt::ToolTipRole);
    sources_->setCurrentIndex(1);
  }
  sources_->addItem(tr("As in a take…"), QLatin1String(kChoose));
}

void BoxPanel::choose_sources(int index) {
  const QString chosen = sources_->itemData(index).toString();
  if (chosen != QLatin1String(kChoose)) {
    DeviceSetup setup = model_.device_setup();
    setup.ranging_take = chosen.toStdString();
    model_.set_device_setup(setup);
    return;
  }
  refresh_setup();  // Until it is read, what was chosen before is in use.
  const QString folder = QFileDialog::getExistingDirectory(window(), tr("A take of this box with measured sources"),
                                                           context_.takes_folder());
  if (!folder.isEmpty()) {
    use_take(folder);
  }
}

void BoxPanel::use_take(const QString& folder) {
  using Read = calibrate::RangingCalibration;
  context_.jobs().compute<Read>(
      tr("Reading %1").arg(QFileInfo(folder).completeBaseName()), this,
      [folder = folder.toStdString(), rig = model_.rig().toStdString()](const Progress&) -> Result<Read> {
        Result<body::Rig> loaded = body::load_rig(rig);
        return loaded ? take::ranging_of(folder, *loaded) : loaded.error();
      },
      [this, folder](const Result<Read>& read) {
        if (!read) {
          context_.notifications().post_error(tr("The sources stay as they are"), read.error());
          return;
        }
        DeviceSetup setup = model_.device_setup();
        setup.ranging_take = folder.toStdString();
        model_.set_device_setup(setup);
      });
}

void BoxPanel::apply() {
  DeviceSetup setup = model_.device_setup();
  setup.temperature_c = temperature_->value();
  setup.humidity = humidity_->value();
  setup.height_m = height_->value();
  model_.set_device_setup(setup);
}

void BoxPanel::refresh() {
  const auto& snapshot = context_.live().snapshot();
  const solve::LiveBodySnapshot* box = snapshot ? snapshot->box.get() : nullptr;
  const auto set = [](QLabel* label, const QString& text) {
    if (label->text() != text) {
      label->setText(text);
    }
    label->setVisible(!text.isEmpty());
  };
  if (box == nullptr || box->title.empty()) {
    set(state_, tr("Waiting for the box"));
    set(figures_, {});
    set(advice_, {});
    return;
  }
  const QLocale locale;
  set(state_, !box->connected       ? tr("The box is away; it is taken back by itself")
              : !box->error.empty() ? tr("No live figure")
              : !box->started       ? tr("Stand still for a second")
                                    : tr("Live: %1 poses a second").arg(std::lround(box->poses_hz)));
  QStringList lines{QString::fromStdString(box->title)};
  if (box->started) {
    lines << tr("Joints ± %1°, root ± %2 m (1 σ)")
                 .arg(locale.toString(box->joint_sigma_deg, 'f', 1), locale.toString(box->root_sigma.norm(), 'f', 2));
  }
  lines << tr("Gaps: %1, samples lost: %2, reconnections: %3")
               .arg(box->counters.gaps)
               .arg(box->counters.lost_frames)
               .arg(box->counters.reconnects);
  if (box->status.sample > 0) {
    lines << tr("Battery %1 V, %2 °C")
                 .arg(locale.toString(static_cast<double>(box->status.battery_volts), 'f', 1),
                      locale.toString(static_cast<double>(box->status.temperature_c), 'f', 0));
  }
  set(figures_, lines.join(QLatin1Char('\n')));
  QStringList advice;
  if (!box->error.empty()) {
    advice << as_sentence(core_text(box->error));
  }
  for (const Diagnostic& finding : box->diagnostics) {
    if (finding.severity != Severity::kInfo && advice.size() < 3) {
      advice << as_sentence(core_text(finding.message)) +
                    (finding.remedy.empty() ? QString() : QLatin1Char(' ') + as_sentence(core_text(finding.remedy)));
    }
  }
  set(advice_, advice.join(QLatin1Char('\n')));
}

}  // namespace limbwave::ui
