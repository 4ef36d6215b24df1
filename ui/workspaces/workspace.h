/// A workspace: one of the places that the mode bar switches between. All of them stand in one table
/// (workspaces/workspace_table.cpp); the main window knows none of them by name.
#pragma once

#include <QKeySequence>
#include <QString>
#include <QWidget>
#include <functional>
#include <vector>

#include "common/studio_context.h"

namespace limbwave::ui {

/// The main view of one mode.
class Workspace : public QWidget {
  Q_OBJECT
 public:
  using QWidget::QWidget;
  /// Shown from now on, or no longer: start and stop what costs time.
  virtual void activate() {}
  virtual void deactivate() {}
  /// What the inspector dock shows while this workspace is on; null: the dock is hidden. The window takes it over.
  virtual QWidget* create_inspector() { return nullptr; }
  /// Brings the place of a topic into view: "sensors", "line" ... (StudioContext::reveal).
  virtual void reveal(const QString& topic) { Q_UNUSED(topic); }
};

/// One keyboard shortcut for the sheet that lists them all.
struct ShortcutHelp {
  QString keys;  ///< "Space", "J / K / L"
  QString what;  ///< "Play or pause"
};

/// One row of the table. Texts are translated by then.
struct WorkspaceEntry {
  QString id;             ///< Stable: settings and `reveal` use it.
  QString title;          ///< A verb: "Capture".
  QString hint;           ///< Tooltip: what one does there.
  QString icon;           ///< Of resources/icons.
  bool timeline = false;  ///< Shows the shared timeline at the bottom.
  std::vector<ShortcutHelp> shortcuts;
  std::function<Workspace*(StudioContext&, QWidget* parent)> create;  ///< Called when it is shown for the first time.
};

/// A key that works in the whole window, whatever is shown.
struct StudioAction {
  QKeySequence keys;
  QString what;  ///< For the sheet: "Record, or stop recording".
  /// `shown`: the workspace that is; null on the first page.
  std::function<void(StudioContext&, const WorkspaceEntry* shown)> run;
};

/// Everything that the main window is put together from.
struct StudioParts {
  std::vector<WorkspaceEntry> workspaces;
  /// The timeline that Solve, Retime and Export share; null: none.
  std::function<QWidget*(StudioContext&, QWidget* parent)> timeline;
  std::vector<ShortcutHelp> timeline_shortcuts;
  std::vector<StudioAction> actions;
};

/// The table of the studio.
StudioParts studio_parts();

}  // namespace limbwave::ui
