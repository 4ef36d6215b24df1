#include "common/recent_takes.h"

#include <QDir>
#include <QFileInfo>

namespace limbwave::ui {
namespace {
constexpr int kKept = 12;
constexpr const char* kKey = "recent/takes";
}  // namespace

QStringList RecentTakes::folders() const {
  QStringList found;
  for (const QString& folder : settings_.value(QLatin1String(kKey)).toStringList()) {
    if (!folder.isEmpty() && !found.contains(folder) && QFileInfo(folder).isDir()) {
      found.append(folder);
    }
  }
  return found.mid(0, kKept);
}

void RecentTakes::add(const QString& folder) {
  // Those on a disk that is not there at the moment stay.
  QStringList list = settings_.value(QLatin1String(kKey)).toStringList();
  const QString path = QDir::cleanPath(QFileInfo(folder).absoluteFilePath());
  list.removeAll(path);
  list.prepend(path);
  settings_.setValue(QLatin1String(kKey), list.mid(0, 2 * kKept));
  Q_EMIT changed();
}

void RecentTakes::remove(const QString& folder) {
  QStringList list = settings_.value(QLatin1String(kKey)).toStringList();
  list.removeAll(folder);
  settings_.setValue(QLatin1String(kKey), list);
  Q_EMIT changed();
}

void RecentTakes::replace(const QString& from, const QString& to) {
  QStringList list = settings_.value(QLatin1String(kKey)).toStringList();
  if (list.contains(from)) {
    list.removeAll(to);
    list.replace(list.indexOf(from), to);
    settings_.setValue(QLatin1String(kKey), list);
    Q_EMIT changed();
  }
}

}  // namespace limbwave::ui
