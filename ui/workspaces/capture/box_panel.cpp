#include "workspaces/capture/box_panel.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLocale>
#include <QSignalBlocker>
#include <cmath>

#include "common/core_text.h"
#include "common/format.h"
#include "common/theme.h"
#include "solve/live_body_session.h"

namespace limbwave::ui {
namespace {

QDoubleSpinBox* spin(const QString& name, double least, double most, double step, int decimals, const QString& unit,
                     QWidget* parent) {
  auto* box = new QDoubleSpinBox(parent);
  box->setObjectName(name);
  box->setRange(least, most);
  box->setSingleStep(step);
  box->setDecimals(decimals);
  box->setSuffix(unit);
  box->setKeyboardTracking(false);
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
      height_(spin(QStringLiteral("box_height"), 0.0, 2.6, 0.01, 2, tr(" m"), this)) {
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
  body()->addLayout(form);
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
  for (QDoubleSpinBox* box : {temperature_, humidity_, height_}) {
    box->setEnabled(free);
  }
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
