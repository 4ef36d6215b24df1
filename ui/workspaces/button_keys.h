/// Return presses the main button of a page when it has the focus, as people expect; Qt alone has Space for it.
#pragma once

#include <QObject>

namespace limbwave::ui {

class ButtonKeys : public QObject {
 public:
  using QObject::QObject;
  bool eventFilter(QObject* receiver, QEvent* event) override;
};

}  // namespace limbwave::ui
