/// Undo and redo by key in number fields.
#pragma once

#include <QObject>

namespace limbwave::ui {

/// A number field keeps the keys of undo and redo for its own text, though what was typed is long a step of the
/// program's undo. As an event filter of the application this gives them to the program, unless something is being
/// typed.
class UndoKeys : public QObject {
 public:
  using QObject::QObject;
  bool eventFilter(QObject* receiver, QEvent* event) override;
};

}  // namespace limbwave::ui
