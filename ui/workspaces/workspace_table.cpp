/// The table of workspaces: one row each, in the order of the mode bar.
#include <QCoreApplication>

#include "workspaces/capture/capture_workspace.h"
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
  return parts;
}

}  // namespace limbwave::ui
