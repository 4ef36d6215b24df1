#include "workspaces/button_keys.h"

#include <QDialog>
#include <QKeyEvent>
#include <QPushButton>

namespace limbwave::ui {

bool ButtonKeys::eventFilter(QObject* receiver, QEvent* event) {
  auto* button = event->type() == QEvent::KeyPress ? qobject_cast<QPushButton*>(receiver) : nullptr;
  // Dialogs have a default button of their own.
  if (button == nullptr || !button->property("primary").toBool() ||
      qobject_cast<QDialog*>(button->window()) != nullptr) {
    return QObject::eventFilter(receiver, event);
  }
  const auto* key = static_cast<QKeyEvent*>(event);
  const bool enter = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
  if (!enter || key->isAutoRepeat() || (key->modifiers() & ~Qt::KeypadModifier) != 0 || !button->isEnabled()) {
    return QObject::eventFilter(receiver, event);
  }
  button->click();
  return true;
}

}  // namespace limbwave::ui
