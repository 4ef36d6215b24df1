#include "workspaces/calibrate_history.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QScrollArea>

#include "calibration/gauges.h"
#include "common/core_text.h"
#include "common/shown_names.h"
#include "common/theme.h"
#include "common/widgets.h"

namespace limbwave::ui {

CalibrateHistory::CalibrateHistory(CalibrationDesk& desk, QWidget* parent)
    : QWidget(parent),
      desk_(desk),
      title_(new QLabel(this)),
      serial_(dim_label({}, this)),
      entries_(new QVBoxLayout),
      folder_(dim_label({}, this)) {
  setObjectName(QStringLiteral("calibrate_history"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2 * kGrid, kGrid, 2 * kGrid, 2 * kGrid);
  layout->setSpacing(kGrid / 2);
  title_->setStyleSheet(QStringLiteral("font-size: 18px;"));
  title_->setWordWrap(true);
  layout->addWidget(title_);
  serial_->setWordWrap(true);
  layout->addWidget(serial_);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* content = new QWidget(scroll);
  content->setProperty("scroll", true);
  content->setLayout(entries_);
  entries_->setContentsMargins(0, kGrid, 0, 0);
  entries_->addStretch();
  scroll->setWidget(content);
  layout->addWidget(scroll, 1);
  folder_->setWordWrap(true);
  folder_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  layout->addWidget(folder_);
  connect(&desk_, &CalibrationDesk::changed, this, &CalibrateHistory::refresh);
  connect(&desk_.context().selection(), &Selection::changed, this, &CalibrateHistory::refresh);
  refresh();
}

void CalibrateHistory::refresh() {
  if (list_ != nullptr) {
    list_->hide();
    list_->deleteLater();
  }
  list_ = new QWidget(this);
  list_layout_ = new QVBoxLayout(list_);
  list_layout_->setContentsMargins(0, 0, 0, 0);
  list_layout_->setSpacing(kGrid);
  entries_->insertWidget(0, list_);
  // A path breaks where it may: after its slashes.
  folder_->setText(tr("Library: %1")
                       .arg(QString::fromStdString(desk_.library().folder().string())
                                .replace(QLatin1Char('/'), QStringLiteral("/\u200b"))));
  const int sensor = desk_.context().selection().index_of(SelectionKind::kSensor);
  if (!desk_.has_rig() || sensor < 0 || sensor >= static_cast<int>(desk_.rig().accelerometers.size())) {
    title_->setText(tr("History"));
    serial_->setText(tr("Select a sensor to see its calibrations."));
    return;
  }
  const auto at = static_cast<std::size_t>(sensor);
  const body::Rig& rig = desk_.rig();
  const body::Accelerometer& accelerometer = rig.accelerometers[at];
  title_->setText(shown_name(accelerometer.name));
  serial_->setText(accelerometer.serial.empty() ? tr("No serial: known by its place on the board.")
                                                : tr("Serial %1").arg(QString::fromStdString(accelerometer.serial)));
  list_layout_->addWidget(heading_label(tr("Range"), list_));
  int count = 0;
  const std::string key = take::sensor_key(rig, accelerometer);
  for (const take::SensorRecord& record : desk_.listing().sensors) {
    if (record.key == key) {
      add_entry(range_state(record.calibration), desk_.calibration().sensors.at(at).date == record.calibration.date,
                [this, record] { desk_.use_record(record); });
      ++count;
    }
  }
  if (count == 0) {
    list_layout_->addWidget(dim_label(tr("none yet"), list_));
  }
  list_layout_->addSpacing(kGrid);
  list_layout_->addWidget(heading_label(tr("Mounting"), list_));
  count = 0;
  for (const take::MountRecord& record : desk_.listing().mounts) {
    for (const calibrate::MountCalibration& mount : record.mounts) {
      if (record.rig == rig.name && record.subject == desk_.wearer().toStdString() &&
          mount.sensor == accelerometer.name) {
        take::MountRecord own = record;
        own.mounts = {mount};
        add_entry(mount_state(mount), desk_.calibration().mounts.at(at).date == mount.date,
                  [this, own] { desk_.use_record(own); });
        ++count;
      }
    }
  }
  if (count == 0) {
    list_layout_->addWidget(dim_label(tr("none yet"), list_));
  }
  for (const Diagnostic& diagnostic : desk_.listing().diagnostics) {
    auto* label = new QLabel(core_text(diagnostic.place + ": " + diagnostic.message), list_);
    label->setWordWrap(true);
    list_layout_->addWidget(label);
  }
}

void CalibrateHistory::add_entry(const CalibrationState& state, bool in_use, std::function<void()> use) {
  auto* row = new QWidget(list_);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* badge = new VerdictBadge(row);
  badge->setMinimumWidth(1);
  badge->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  // The place is narrow: method and date on the badge's second line, the date alone where that is long.
  CalibrationState brief = state;
  brief.detail = state.detail.section(QStringLiteral(", "), -1);
  badge->set_state(brief);
  badge->setToolTip(state.detail);
  badge->setFixedHeight(44);
  layout->addWidget(badge, 1);
  if (in_use) {
    layout->addWidget(dim_label(tr("in use"), row));
  } else {
    auto* button = new QPushButton(tr("Use"), row);
    button->setToolTip(tr("Go back to this calibration"));
    // The list is rebuilt while the button is still being clicked; that is why rows are deleted later.
    connect(button, &QPushButton::clicked, this, [use = std::move(use)] { use(); });
    layout->addWidget(button);
  }
  list_layout_->addWidget(row);
}

}  // namespace limbwave::ui
