#include "workspaces/solve/solve_timeline.h"

#include <QCoreApplication>

#include "common/core_text.h"
#include "take/markers.h"
#include "timeline/timeline_widget.h"
#include "workspaces/solve/bone_card.h"
#include "workspaces/solve/solve_model.h"

namespace limbwave::ui {

namespace {

struct SolveTimeline {
  Q_DECLARE_TR_FUNCTIONS(SolveTimeline)
};

TimelineMarker::Kind kind_of(const std::string& event) {
  if (event == "marker") {
    return TimelineMarker::Kind::kMarker;
  }
  return event == "dropped" || event == "sync-lost" ? TimelineMarker::Kind::kLoss : TimelineMarker::Kind::kWarning;
}

void show_take(StudioContext& context, SolveModel& model, TimelineCanvas& canvas) {
  std::vector<TimelineMarker> markers;
  std::vector<TimelineStretch> stretches;
  const double start = model.clip_start_s();
  const double duration = context.time().duration_s();
  if (const auto& take = context.document().take(); take && take->info.format.rate.hz > 0.0) {
    const SampleRate rate = take->info.format.rate;
    for (const take::TakeEvent& event : take->events) {
      const double time = rate.seconds(event.sample).value - start;
      if (time >= 0.0 && time <= duration) {
        const QString text = take::is_marker(event) && !event.text.empty()
                                 ? QString::fromStdString(event.text)
                                 : core_text(event.text.empty() ? event.kind : event.text);
        markers.push_back(
            {time, kind_of(event.kind), text, take::is_marker(event) ? static_cast<int>(event.count) : 0});
      }
    }
    for (const take::TakeSegment& segment : take->info.segments) {
      const double begin = rate.seconds(segment.first).value - start;
      const double end = begin + rate.seconds(segment.count).value;
      if (end > 0.0 && begin < duration && segment.name != "capture") {
        stretches.push_back({std::max(0.0, begin), std::min(end, duration), QString::fromStdString(segment.name)});
      }
    }
  }
  canvas.set_markers(std::move(markers));
  // While a recording runs, markers are the recording's and not those of the take that is shown.
  canvas.set_markers_editable(context.document().is_open() && !context.markers().recording());
  canvas.set_stretches(std::move(stretches));
}

void show_hint(SolveModel& model, TimelineCanvas& canvas) {
  canvas.set_hint(
      model.shows_live() ? SolveTimeline::tr("Live: what you turn now becomes keys here once it is recorded.")
      : model.solve()    ? SolveTimeline::tr("Select a bone, then press I to key its rotation about the vertical.")
                         : SolveTimeline::tr("Keys of the bones appear here once a take is solved."));
}

// Markers are edited through the model that Capture uses too; times of the clip become times of the take.
void connect_markers(StudioContext& context, SolveModel& model, TimelineWidget& timeline) {
  TimelineCanvas& canvas = timeline.canvas();
  QObject::connect(&canvas, &TimelineCanvas::marker_clicked, &timeline,
                   [&context](int number) { context.selection().select_marker(number); });
  QObject::connect(&canvas, &TimelineCanvas::marker_moved, &timeline, [&context, &model](int number, double time_s) {
    context.markers().move(number, time_s + model.clip_start_s());
  });
  QObject::connect(&canvas, &TimelineCanvas::marker_renamed, &timeline,
                   [&context](int number, const QString& text) { context.markers().rename(number, text); });
  QObject::connect(&canvas, &TimelineCanvas::marker_removed, &timeline,
                   [&context](int number) { context.markers().remove(number); });
  QObject::connect(&canvas, &TimelineCanvas::marker_wanted, &timeline, [&context, &model, &canvas](double time_s) {
    if (context.markers().add(time_s + model.clip_start_s())) {
      context.selection().select_marker(context.markers().newest());
      canvas.edit_marker(static_cast<int>(context.markers().newest()));
    }
  });
  QObject::connect(&context.markers(), &MarkerModel::changed, &timeline, [&context] {
    const std::int64_t chosen = context.selection().marker();
    if (chosen != 0 && context.markers().find(chosen) == nullptr) {
      context.selection().clear();  // It was deleted, or undone.
    }
  });
}

}  // namespace

QWidget* make_solve_timeline(StudioContext& context, QWidget* parent) {
  SolveModel& model = SolveModel::of(context);
  auto* timeline = new TimelineWidget(context.time(), model.key_editor(), parent);
  TimelineCanvas& canvas = timeline->canvas();
  const auto refresh = [&context, &model, &canvas] {
    show_take(context, model, canvas);
    show_hint(model, canvas);
  };
  QObject::connect(&model, &SolveModel::solve_changed, timeline, refresh);
  QObject::connect(&context.time(), &TimeModel::extent_changed, timeline, refresh);
  QObject::connect(&context.document(), &TakeDocument::changed, timeline, refresh);
  QObject::connect(&context.document(), &TakeDocument::events_changed, timeline, refresh);
  QObject::connect(&context.live(), &LiveModel::recording_changed, timeline, refresh);
  connect_markers(context, model, *timeline);
  refresh();

  // One selection: of a key here is of a key everywhere, and the other way round.
  QObject::connect(&canvas, &TimelineCanvas::lane_clicked, timeline, [&context](int lane) {
    if (context.selection().item().index != lane) {
      context.selection().select(SelectionKind::kSegment, lane);
    }
  });
  QObject::connect(&model.key_editor(), &KeyEditor::selection_changed, timeline, [&context, &model] {
    const auto& selected = model.key_editor().selected();
    if (!selected.empty()) {
      const KeyPlace& last = selected.back();
      context.selection().select({SelectionKind::kHeadingKey, last.lane, model.keys().index_of(last.lane, last.id)});
    } else if (context.selection().item().kind == SelectionKind::kHeadingKey) {
      context.selection().select(SelectionKind::kSegment, context.selection().item().index);
    }
  });
  const auto show_selection = [&context, &model, timeline] {
    const SelectedItem& item = context.selection().item();
    const int segment = segment_of_selection(item, model);
    timeline->set_current_lane(!model.shows_live() && model.has_sensor(segment) ? segment : -1);
    timeline->select_marker(context.markers().recording() ? 0 : static_cast<int>(context.selection().marker()));
    if (item.kind != SelectionKind::kHeadingKey) {
      model.key_editor().select({});
    }
  };
  QObject::connect(&context.selection(), &Selection::changed, timeline, show_selection);
  QObject::connect(&model, &SolveModel::shows_live_changed, timeline, [refresh, show_selection] {
    refresh();
    show_selection();
  });
  return timeline;
}

}  // namespace limbwave::ui
