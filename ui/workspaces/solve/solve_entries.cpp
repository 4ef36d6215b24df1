#include "workspaces/solve/solve_entries.h"

#include <QCoreApplication>

#include "workspaces/export/export_workspace.h"
#include "workspaces/solve/solve_workspace.h"

namespace limbwave::ui {

namespace {

struct SolveEntries {
  Q_DECLARE_TR_FUNCTIONS(SolveEntries)
};

}  // namespace

WorkspaceEntry solve_entry() {
  return {.id = QStringLiteral("solve"),
          .title = SolveEntries::tr("Solve"),
          .hint = SolveEntries::tr("See the moving figure, judge it, key rotations"),
          .icon = QStringLiteral("solve"),
          .timeline = true,
          .shortcuts = {{SolveEntries::tr("F"), SolveEntries::tr("Frame the selection")},
                        {SolveEntries::tr("Shift+F / Shift+S / Shift+T"),
                         SolveEntries::tr("Look from the front, the side, the top")},
                        {SolveEntries::tr("Drag / Shift+drag / wheel"), SolveEntries::tr("Turn, move, zoom the view")}},
          .create = [](StudioContext& context, QWidget* parent) -> Workspace* {
            return new SolveWorkspace(context, parent);
          }};
}

WorkspaceEntry export_entry() {
  return {.id = QStringLiteral("export"),
          .title = SolveEntries::tr("Export"),
          .hint = SolveEntries::tr("Write the motion to a file for other programs"),
          .icon = QStringLiteral("export"),
          .timeline = true,
          .shortcuts = {{SolveEntries::tr("Ctrl+E"), SolveEntries::tr("Export")}},
          .create = [](StudioContext& context, QWidget* parent) -> Workspace* {
            return new ExportWorkspace(context, parent);
          }};
}

std::vector<ShortcutHelp> timeline_shortcuts() {
  return {
      {SolveEntries::tr("Space"), SolveEntries::tr("Play or pause")},
      {SolveEntries::tr("J / K / L"), SolveEntries::tr("Play backwards, stop, play forwards; again: faster")},
      {SolveEntries::tr("Left / Right"), SolveEntries::tr("One frame back or on; with Shift ten")},
      {SolveEntries::tr("Up / Down"), SolveEntries::tr("To the key before or after")},
      {SolveEntries::tr("Home / End"), SolveEntries::tr("To the start or the end")},
      {SolveEntries::tr("Shift+Home"), SolveEntries::tr("Show the whole clip")},
      {SolveEntries::tr("I"), SolveEntries::tr("Set a key for the selected bone")},
      {SolveEntries::tr("Del"), SolveEntries::tr("Delete the selected keys or the selected marker")},
      {SolveEntries::tr("F2"), SolveEntries::tr("Rename the selected marker")},
      {SolveEntries::tr("Alt+Left / Alt+Right"),
       SolveEntries::tr("Move the selected keys or the selected marker by a frame")},
      {SolveEntries::tr("Alt+Up / Alt+Down"), SolveEntries::tr("Turn the selected keys by 1°; with Shift by 0.1°")}};
}

}  // namespace limbwave::ui
