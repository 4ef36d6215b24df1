#include "common/studio_context.h"

#include <QDir>
#include <QStorageInfo>

namespace limbwave::ui {

StudioContext::StudioContext(StudioServices services, const QString& settings_folder, QObject* parent)
    : QObject(parent),
      services_(std::move(services)),
      settings_(QDir(settings_folder).filePath(QStringLiteral("studio.ini")), QSettings::IniFormat),
      recent_takes_(settings_),
      document_(services_, jobs_),
      live_(services_, jobs_) {
  QDir().mkpath(settings_folder);
  connect(&document_, &TakeDocument::changed, this, [this](bool other) {
    if (other) {
      selection_.clear();
      undo_stack_.clear();
      time_.set_extent(0.0, time_.frame_s());
    }
    if (other && document_.is_open()) {
      recent_takes_.add(QString::fromStdString(document_.take()->folder.string()));
    }
  });
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

QString StudioContext::takes_folder() const {
  QString folder = settings_.value(QStringLiteral("takes/folder")).toString();
  if (folder.isEmpty()) {
    folder = QDir::home().filePath(QStringLiteral("Limbwave"));
  }
  QDir().mkpath(folder);
  return folder;
}

double StudioContext::disk_left_s() const {
  const auto& snapshot = live_.snapshot();
  if (snapshot && snapshot->recording && snapshot->disk_left_s > 0.0) {
    return snapshot->disk_left_s;
  }
  if (!disk_asked_.isValid() || disk_asked_.elapsed() > 1000) {
    disk_free_ = QStorageInfo(takes_folder()).bytesAvailable();
    disk_asked_.start();
  }
  const bool known = snapshot && snapshot->format.rate.hz > 0.0;
  const double bytes_per_second =
      known ? snapshot->format.rate.hz * static_cast<double>(snapshot->format.bytes_per_frame()) : 48000.0 * 4.0;
  return static_cast<double>(disk_free_) / bytes_per_second;
}

void StudioContext::set_takes_folder(const QString& folder) {
  disk_asked_.invalidate();
  settings_.setValue(QStringLiteral("takes/folder"), folder);
}

}  // namespace limbwave::ui
