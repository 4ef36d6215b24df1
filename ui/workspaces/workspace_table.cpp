/// The table of workspaces: one row each, in the order of the mode bar.
#include <QCoreApplication>

#include "workspaces/calibrate_workspace.h"
#include "workspaces/capture/capture_workspace.h"
#include "workspaces/solve/solve_entries.h"
#include "workspaces/solve/solve_timeline.h"
#include "workspaces/workspace.h"

namespace limbwave::ui {
namespace {

struct Workspaces {
  Q_DECLARE_TR_FUNCTIONS(Workspaces)
};

}  // namespace

StudioParts studio_parts() {
  StudioParts parts;
  parts.workspaces.push_back({.id = QStringLiteral("capture"),
                              .title = Workspaces::tr("Capture"),
                              .hint = Workspaces::tr("Choose a device, check levels, record"),
                              .icon = QStringLiteral("capture"),
                              .timeline = false,
                              .shortcuts = CaptureWorkspace::shortcuts(),
                              .create = [](StudioContext& context, QWidget* parent) -> Workspace* {
                                return new CaptureWorkspace(context, parent);
                              }});
  parts.workspaces.push_back(calibrate_entry());
  parts.workspaces.push_back(solve_entry());
  parts.workspaces.push_back(export_entry());
  parts.timeline = make_solve_timeline;
  parts.timeline_shortcuts = timeline_shortcuts();
  return parts;
}

}  // namespace limbwave::ui
