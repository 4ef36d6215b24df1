#include "common/studio_context.h"

#include <QDir>
#include <QStorageInfo>
#include <thread>
#include <utility>

namespace limbwave::ui {

StudioContext::StudioContext(StudioServices services, const QString& settings_folder, QObject* parent)
    : QObject(parent),
      services_(std::move(services)),
      settings_(QDir(settings_folder).filePath(QStringLiteral("studio.ini")), QSettings::IniFormat),
      recent_takes_(settings_),
      document_(services_, jobs_),
      live_(services_, jobs_),
      saves_(jobs_),
      markers_(document_, live_, saves_, undo_stack_),
      take_edits_(document_, saves_, jobs_, undo_stack_, notifications_) {
  QDir().mkpath(settings_folder);
  QDir().mkpath(takes_folder());
  disk_timer_.setInterval(20);
  connect(&disk_timer_, &QTimer::timeout, this, [this] {
    if (!asked_disk_) {
      disk_timer_.stop();
    } else if (asked_disk_->answered) {
      disk_ = std::exchange(asked_disk_, nullptr);
      disk_timer_.stop();
      Q_EMIT disk_changed();
    }
  });
  connect(&take_edits_, &TakeEdits::moved, &recent_takes_, &RecentTakes::replace);
  connect(&document_, &TakeDocument::changed, this, [this](bool other) {
    if (other) {
      selection_.clear();
      undo_stack_.clear();
      markers_.restore_undo();
      time_.set_extent(0.0, time_.frame_s());
    }
    if (other && document_.is_open()) {
      recent_takes_.add(QString::fromStdString(document_.take()->folder.string()));
    }
  });
  connect(&saves_, &SaveQueue::failed, this,
          [this](const QString& what, const Error& error) { notifications_.post_error(what, error); });
  connect(&document_, &TakeDocument::open_failed, this, [this](const QString& folder, const Error& error) {
    notifications_.post_error(tr("%1 cannot be opened").arg(QDir(folder).dirName()), error);
  });
  connect(&live_, &LiveModel::recording_finished, this, [this](const take::Take& take) { document_.set(take); });
  connect(&live_, &LiveModel::recording_failed, this, [this](const QString& text, const QString& remedy) {
    notifications_.post(Severity::kError, tr("The recording failed. %1").arg(text), remedy);
  });
  connect(&live_, &LiveModel::source_lost, this,
          [this] { notifications_.post(Severity::kError, live_.problem(), live_.remedy()); });
}

StudioContext::~StudioContext() {
  settings_.sync();
}

QString StudioContext::wearer() const {
  return settings_.value(QStringLiteral("capture/subject")).toString().left(200);
}

void StudioContext::set_wearer(const QString& wearer) {
  if (wearer != this->wearer()) {
    settings_.setValue(QStringLiteral("capture/subject"), wearer);
    live_.set_wearer(wearer.trimmed());
    Q_EMIT wearer_changed();
  }
}

void StudioContext::set_animation(const QString& name) {
  if (name != animation_) {
    animation_ = name;
    Q_EMIT animation_changed();
  }
}

QString StudioContext::takes_folder() const {
  const QString folder = settings_.value(QStringLiteral("takes/folder")).toString();
  return folder.isEmpty() ? QDir::home().filePath(QStringLiteral("Limbwave")) : folder;
}

double StudioContext::disk_left_s() {
  const auto& snapshot = live_.snapshot();
  if (snapshot && snapshot->recording && snapshot->disk_left_s > 0.0) {
    return snapshot->disk_left_s;
  }
  if (!disk_asked_.isValid() || disk_asked_.elapsed() > 1000) {
    ask_disk();
  }
  const qint64 free = disk_ ? disk_->free.load() : -1;
  if (free < 0) {
    return -1.0;
  }
  const bool known = snapshot && snapshot->format.rate.hz > 0.0;
  const double bytes_per_second =
      known ? snapshot->format.rate.hz * static_cast<double>(snapshot->format.bytes_per_frame()) : 48000.0 * 4.0;
  return static_cast<double>(free) / bytes_per_second;
}

void StudioContext::ask_disk() {
  if (asked_disk_) {
    return;
  }
  disk_asked_.start();
  asked_disk_ = std::make_shared<Disk>();
  std::thread([disk = asked_disk_, folder = takes_folder()] {
    disk->free = QStorageInfo(folder).bytesAvailable();
    disk->answered = true;
  }).detach();
  disk_timer_.start();
}

void StudioContext::set_takes_folder(const QString& folder) {
  if (folder == takes_folder()) {
    return;
  }
  QDir().mkpath(folder);
  disk_asked_.invalidate();
  disk_.reset();
  asked_disk_.reset();  // What is asked of the other folder is not listened to.
  settings_.setValue(QStringLiteral("takes/folder"), folder);
  Q_EMIT takes_folder_changed();
}

}  // namespace limbwave::ui
