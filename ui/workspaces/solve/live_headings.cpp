#include "workspaces/solve/live_headings.h"

#include <QUndoCommand>
#include <algorithm>
#include <cmath>

#include "common/shown_names.h"

namespace limbwave::ui {

namespace {

constexpr int kKeepAfterMs = 300;  // A slider sends many values.
constexpr double kStep_s = 0.02;   // A turn at once takes this long: keys never stand closer than a frame.

}  // namespace

/// One turn of the live figure. Undone while it is being recorded, it was never made; undone later, it holds no longer.
class TurnLiveCommand : public QUndoCommand {
 public:
  TurnLiveCommand(LiveHeadings& model, LiveHeadings::Turn turn, const QString& text, int gesture, bool recorded)
      : QUndoCommand(text), model_(model), turn_(turn), gesture_(gesture), recorded_(recorded) {}
  void redo() override {
    if (!model_.apply(turn_.segment, turn_.after)) {
      setObsolete(true);
    } else if (in_this_recording()) {
      model_.turns_.push_back(turn_);
      model_.keep_soon();
    } else {
      start_from(turn_.after);
    }
  }
  void undo() override {
    if (!model_.apply(turn_.segment, turn_.before)) {
      setObsolete(true);
    } else if (in_this_recording()) {
      std::erase_if(model_.turns_, [this](const LiveHeadings::Turn& one) { return one.id == turn_.id; });
      model_.keep_soon();
    } else {
      start_from(turn_.before);
    }
  }
  [[nodiscard]] int id() const override { return gesture_ == kNoGesture ? -1 : 0x6c68; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto* next = dynamic_cast<const TurnLiveCommand*>(other);
    if (next == nullptr || next->gesture_ != gesture_ || next->turn_.segment != turn_.segment ||
        next->recorded_ != recorded_) {
      return false;
    }
    turn_.after = next->turn_.after;
    turn_.end_s = next->turn_.end_s;
    if (in_this_recording() && model_.turns_.size() >= 2) {
      model_.turns_.pop_back();
      model_.turns_.back() = turn_;
      model_.keep_soon();
    }
    return true;
  }

 private:
  [[nodiscard]] bool in_this_recording() const { return recorded_ && model_.recording_; }
  // A turn from before the recording: the recording begins otherwise.
  void start_from(double heading) const {
    const auto i = static_cast<std::size_t>(turn_.segment);
    if (model_.recording_ && !recorded_ && i < model_.start_.size()) {
      model_.start_[i] = heading;
      model_.keep_soon();
    }
  }

  LiveHeadings& model_;
  LiveHeadings::Turn turn_;
  int gesture_;
  bool recorded_;
};

LiveHeadings& LiveHeadings::of(StudioContext& context) {
  if (auto* made = context.findChild<LiveHeadings*>({}, Qt::FindDirectChildrenOnly)) {
    return *made;
  }
  return *new LiveHeadings(context);
}

LiveHeadings::LiveHeadings(StudioContext& context) : QObject(&context), context_(context) {
  keep_.setSingleShot(true);
  keep_.setInterval(kKeepAfterMs);
  connect(&keep_, &QTimer::timeout, this, &LiveHeadings::keep);
  connect(&context_.live(), &LiveModel::state_changed, this, &LiveHeadings::follow_state);
  connect(&context_.live(), &LiveModel::recording_changed, this, &LiveHeadings::follow_recording);
  follow_state();
  follow_recording();
}

void LiveHeadings::follow_state() {
  if (!context_.live().running()) {
    return;
  }
  std::vector<std::string> names;
  for (const body::Segment& segment : context_.live().settings().skeleton.segments) {
    names.push_back(segment.name);
  }
  if (names != names_) {
    names_ = std::move(names);
    values_.assign(names_.size(), 0.0);
  }
  // The device was opened anew; the performer stands as before.
  if (std::any_of(values_.begin(), values_.end(), [](double value) { return value != 0.0; })) {
    apply(0, values_.front());
  }
  Q_EMIT changed();
}

void LiveHeadings::follow_recording() {
  const bool now = context_.live().recording() && !context_.live().aside();
  if (now && !recording_) {
    folder_ = context_.live().recording_folder();
    start_ = values_;
    turns_.clear();
    if (std::any_of(start_.begin(), start_.end(), [](double value) { return value != 0.0; })) {
      keep_soon();
    }
  }
  if (!now && recording_ && keep_.isActive()) {
    keep();
  }
  recording_ = now;
}

void LiveHeadings::keep_soon() {
  if (!keep_.isActive()) {
    keep_.start();
  }
}

void LiveHeadings::keep() {
  keep_.stop();
  context_.saves().add(tr("The turns of bones are not kept"), folder_,
                       [headings = keys_of(folder_)](const std::filesystem::path& now) {
                         return solve::save_live_headings(now, headings);
                       });
}

double LiveHeadings::value(int segment) const {
  const auto i = static_cast<std::size_t>(segment);
  return segment >= 0 && i < values_.size() ? values_[i] : 0.0;
}

double LiveHeadings::recorded_s() const {
  const auto& snapshot = context_.live().snapshot();
  return snapshot ? snapshot->recorded_s : 0.0;
}

bool LiveHeadings::apply(int segment, double heading) {
  const auto i = static_cast<std::size_t>(segment);
  if (segment < 0 || i >= values_.size() || !std::isfinite(heading)) {
    return false;
  }
  values_[i] = heading;
  std::vector<std::vector<solve::HeadingKey>> lists(values_.size());
  for (std::size_t s = 0; s < values_.size(); ++s) {
    if (values_[s] != 0.0) {
      lists[s] = {{0.0, values_[s]}};
    }
  }
  context_.live().set_headings(lists);
  Q_EMIT changed();
  return true;
}

bool LiveHeadings::set(int segment, double heading, int gesture) {
  const auto i = static_cast<std::size_t>(segment);
  if (!context_.live().running() || segment < 0 || i >= values_.size() || !std::isfinite(heading) ||
      std::abs(values_[i] - heading) < 1e-9) {
    return false;
  }
  const double now = recorded_s();
  const Turn turn{++turn_ids_, segment, now, now, values_[i], heading};
  context_.undo_stack().push(
      new TurnLiveCommand(*this, turn, tr("turn %1 live").arg(shown_name(names_[i])), gesture, recording_));
  return true;
}

std::vector<std::vector<solve::HeadingKey>> LiveHeadings::keys_of(const std::filesystem::path& folder) const {
  if (folder.empty() || folder != folder_) {
    return {};
  }
  std::vector<std::vector<solve::HeadingKey>> lists(start_.size());
  for (std::size_t s = 0; s < lists.size(); ++s) {
    std::vector<solve::HeadingKey>& list = lists[s];
    double value = start_[s];
    for (const Turn& turn : turns_) {
      if (turn.segment != static_cast<int>(s)) {
        continue;
      }
      if (list.empty() && turn.begin_s >= kStep_s) {
        list.push_back({0.0, value});
      }
      // It stood until the turn began.
      const double begin_s = list.empty() ? turn.begin_s : std::max(turn.begin_s, list.back().time_s + kStep_s);
      if (list.empty() || begin_s > list.back().time_s) {
        list.push_back({begin_s, value});
      }
      value = turn.after;
      list.push_back({std::max(turn.end_s, begin_s + kStep_s), value});
    }
    if (list.empty() && value != 0.0) {
      list.push_back({0.0, value});
    }
  }
  return lists;
}

}  // namespace limbwave::ui
