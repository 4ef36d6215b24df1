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

// What is recorded by another hand, a calibration's signals, is left alone.
bool calibration_records(const LiveModel& live) {
  return live.aside() && (live.recording() || live.starting() || live.finishing());
}

// Where nothing can be recorded, Capture says why.
void record(StudioContext& context, bool later) {
  const LiveModel& live = context.live();
  CaptureModel& capture = CaptureModel::of(context);
  if (calibration_records(live) || live.starting() || live.finishing()) {
    return;
  }
  if (!live.recording() && capture.countdown() == 0 && !capture.can_record()) {
    context.reveal(QStringLiteral("capture"), QStringLiteral("record"));
  } else if (later && !live.recording()) {
    capture.toggle_countdown();
  } else {
    capture.toggle_recording();
  }
}

// In the recording now, else in the take at the playhead, where that can be seen.
void mark(StudioContext& context, const WorkspaceEntry* shown) {
  const LiveModel& live = context.live();
  if (live.recording() || live.starting() || live.finishing()) {
    context.markers().mark_now();
  } else if (shown != nullptr && shown->timeline && context.document().is_open() &&
             context.markers().add(context.time().playhead_s() + context.document().capture_start_s())) {
    context.selection().select_marker(context.markers().newest());
  }
}

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
  parts.actions = {
      {QKeySequence(Qt::Key_R), Workspaces::tr("Record, or stop recording"),
       [](StudioContext& context, const WorkspaceEntry*) { record(context, false); }},
      {QKeySequence(Qt::SHIFT | Qt::Key_R),
       Workspaces::tr("Record after a countdown of %1 s").arg(CaptureModel::kCountdown_s),
       [](StudioContext& context, const WorkspaceEntry*) { record(context, true); }},
      {QKeySequence(Qt::Key_M), Workspaces::tr("Set a marker: in the recording, else at the playhead"), mark}};
  return parts;
}

}  // namespace limbwave::ui
