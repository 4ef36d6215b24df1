#include "workspaces/solve/solve_model.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "common/shown_names.h"
#include "solve/compose.h"
#include "workspaces/solve/solve_pose.h"

namespace limbwave::ui {

namespace {

constexpr int kSolveAfterMs = 250;  // A slider that is still moving does not start a solve at every step.
constexpr int kSaveAfterMs = 800;

}  // namespace

SolveModel& SolveModel::of(StudioContext& context) {
  if (auto* made = context.findChild<SolveModel*>({}, Qt::FindDirectChildrenOnly)) {
    return *made;
  }
  return *new SolveModel(context, core_solve_services());
}

SolveModel::SolveModel(StudioContext& context, SolveServices services)
    : QObject(&context), context_(context), services_(std::move(services)), key_editor_(keys_, context.undo_stack()) {
  for (QTimer* timer : {&solve_soon_, &save_soon_}) {
    timer->setSingleShot(true);
  }
  solve_soon_.setInterval(kSolveAfterMs);
  save_soon_.setInterval(kSaveAfterMs);
  connect(&solve_soon_, &QTimer::timeout, this, &SolveModel::start);
  connect(&save_soon_, &QTimer::timeout, this, [this] {
    save();
    evaluate_edits();
  });
  connect(&keys_, &KeyModel::keys_changed, this, [this] {
    if (!loading_keys_ && solve_) {
      Q_EMIT pose_changed();
      note_edit();
    }
  });
  connect(&context_.document(), &TakeDocument::changed, this, &SolveModel::follow_document);
  connect(&context_.document(), &TakeDocument::described, this, [this] { take_ = context_.document().take(); });
  connect(qApp, &QCoreApplication::aboutToQuit, this, [this] {
    if (unsaved_ && solve_ && take_) {
      (void)writer_->write(writer_->issue(), take_->folder.string(),
                           [this] { return services_.save(*take_, edited()()); });
    }
  });
  follow_document(true);
}

void SolveModel::set_state(SolveState state) {
  state_ = state;
  Q_EMIT state_changed();
}

bool SolveModel::has_sensor(int segment) const {
  return segment >= 0 && static_cast<std::size_t>(segment) < has_sensor_.size() &&
         has_sensor_[static_cast<std::size_t>(segment)];
}

void SolveModel::set_shows_live(bool live) {
  if (live != shows_live_) {
    shows_live_ = live;
    const solve::LiveSettings& capture = context_.live().settings();
    live_sensors_ = segments_with_sensors(capture.rig, capture.skeleton);
    Q_EMIT shows_live_changed();
  }
}

const body::Skeleton& SolveModel::shown_skeleton() const {
  return shows_live_ ? context_.live().settings().skeleton : skeleton_;
}

bool SolveModel::shown_sensor(int segment) const {
  if (!shows_live_) {
    return has_sensor(segment);
  }
  return segment >= 0 && static_cast<std::size_t>(segment) < live_sensors_.size() &&
         live_sensors_[static_cast<std::size_t>(segment)];
}

bool SolveModel::shows_inclination() const {
  return shows_live_ ? !context_.live().settings().rig.driver_box : by_inclination();
}

int SolveModel::segment_of_sensor(int sensor) const {
  const body::Rig* rig = shows_live_ ? &context_.live().settings().rig : take_ ? &take_->info.rig : nullptr;
  if (rig == nullptr || sensor < 0 || static_cast<std::size_t>(sensor) >= rig->accelerometers.size()) {
    return -1;
  }
  return shown_skeleton().find(rig->accelerometers[static_cast<std::size_t>(sensor)].segment);
}

double SolveModel::clip_start_s() const {
  return take_ ? take_->info.format.rate.seconds(take_->info.capture().first).value : 0.0;
}

void SolveModel::follow_document(bool other) {
  if (unsaved_) {
    saving_.clear();  // This was the last chance: do not wait for a save that is still running.
    save();
  }
  names_.clear();
  take_ = context_.document().take();
  if (!other) {
    start();  // The same take with another calibration.
    return;
  }
  ++attempt_;
  cancel();
  solve_soon_.stop();
  solve_.reset();
  curves_.reset();
  truth_.reset();
  evaluation_.reset();
  settings_ = {};
  skeleton_ = take_ ? take_->info.skeleton : body::Skeleton{};
  has_sensor_ = take_ ? segments_with_sensors(take_->info.rig, skeleton_) : std::vector<bool>();
  load_keys();
  if (take_) {
    const take::TakeSegment capture = take_->info.capture();
    const double rate = take_->info.format.rate.hz;
    set_extent(rate > 0 ? static_cast<double>(capture.count.value) / rate : 0.0,
               1.0 / std::max(1.0, take_->info.rig.line_in.cycle_rate_hz));
  } else {
    set_extent(0.0, 1.0 / 60.0);
  }
  Q_EMIT skeleton_changed();
  Q_EMIT solve_changed();
  Q_EMIT settings_changed();
  Q_EMIT evaluation_changed();
  if (take_) {
    open_or_solve();
  } else {
    set_state(SolveState::kNoTake);
  }
}

void SolveModel::load_keys() {
  loading_keys_ = true;
  std::vector<QString> names;
  for (const body::Segment& segment : skeleton_.segments) {
    names.push_back(shown_name(segment.name));
  }
  const double rate = solve_ ? solve_->clip.frame_rate_hz : 60.0;
  keys_.reset(names, solve_ ? solve_->clip.duration() : 0.0, 1.0 / std::max(1.0, rate));
  for (std::size_t i = 0; solve_ && i < std::min(names.size(), solve_->settings.headings.size()); ++i) {
    std::vector<LaneKey> lane;
    for (const solve::HeadingKey& key : solve_->settings.headings[i]) {
      // What was keyed while recording may lie a little behind the last frame.
      const double time_s = std::clamp(key.time_s, 0.0, keys_.duration_s());
      if (!lane.empty() && time_s - lane.back().time_s < keys_.smallest_gap_s()) {
        lane.pop_back();
      }
      lane.push_back({0, time_s, key.heading});
    }
    keys_.load(static_cast<int>(i), lane);
  }
  loading_keys_ = false;
}

void SolveModel::set_extent(double duration_s, double frame_s) {
  TimeModel& time = context_.time();
  if (std::abs(time.duration_s() - duration_s) < frame_s && time.frame_s() == frame_s) {
    time.correct_duration(duration_s);  // Solved again: the playhead stays.
    return;
  }
  time.set_extent(duration_s, frame_s);
}

double SolveModel::heading_change(int segment, double time_s) const {
  const auto& solved = solve_->settings.headings;
  const auto i = static_cast<std::size_t>(segment);
  return keys_.value_at(segment, time_s) - (i < solved.size() ? solve::heading_at(solved[i], time_s) : 0.0);
}

void SolveModel::pose_at(double time_s, std::vector<body::SegmentPose>& poses) const {
  poses.clear();
  if (solve_ && !skeleton_.segments.empty()) {
    edited_pose(
        solve_->clip, skeleton_, has_sensor_, [this](int segment, double t) { return heading_change(segment, t); },
        time_s, poses);
  }
}

std::vector<body::SegmentPose> SolveModel::truth_at(double time_s) const {
  return truth_ ? truth_pose(*truth_, skeleton_, clip_start_s() + time_s) : std::vector<body::SegmentPose>();
}

}  // namespace limbwave::ui
