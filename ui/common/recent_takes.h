/// The takes that were open lately, newest first; those that are gone from the disk are left out.
#pragma once

#include <QObject>
#include <QSettings>
#include <QString>
#include <QStringList>

namespace limbwave::ui {

class RecentTakes : public QObject {
  Q_OBJECT
 public:
  /// `settings` outlives this; its content may be anything.
  explicit RecentTakes(QSettings& settings, QObject* parent = nullptr) : QObject(parent), settings_(settings) {}
  [[nodiscard]] QStringList folders() const;
  void add(const QString& folder);
  void remove(const QString& folder);
  /// A take has another folder by now.
  void replace(const QString& from, const QString& to);

 Q_SIGNALS:
  void changed();

 private:
  QSettings& settings_;
};

}  // namespace limbwave::ui
