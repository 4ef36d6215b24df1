#include "workspaces/calibrate_overview.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPainter>
#include <QScrollArea>
#include <algorithm>
#include <utility>

#include "common/icons.h"
#include "common/shown_names.h"
#include "common/theme.h"

namespace limbwave::ui {
namespace {

constexpr int kNameWidth = 20 * kGrid;
constexpr int kBadgeWidth = 29 * kGrid;
constexpr int kRepeatWidth = 13 * kGrid;

bool calibrated(const std::string& method) {
  return !method.empty() && method != "nominal";
}

bool in_a_group(const body::Rig& rig, int sensor) {
  return std::any_of(rig.groups.begin(), rig.groups.end(), [sensor](const body::CalibrationGroup& group) {
    return std::find(group.sensors.begin(), group.sensors.end(), sensor) != group.sensors.end();
  });
}

}  // namespace

CalibrationSummary summarize(const body::Rig& rig, const calibrate::RigCalibration& calibration) {
  CalibrationSummary summary;
  const auto count = static_cast<int>(rig.accelerometers.size());
  int mountable = 0;
  QStringList bad;
  for (int s = 0; s < count; ++s) {
    const auto at = static_cast<std::size_t>(s);
    const calibrate::SensorCalibration& range = calibration.sensors.at(at);
    const calibrate::MountCalibration& mount = calibration.mounts.at(at);
    mountable += in_a_group(rig, s) ? 1 : 0;
    summary.ranges += calibrated(range.method) ? 1 : 0;
    summary.mounts += calibrated(mount.method) ? 1 : 0;
    if ((calibrated(range.method) && range_verdict(range) == calibrate::Verdict::kRepeat) ||
        (calibrated(mount.method) && mount_verdict(mount) == calibrate::Verdict::kRepeat)) {
      bad << shown_name(rig.accelerometers[at].name);
    }
  }
  summary.headline = summary.ranges == count && summary.mounts >= mountable && bad.isEmpty()
                         ? CalibrateOverview::tr("Everything is calibrated")
                         : CalibrateOverview::tr("Range: %1 of %3.  Mounting: %2 of %3.")
                               .arg(summary.ranges)
                               .arg(summary.mounts)
                               .arg(count);
  if (summary.ranges < count) {
    summary.next = CalibrateOverview::tr(
        "Next: calibrate the range, once in a sensor's life. Uncalibrated sensors may point 6° or more beside the "
        "truth.");
  } else if (summary.mounts < mountable) {
    summary.next = CalibrateOverview::tr("Next: put the sensors on and calibrate the mounting.");
  } else if (!bad.isEmpty()) {
    summary.next = CalibrateOverview::tr("Repeat: %1.").arg(bad.join(CalibrateOverview::tr(", ")));
  } else {
    summary.next =
        CalibrateOverview::tr("Calibrate the mounting again whenever the sensors are put on anew or have slipped.");
  }
  return summary;
}

SensorRow::SensorRow(int sensor, QWidget* parent)
    : QFrame(parent),
      sensor_(sensor),
      title_(new QLabel(this)),
      serial_(dim_label({}, this)),
      range_(new VerdictBadge(this)),
      mount_(new VerdictBadge(this)),
      repeat_range_(new QPushButton(this)),
      repeat_mount_(new QPushButton(this)) {
  setProperty("card", true);
  setObjectName(QStringLiteral("row_%1").arg(sensor));
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::PointingHandCursor);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(2 * kGrid, kGrid, 2 * kGrid, kGrid);
  layout->setSpacing(2 * kGrid);
  auto* names = new QVBoxLayout;
  names->setSpacing(2);
  title_->setStyleSheet(QStringLiteral("font-size: 16px;"));
  names->addStretch();
  names->addWidget(title_);
  names->addWidget(serial_);
  names->addStretch();
  auto* name_box = new QWidget(this);
  name_box->setLayout(names);
  names->setContentsMargins(0, 0, 0, 0);
  name_box->setFixedWidth(kNameWidth - 2 * kGrid);
  layout->addWidget(name_box);
  const auto add = [&](VerdictBadge* badge, QPushButton* button, const QString& name) {
    badge->setMinimumWidth(kBadgeWidth - kRepeatWidth);
    layout->addWidget(badge, 1);
    button->setObjectName(name);
    // As wide as the longer of the two verbs in this language, so that all rows look alike.
    int width = kRepeatWidth;
    for (const QString& verb : {tr("Calibrate"), tr("Repeat")}) {
      button->setText(verb);
      width = std::max(width, button->sizeHint().width());
    }
    button->setFixedWidth(width);
    layout->addWidget(button);
  };
  add(range_, repeat_range_, QStringLiteral("range_%1").arg(sensor));
  add(mount_, repeat_mount_, QStringLiteral("mount_%1").arg(sensor));
  connect(repeat_range_, &QPushButton::clicked, this, [this] { Q_EMIT range_wanted(sensor_); });
  connect(repeat_mount_, &QPushButton::clicked, this, [this] { Q_EMIT mount_wanted(sensor_); });
}

