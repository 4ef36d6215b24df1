/// Rows of the table of workspaces for Solve and Export, and their keys for the shortcut sheet.
#pragma once

#include <vector>

#include "workspaces/workspace.h"

namespace limbwave::ui {

WorkspaceEntry solve_entry();
WorkspaceEntry export_entry();
std::vector<ShortcutHelp> timeline_shortcuts();

}  // namespace limbwave::ui
