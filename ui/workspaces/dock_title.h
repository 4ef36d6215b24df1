/// The head of a dock: its name, and buttons that can be seen and hit. Dragged and double-clicked like any other.
#pragma once

#include <QWidget>

class QDockWidget;
class QToolButton;

namespace limbwave::ui {

class DockTitle : public QWidget {
  Q_OBJECT
 public:
  explicit DockTitle(QDockWidget* dock);

 private:
  void refresh();
  QDockWidget* dock_;
  QToolButton* float_;
};

}  // namespace limbwave::ui
