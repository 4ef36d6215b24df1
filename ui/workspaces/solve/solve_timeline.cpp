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
  canvas.set_stretches(std::move(stretches));
}

void show_hint(SolveModel& model, TimelineCanvas& canvas) {
  canvas.set_hint(model.solve()
                      ? SolveTimeline::tr("Select a bone, then press I to key its rotation about the vertical.")
                      : SolveTimeline::tr("Keys of the bones appear here once a take is solved."));
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
  refresh();

  // One selection: of a key here is of a key everywhere, and the other way round.
  QObject::connect(&canvas, &TimelineCanvas::lane_clicked, timeline, [&context](int lane) {
    if (context.selection().item().index != lane) {
      context.selection().select(SelectionKind::kSegment, lane);
    }
  });
  QObject::connect(&canvas, &TimelineCanvas::marker_clicked, timeline,
                   [&context](int number) { context.selection().select_marker(number); });
  QObject::connect(&model.key_editor(), &KeyEditor::selection_changed, timeline, [&context, &model] {
    const auto& selected = model.key_editor().selected();
    if (!selected.empty()) {
      const KeyPlace& last = selected.back();
      context.selection().select({SelectionKind::kHeadingKey, last.lane, model.keys().index_of(last.lane, last.id)});
    } else if (context.selection().item().kind == SelectionKind::kHeadingKey) {
      context.selection().select(SelectionKind::kSegment, context.selection().item().index);
    }
  });
  QObject::connect(&context.selection(), &Selection::changed, timeline, [&model, timeline](const SelectedItem& item) {
    const int segment = segment_of_selection(item, model);
    timeline->set_current_lane(model.has_sensor(segment) ? segment : -1);
    if (item.kind != SelectionKind::kHeadingKey && item.kind != SelectionKind::kMarker) {
      model.key_editor().select({});
    }
  });
  return timeline;
}

}  // namespace limbwave::ui