void SensorRow::set_content(const QString& title, const QString& serial, const CalibrationState& range,
                            const CalibrationState& mount, bool mountable) {
  title_->setText(title);
  serial_->setText(serial);
  range_->set_state(range);
  mount_->set_state(mount);
  setAccessibleName(tr("%1: range %2, mounting %3").arg(title, range_->text(), mount_->text()));
  const auto verb = [](const CalibrationState& state) {
    return state.tone == Tone::kUnknown ? tr("Calibrate") : tr("Repeat");
  };
  repeat_range_->setText(verb(range));
  repeat_range_->setToolTip(tr("Range of %1 only").arg(title));
  repeat_mount_->setText(verb(mount));
  repeat_mount_->setEnabled(mountable);
  repeat_mount_->setToolTip(mountable ? tr("Mounting of %1 only").arg(title)
                                      : tr("The rig names no poses for this sensor."));
}

void SensorRow::set_selected(bool selected) {
  selected_ = selected;
  update();
}

void SensorRow::mousePressEvent(QMouseEvent*) {
  Q_EMIT chosen(sensor_);
}

void SensorRow::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Space || event->key() == Qt::Key_Return) {
    Q_EMIT chosen(sensor_);
  } else {
    QFrame::keyPressEvent(event);
  }
}

void SensorRow::paintEvent(QPaintEvent* event) {
  QFrame::paintEvent(event);
  const ThemeColors& theme = theme_colors(palette());
  QPainter painter(this);
  if (selected_) {
    painter.fillRect(QRect(0, 6, 3, height() - 12), theme.accent);
  }
  if (hasFocus()) {
    painter.setPen(theme.accent);
    painter.drawRoundedRect(rect().adjusted(0, 0, -1, -1), 6, 6);
  }
}

