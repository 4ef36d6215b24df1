/// The one sheet that lists every keyboard shortcut.
#pragma once

#include <QDialog>
#include <vector>

#include "workspaces/workspace.h"

namespace limbwave::ui {

struct ShortcutGroup {
  QString title;
  std::vector<ShortcutHelp> shortcuts;
};

/// All groups: everywhere, every workspace that has shortcuts, the timeline.
std::vector<ShortcutGroup> shortcut_groups(const StudioParts& parts);

class ShortcutSheet : public QDialog {
  Q_OBJECT
 public:
  ShortcutSheet(const std::vector<ShortcutGroup>& groups, QWidget* parent);
};

}  // namespace limbwave::ui
