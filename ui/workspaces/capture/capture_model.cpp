#include "workspaces/capture/capture_model.h"

#include <QDir>
#include <algorithm>

#include "common/format.h"

namespace limbwave::ui {

CaptureModel::CaptureModel(StudioContext& context, QObject* parent)
    : QObject(parent),
      context_(context),
      rig_(context.settings().value(QStringLiteral("capture/rig"), QStringLiteral("line-in-arm")).toString()) {
  const QStringList known = rigs();
  if (!known.isEmpty() && !known.contains(rig_)) {
    rig_ = known.first();
  }
  load_rig_names();
  suggest_name();
  LiveModel& live = context_.live();
  connect(&live, &LiveModel::recording_finished, this, [this] {
    name_typed_ = false;
    suggest_name();
  });
  connect(&live, &LiveModel::recording_failed, this, &CaptureModel::suggest_name);
  connect(&context_, &StudioContext::wearer_changed, this, &CaptureModel::suggest_name);
  connect(&live, &LiveModel::marked, this, [this](const QString& text) {
    const auto& snapshot = context_.live().snapshot();
    markers_.push_back({snapshot ? snapshot->recorded_s : 0.0, text});
    Q_EMIT markers_changed();
  });
  connect(&live, &LiveModel::recording_changed, this, [this] {
    if (context_.live().recording()) {
      markers_.clear();
      Q_EMIT markers_changed();
    }
  });
  connect(&context_.document(), &TakeDocument::changed, this, [this] {
    if (!context_.live().recording()) {
      show_markers_of_take();
    }
  });
}

void CaptureModel::set_today(const QDate& today) {
  today_ = today;
  suggest_name();
}

QStringList CaptureModel::rigs() const {
  QStringList names;
  if (context_.services().list_rigs) {
    for (const std::string& name : context_.services().list_rigs()) {
      names.append(QString::fromStdString(name));
    }
  }
  return names;
}

void CaptureModel::load_rig_names() {
  sensor_names_.clear();
  if (!context_.services().load_rig) {
    return;
  }
  const auto settings = context_.services().load_rig(rig_.toStdString(), subject().toStdString(), {});
  if (!settings) {
    context_.notifications().post_error(tr("Rig %1").arg(rig_), settings.error());
    return;
  }
  for (const body::Accelerometer& sensor : settings.value().rig.accelerometers) {
    sensor_names_.append(QString::fromStdString(sensor.name));
  }
  slot_count_ = settings.value().rig.line_in.slots;
}

QStringList CaptureModel::sensor_names() const {
  return sensor_names_;
}

int CaptureModel::slot_count() const {
  return slot_count_;
}

void CaptureModel::suggest_name() {
  if (!name_typed_) {
    const QDate day = today_.isValid() ? today_ : QDate::currentDate();
    take_name_ = suggest_take_name(context_.takes_folder(), subject(), day.toString(QStringLiteral("yyyyMMdd")));
  }
  check_name();
  Q_EMIT setup_changed();
}

QString CaptureModel::take_folder() const {
  return QDir(context_.takes_folder()).filePath(take_name_ + QStringLiteral(".take"));
}

void CaptureModel::check_name() {
  name_problem_ = limbwave::ui::take_name_problem(context_.takes_folder(), take_name_);
}

bool CaptureModel::can_record() const {
  const LiveModel& live = context_.live();
  return live.running() && live.snapshot() && live.snapshot()->source_alive && !live.recording() && !live.finishing() &&
         take_name_problem().isEmpty();
}

void CaptureModel::refresh_devices() {
  if (searching_ || !context_.services().list_devices) {
    return;
  }
  searching_ = true;
  search_problem_.clear();
  Q_EMIT devices_changed();
  using Devices = std::vector<acquire::DeviceInfo>;
  context_.jobs().compute<Devices>(
      tr("Looking for devices"), this,
      [list_devices = context_.services().list_devices](const Progress&) { return list_devices(); },
      [this](Result<Devices> result) {
        searching_ = false;
        if (result) {
          devices_ = std::move(result).value();
        } else {
          devices_.clear();
          search_problem_ = QString::fromStdString(result.error().text());
        }
        Q_EMIT devices_changed();
        const QString last = context_.settings().value(QStringLiteral("capture/device")).toString();
        if ((context_.live().state() == LiveState::kOff || context_.live().lost()) && !last.isEmpty()) {
          open_device(last);
        }
      });
}

void CaptureModel::open_device(const QString& id) {
  LiveModel& live = context_.live();
  if (live.recording() || live.finishing()) {
    return;
  }
  if (id.isEmpty()) {
    live.close();
    context_.settings().remove(QStringLiteral("capture/device"));
    return;
  }
  const auto device = std::find_if(devices_.begin(), devices_.end(),
                                   [&](const acquire::DeviceInfo& one) { return one.id == id.toStdString(); });
  if (device == devices_.end() || (live.state() != LiveState::kOff && live.device_id() == id && !live.lost())) {
    return;
  }
  if (live.open(id, QString::fromStdString(device->title), rig_.toStdString(), subject())) {
    context_.settings().setValue(QStringLiteral("capture/device"), id);
  }
}

void CaptureModel::set_rig(const QString& rig) {
  if (rig == rig_ || rig.isEmpty() || context_.live().recording()) {
    return;
  }
  rig_ = rig;
  context_.settings().setValue(QStringLiteral("capture/rig"), rig);
  load_rig_names();
  Q_EMIT setup_changed();
  // The decoder depends on the rig: listen anew.
  const QString id = context_.live().device_id();
  if (context_.live().state() != LiveState::kOff && !id.isEmpty()) {
    context_.live().close();
    open_device(id);
  }
}

void CaptureModel::set_subject(const QString& subject) {
  context_.set_wearer(subject);
}

void CaptureModel::set_take_name(const QString& name) {
  if (name != take_name_) {
    take_name_ = name;
    name_typed_ = !name.isEmpty();
    check_name();
    Q_EMIT setup_changed();
  }
}

void CaptureModel::start_recording() {
  if (can_record()) {
    context_.live().start_recording(take_folder().toStdString(), subject());
  }
}

void CaptureModel::stop_recording() {
  context_.live().stop_recording();
}

void CaptureModel::toggle_recording() {
  if (context_.live().recording()) {
    stop_recording();
  } else {
    start_recording();
  }
}

void CaptureModel::mark(const QString& text) {
  if (context_.live().recording()) {
    context_.live().mark(text.isEmpty() ? tr("Marker %1").arg(markers_.size() + 1) : text);
  }
}

void CaptureModel::show_markers_of_take() {
  markers_.clear();
  if (const auto& take = context_.document().take()) {
    for (const take::TakeEvent& event : take->events) {
      if (event.kind == "marker") {
        markers_.push_back({take->info.format.rate.seconds(event.sample).value, QString::fromStdString(event.text)});
      }
    }
  }
  Q_EMIT markers_changed();
}

}  // namespace limbwave::ui