CalibrateOverview::CalibrateOverview(CalibrationDesk& desk, QWidget* parent)
    : QWidget(parent),
      desk_(desk),
      headline_(new QLabel(this)),
      subline_(dim_label({}, this)),
      range_(new QPushButton(tr("Calibrate range"), this)),
      mount_(new QPushButton(tr("Calibrate mounting"), this)),
      from_take_(new QPushButton(tr("From a recording"), this)),
      library_(new QPushButton(tr("Use the library's calibration"), this)),
      rows_layout_(nullptr) {
  setObjectName(QStringLiteral("calibrate_overview"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(3 * kGrid, 2 * kGrid, 3 * kGrid, 2 * kGrid);
  layout->setSpacing(kGrid);
  headline_->setStyleSheet(QStringLiteral("font-size: 24px;"));
  headline_->setObjectName(QStringLiteral("headline"));
  layout->addWidget(headline_);
  subline_->setWordWrap(true);
  layout->addWidget(subline_);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kGrid);
  buttons->setContentsMargins(0, kGrid, 0, kGrid);
  range_->setObjectName(QStringLiteral("calibrate_range"));
  mount_->setObjectName(QStringLiteral("calibrate_mounting"));
  from_take_->setObjectName(QStringLiteral("from_take"));
  library_->setObjectName(QStringLiteral("use_library"));
  for (QPushButton* button : {range_, mount_, from_take_, library_}) {
    buttons->addWidget(button);
  }
  buttons->addStretch();
  layout->addLayout(buttons);

  auto* titles = new QHBoxLayout;
  titles->setContentsMargins(2 * kGrid, 0, 2 * kGrid, 0);
  titles->setSpacing(2 * kGrid);
  auto* sensor_title_label = heading_label(tr("Sensor"), this);
  sensor_title_label->setFixedWidth(kNameWidth - 2 * kGrid);
  titles->addWidget(sensor_title_label);
  titles->addWidget(heading_label(tr("Range: residual of gravity"), this), 1);
  titles->addWidget(heading_label(tr("Mounting: angle between the poses, 90° is right"), this), 1);
  layout->addLayout(titles);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  auto* content = new QWidget(scroll);
  content->setProperty("scroll", true);
  rows_layout_ = new QVBoxLayout(content);
  rows_layout_->setContentsMargins(0, 0, 0, 0);
  rows_layout_->setSpacing(kGrid / 2);
  rows_layout_->addStretch(1);
  scroll->setWidget(content);
  layout->addWidget(scroll, 1);

  connect(range_, &QPushButton::clicked, this, [this] { Q_EMIT range_wanted({}); });
  connect(mount_, &QPushButton::clicked, this, [this] { Q_EMIT mount_wanted(-1, false); });
  connect(library_, &QPushButton::clicked, &desk_, &CalibrationDesk::use_library);
  from_take_->setToolTip(tr("Calibrate from a stretch of a take in which sensors were turned or poses held"));
  connect(from_take_, &QPushButton::clicked, this, &CalibrateOverview::recording_wanted);
  connect(&desk_, &CalibrationDesk::changed, this, &CalibrateOverview::refresh);
  connect(&desk_.context().selection(), &Selection::changed, this, &CalibrateOverview::refresh_rows);
  refresh();
}

void CalibrateOverview::refresh() {
  if (!desk_.has_rig()) {
    return;
  }
  int from_solve = 0;
  const CalibrationSummary summary = summarize(desk_.rig(), shown(&from_solve));
  headline_->setText(summary.headline);
  const QString where = desk_.subject() == CalibrationDesk::Subject::kLive
                            ? tr("Running capture: %1.").arg(desk_.source().title())
                            : tr("Take: %1.").arg(desk_.context().document().name());
  const QString wearer = desk_.wearer().isEmpty() ? QString() : tr(" Worn by %1.").arg(desk_.wearer());
  const QString found = from_solve == 0 ? QString()
                                        : tr(" What the take does not carry, its solve took from the take's own "
                                             "calibration movements or from the library.");
  subline_->setText(where + wearer + found + QLatin1Char(' ') + summary.next);
  const bool ranges_first = summary.ranges < static_cast<int>(desk_.rig().accelerometers.size());
  set_style_property(range_, "primary", ranges_first);
  set_style_property(mount_, "primary", !ranges_first);
  refresh_sources();
  refresh_rows();
}

void CalibrateOverview::set_used(std::optional<calibrate::RigCalibration> used) {
  used_ = std::move(used);
  refresh();
}

calibrate::RigCalibration CalibrateOverview::shown(int* from_solve) const {
  calibrate::RigCalibration shown = desk_.calibration();
  if (desk_.subject() != CalibrationDesk::Subject::kTake || !used_ || used_->sensors.size() != shown.sensors.size() ||
      used_->mounts.size() != shown.mounts.size()) {
    return shown;
  }
  int taken = 0;
  const auto complete = [&taken](auto& own, const auto& used) {
    if (!calibrated(own.method) && calibrated(used.method)) {
      own = used;
      ++taken;
    }
  };
  for (std::size_t s = 0; s < shown.sensors.size(); ++s) {
    complete(shown.sensors[s], used_->sensors[s]);
  }
  for (std::size_t m = 0; m < shown.mounts.size(); ++m) {
    complete(shown.mounts[m], used_->mounts[m]);
  }
  if (from_solve != nullptr) {
    *from_solve = taken;
  }
  return shown;
}

void CalibrateOverview::refresh_sources() {
  const calibrate::RigCalibration stored =
      newest_of_library(desk_.listing(), desk_.rig(), desk_.wearer().toStdString());
  const bool known = solve::is_measured(stored);
  library_->setEnabled(known);
  library_->setToolTip(known ? tr("The newest of every sensor and of this wearer's mountings")
                             : tr("The library knows none of these sensors yet."));
}

void CalibrateOverview::refresh_rows() {
  if (!desk_.has_rig()) {
    return;
  }
  const body::Rig& rig = desk_.rig();
  while (rows_.size() > rig.accelerometers.size()) {
    rows_.back()->hide();
    rows_.back()->deleteLater();
    rows_.pop_back();
  }
  while (rows_.size() < rig.accelerometers.size()) {
    auto* row = new SensorRow(static_cast<int>(rows_.size()), this);
    connect(row, &SensorRow::chosen, this,
            [this](int sensor) { desk_.context().selection().select(SelectionKind::kSensor, sensor); });
    connect(row, &SensorRow::range_wanted, this, [this](int sensor) { Q_EMIT range_wanted({sensor}); });
    connect(row, &SensorRow::mount_wanted, this, [this](int sensor) { Q_EMIT mount_wanted(sensor, true); });
    rows_layout_->insertWidget(rows_layout_->count() - 1, row);
    rows_.push_back(row);
  }
  const int selected = desk_.context().selection().index_of(SelectionKind::kSensor);
  const calibrate::RigCalibration calibration = shown();
  for (std::size_t s = 0; s < rows_.size(); ++s) {
    const body::Accelerometer& accelerometer = rig.accelerometers[s];
    rows_[s]->set_content(shown_name(accelerometer.name),
                          accelerometer.serial.empty() ? tr("no serial") : QString::fromStdString(accelerometer.serial),
                          range_state(calibration.sensors.at(s)), mount_state(calibration.mounts.at(s)),
                          in_a_group(rig, static_cast<int>(s)));
    rows_[s]->set_selected(static_cast<int>(s) == selected);
  }
}

}  // namespace limbwave::ui
