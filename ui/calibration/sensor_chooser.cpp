#include "calibration/sensor_chooser.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <algorithm>

#include "common/shown_names.h"
#include "common/theme.h"

namespace limbwave::ui {

namespace {

constexpr int kWidestName = 30 * kGrid;

}  // namespace

QString sensor_title(const body::Rig& rig, int sensor) {
  const body::Accelerometer& accelerometer = rig.accelerometers.at(static_cast<std::size_t>(sensor));
  const QString name = shown_name(accelerometer.name);
  return accelerometer.serial.empty()
             ? name
             : QStringLiteral("%1 · %2").arg(name, QString::fromStdString(accelerometer.serial));
}

SensorChooser::SensorChooser(QWidget* parent) : QWidget(parent), rows_(new QVBoxLayout(this)) {
  rows_->setContentsMargins(0, 0, 0, 0);
  rows_->setSpacing(kGrid / 2);
}

void SensorChooser::set_sensors(const body::Rig& rig, const std::vector<int>& shown, const std::vector<int>& chosen,
                                const std::function<CalibrationState(int)>& state) {
  // The same sensors keep their rows: whoever ticks one with the keyboard keeps the focus.
  if (shown != shown_) {
    for (QCheckBox* check : checks_) {
      check->parentWidget()->hide();
      check->parentWidget()->deleteLater();
    }
    checks_.clear();
    badges_.clear();
    shown_ = shown;
    for (const int sensor : shown) {
      add_row(sensor);
    }
  }
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    const QSignalBlocker blocker(checks_[i]);
    checks_[i]->setText(sensor_title(rig, shown_[i]));
    checks_[i]->setChecked(std::find(chosen.begin(), chosen.end(), shown_[i]) != chosen.end());
    badges_[i]->set_state(state(shown_[i]));
  }
  int widest = 0;  // So that what is said of them stands in one column.
  for (const QCheckBox* check : checks_) {
    widest = std::max(widest, check->sizeHint().width());
  }
  for (QCheckBox* check : checks_) {
    check->setMinimumWidth(std::min(widest, kWidestName));
  }
}

void SensorChooser::add_row(int sensor) {
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* check = new QCheckBox(row);
  check->setObjectName(QStringLiteral("sensor_%1").arg(sensor));
  check->setMinimumHeight(6 * kGrid);
  check->setStyleSheet(QStringLiteral("font-size: 15px;"));
  connect(check, &QCheckBox::toggled, this, [this, sensor](bool on) { Q_EMIT toggled(sensor, on); });
  layout->addWidget(check);
  auto* badge = new VerdictBadge(row);
  badge->setMinimumWidth(260);
  layout->addWidget(badge, 1);
  rows_->addWidget(row);
  checks_.push_back(check);
  badges_.push_back(badge);
}

}  // namespace limbwave::ui
