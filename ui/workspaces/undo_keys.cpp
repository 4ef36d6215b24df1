#include "workspaces/undo_keys.h"

#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSpinBox>

namespace limbwave::ui {
namespace {

// The text of the field is the number that counts.
bool is_settled(const QObject* receiver) {
  const auto* field = qobject_cast<const QAbstractSpinBox*>(receiver);
  if (field == nullptr && receiver != nullptr) {
    field = qobject_cast<const QAbstractSpinBox*>(receiver->parent());
  }
  if (const auto* one = qobject_cast<const QDoubleSpinBox*>(field)) {
    return one->cleanText() == one->textFromValue(one->value()) || one->text() == one->specialValueText();
  }
  if (const auto* one = qobject_cast<const QSpinBox*>(field)) {
    return one->cleanText() == one->locale().toString(one->value()) ||
           one->cleanText() == QString::number(one->value());
  }
  return false;
}

}  // namespace

bool UndoKeys::eventFilter(QObject* receiver, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if ((key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) && is_settled(receiver)) {
      event->ignore();
      return true;
    }
  }
  return QObject::eventFilter(receiver, event);
}

}  // namespace limbwave::ui
