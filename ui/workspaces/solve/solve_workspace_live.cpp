// The live half of the Solve workspace: when it shows the running capture, and how soon.
#include <QPushButton>
#include <algorithm>

#include "common/latency_text.h"
#include "common/widgets.h"
#include "workspaces/solve/solve_workspace.h"

namespace limbwave::ui {

void SolveWorkspace::follow_recording() {
  const LiveModel& live = context_.live();
  const bool now = live.recording() && !live.aside();
  if (now && !recorded_) {
    wish_.reset();  // While recording, the figure is the performer.
  }
  recorded_ = now;
  follow_live();
}

void SolveWorkspace::follow_live() {
  const LiveModel& live = context_.live();
  live_button_->setVisible(live.running());
  if (!live.running()) {
    wish_.reset();
    framed_live_ = false;
  }
  // Until the recorded take is open, the performer stays.
  const bool recording = (live.recording() || live.finishing()) && !live.aside();
  set_live(wish_.value_or(recording || !context_.document().is_open()));
}

void SolveWorkspace::set_live(bool live) {
  const bool before = live_;
  live_ = live && context_.live().running();
  live_button_->setChecked(live_);
  if (active_) {
    model_.set_shows_live(live_);
  }
  if (live_ && active_) {
    live_timer_.start();
    show_live_status();
  } else {
    live_timer_.stop();
  }
  if (live_ != before) {
    shown_figures_.clear();
    show_figure();
    show_live_figure();
    show_state();
  }
}

void SolveWorkspace::show_live_figure() {
  if (!live_ || !active_) {
    return;
  }
  const auto figure = context_.live().figure();
  if (!figure || (!shown_figures_.empty() && shown_figures_.back().number >= figure->number)) {
    return;
  }
  solve::PoseTimes times = figure->times;
  times.taken = steady_now_s();
  if (shown_figures_.size() == kFiguresUnderWay) {
    shown_figures_.erase(shown_figures_.begin());
  }
  shown_figures_.push_back({figure->number, times});
  viewer_->set_pose(figure->pose, static_cast<double>(figure->number));
}

void SolveWorkspace::note_live_frame(double steady_time_s, double tag) {
  const auto shown = std::find_if(shown_figures_.begin(), shown_figures_.end(),
                                  [tag](const ShownFigure& one) { return static_cast<double>(one.number) == tag; });
  if (live_ && shown != shown_figures_.end() && shown->times.solved > 0.0) {
    solve::PoseTimes times = shown->times;
    times.drawn = steady_time_s;
    context_.live().note_drawn(times);
  }
}

void SolveWorkspace::show_live_status() {
  const solve::LatencyReport report = context_.live().latency();
  const auto& snapshot = context_.live().snapshot();
  const QString& device = context_.live().device_title();
  status_->set_text(report.poses == 0 ? tr("Live from %1").arg(device)
                                      : tr("Live from %1: %2").arg(device, latency_line(report)));
  status_->setToolTip(report.poses == 0 ? QString()
                                        : latency_sentences(report, snapshot ? snapshot->device_latency_s : 0.0));
}

}  // namespace limbwave::ui
