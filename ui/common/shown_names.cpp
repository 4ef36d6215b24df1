#include "common/shown_names.h"

#include <QCoreApplication>

namespace limbwave::ui {

QString shown_name(const std::string& name) {
  // "left_hand" of a skeleton and "left hand" of a rig are the same words.
  QString words = QString::fromStdString(name);
  words.replace(QLatin1Char('_'), QLatin1Char(' '));
  const QString translated = QCoreApplication::translate("Names", words.toUtf8().constData());
  return translated == words ? QString::fromStdString(name) : translated;
}

}  // namespace limbwave::ui
