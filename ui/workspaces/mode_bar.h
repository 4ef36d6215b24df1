/// The bar at the left that switches between workspaces.
#pragma once

#include <QButtonGroup>
#include <QToolBar>
#include <vector>

#include "workspaces/workspace.h"

namespace limbwave::ui {

class ModeBar : public QToolBar {
  Q_OBJECT
 public:
  ModeBar(const std::vector<WorkspaceEntry>& entries, QWidget* parent);
  /// Marks the button of this workspace; −1: none ("welcome").
  void set_current(int index);

 Q_SIGNALS:
  void chosen(int index);
  void home();

 private:
  QButtonGroup* group_;
};

}  // namespace limbwave::ui
