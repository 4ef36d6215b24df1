#include "workspaces/solve/solve_model.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "solve/compose.h"
#include "workspaces/solve/solve_commands.h"
#include "workspaces/solve/solve_pose.h"

namespace limbwave::ui {

namespace {

constexpr double kShortest = 0.01;  // Metres.
constexpr double kLongest = 2.0;
constexpr int kSolveAfterMs = 250;  // A slider that is still moving does not start a solve at every step.
constexpr int kSaveAfterMs = 800;

std::vector<SensorCurve> make_curves(const take::Take& take, const solve::Solve& solve) {
  const body::Rig& rig = take.info.rig;
  const std::vector<int> segments = solve::sensor_segments(rig, solve.clip.skeleton);
  std::vector<std::vector<float>> elevation = elevations(solve.clip, segments);
  std::vector<SensorCurve> curves;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    SensorCurve curve;
    curve.name = QString::fromStdString(rig.accelerometers[i].name);
    curve.segment = segments[i];
    curve.elevation_deg = std::move(elevation[i]);
    if (i < solve.trust.size()) {
      curve.trust = solve.trust[i];
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace

/// What a run brings back from its thread.
struct SolveModel::Outcome {
  std::shared_ptr<const solve::Solve> solve;
  std::vector<SensorCurve> curves;
  std::shared_ptr<const evaluate::Truth> truth;
  std::optional<evaluate::Evaluation> evaluation;
  Status compared;
  bool fresh = false;  ///< Solved now, so not on disk yet.
  /// What was wrong with the saved solve, where it is now, and whether its keys could be read.
  std::optional<Error> damage;
  std::filesystem::path aside;
  bool kept_keys = false;
};

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

double SolveModel::clip_start_s() const {
  return take_ ? take_->info.format.rate.seconds(take_->info.capture().first).value : 0.0;
}

void SolveModel::follow_document(bool other) {
  if (unsaved_) {
    saving_.clear();  // This was the last chance: do not wait for a save that is still running.
    save();
  }
  take_ = context_.document().take();
  if (!other) {
    start();  // The same take with another calibration.
    return;
  }
  ++attempt_;
  cancel();
  solve_soon_.stop();
  solve_.reset();
  curves_.clear();
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

void SolveModel::open_or_solve() {
  const std::vector<std::string> names = services_.list(*take_);
  if (names.empty()) {
    run(false);
    return;
  }
  const bool has_default = std::find(names.begin(), names.end(), settings_.name) != names.end();
  settings_.name = has_default ? settings_.name : names.front();
  run(true);
}

void SolveModel::start() {
  if (take_) {
    solve_soon_.stop();
    run(false);
  }
}

void SolveModel::cancel() {
  if (job_) {
    job_->cancel();
  }
}

void SolveModel::run(bool load) {
  cancel();
  const int attempt = ++attempt_;
  solve::SolveSettings settings = settings_;
  settings.headings = headings();
  auto work = [load, settings, take = take_, services = services_, lengths = solve_ ? skeleton_ : body::Skeleton{},
               start_s = clip_start_s()](const Progress& progress) mutable -> Result<Outcome> {
    Outcome outcome;
    const auto solve_or_load = [&]() -> Result<solve::Solve> {
      if (load) {
        Result<solve::Solve> loaded = services.load(*take, settings.name);
        if (loaded || is_cancelled(loaded.error())) {
          return loaded;
        }
        // Keys and lengths are the user's own and cannot be computed again: keep what is there.
        outcome.damage = loaded.error();
        if (Result<solve::SolveSettings> kept = services.load_settings(*take, settings.name); kept) {
          settings = std::move(kept).value();
          outcome.kept_keys = true;
        }
        Result<std::filesystem::path> aside = services.set_aside(*take, settings.name);
        if (!aside) {
          return aside.error();
        }
        outcome.aside = std::move(aside).value();
      }
      outcome.fresh = true;
      return services.solve(*take, settings, progress.part(0.0, 0.9));
    };
    Result<solve::Solve> solved = solve_or_load();
    if (!solved) {
      return solved.error();
    }
    auto solve = std::make_shared<solve::Solve>(std::move(solved).value());
    if (!load && lengths.segments.size() == solve->clip.skeleton.segments.size()) {
      solve->clip.skeleton = lengths;  // Edited lengths outlive a new solve.
    }
    outcome.curves = make_curves(*take, *solve);
    Result<std::optional<evaluate::Truth>> truth =
        services.load_truth ? services.load_truth(*take) : std::optional<evaluate::Truth>();
    if (!truth) {
      outcome.compared = truth.error();
    } else if (truth->has_value()) {
      outcome.truth = std::make_shared<const evaluate::Truth>(*std::move(truth).value());
      Result<evaluate::Evaluation> evaluation = services.evaluate(solve->clip, start_s, *outcome.truth);
      if (evaluation) {
        outcome.evaluation = std::move(evaluation).value();
      } else {
        outcome.compared = evaluation.error();
      }
    }
    outcome.solve = std::move(solve);
    return outcome;
  };
  const QString title = load ? tr("Reading the solve") : tr("Solving %1").arg(context_.document().name());
  job_ = context_.jobs().compute<Outcome>(title, this, std::move(work),
                                          [this, attempt, edits = edits_](Result<Outcome> result) {
                                            if (attempt != attempt_) {
                                              return;
                                            }
                                            job_.clear();
                                            if (result) {
                                              finish(std::move(result).value(), edits);
                                            } else {
                                              fail(result.error());
                                            }
                                          });
  set_state(load ? SolveState::kLoading : SolveState::kSolving);
}

void SolveModel::fail(const Error& error) {
  if (is_cancelled(error) && solve_) {
    set_state(SolveState::kSolved);  // What was there before is still good.
    return;
  }
  error_ = is_cancelled(error) ? Error{tr("Solving was cancelled").toStdString(), {}, {}} : error;
  set_state(SolveState::kFailed);
}

void SolveModel::finish(Outcome outcome, int edits) {
  const bool first = solve_ == nullptr;
  solve_ = std::move(outcome.solve);
  curves_ = std::move(outcome.curves);
  truth_ = std::move(outcome.truth);
  evaluation_ = std::move(outcome.evaluation);
  // What was edited while it was being solved is newer than what it was solved with.
  const bool edited_meanwhile = !first && edits != edits_;
  if (!edited_meanwhile || skeleton_.segments.size() != solve_->clip.skeleton.segments.size()) {
    skeleton_ = solve_->clip.skeleton;
  }
  has_sensor_ = segments_with_sensors(take_->info.rig, skeleton_);
  if (first) {
    settings_ = solve_->settings;
    load_keys();
    Q_EMIT settings_changed();
  }
  const double rate = solve_->clip.frame_rate_hz;
  set_extent(solve_->clip.duration(), rate > 0 ? 1.0 / rate : 1.0 / 60.0);
  if (outcome.damage) {
    const QString name = QString::fromStdString(outcome.aside.filename().string());
    context_.notifications().post(
        Severity::kWarning,
        (outcome.kept_keys
             ? tr("The saved solve could not be read. It was solved again with its keys and settings; lengths "
                  "are the rig's. What could not be read is kept in the take as %1.")
             : tr("The saved solve could not be read, nor its keys. It was solved again without them. What "
                  "could not be read is kept in the take as %1."))
            .arg(name),
        QString::fromStdString(outcome.damage->text()));
  }
  if (!outcome.compared) {
    context_.notifications().post_error(tr("The solve could not be compared with the truth"), outcome.compared.error());
  }
  if (outcome.fresh) {
    unsaved_ = true;
    saving_.clear();
    save();
  }
  if (edited_meanwhile) {
    evaluate_edits();
  }
  set_state(SolveState::kSolved);
  Q_EMIT skeleton_changed();
  Q_EMIT solve_changed();
  Q_EMIT evaluation_changed();
}

void SolveModel::load_keys() {
  loading_keys_ = true;
  std::vector<QString> names;
  for (const body::Segment& segment : skeleton_.segments) {
    names.push_back(QString::fromStdString(segment.name));
  }
  const double rate = solve_ ? solve_->clip.frame_rate_hz : 60.0;
  keys_.reset(names, solve_ ? solve_->clip.duration() : 0.0, 1.0 / std::max(1.0, rate));
  for (std::size_t i = 0; solve_ && i < std::min(names.size(), solve_->settings.headings.size()); ++i) {
    std::vector<LaneKey> lane;
    for (const solve::HeadingKey& key : solve_->settings.headings[i]) {
      lane.push_back({0, key.time_s, key.heading});
    }
    keys_.load(static_cast<int>(i), lane);
  }
  loading_keys_ = false;
}

void SolveModel::set_extent(double duration_s, double frame_s) {
  TimeModel& time = context_.time();
  if (std::abs(time.duration_s() - duration_s) < frame_s && time.frame_s() == frame_s) {
    return;  // Solved again: the playhead stays.
  }
  time.set_extent(duration_s, frame_s);
}

std::vector<std::vector<solve::HeadingKey>> SolveModel::headings() const {
  std::vector<std::vector<solve::HeadingKey>> lists;
  for (int lane = 0; lane < keys_.lane_count(); ++lane) {
    std::vector<solve::HeadingKey>& list = lists.emplace_back();
    for (const LaneKey& key : keys_.keys(lane)) {
      list.push_back({key.time_s, key.value});
    }
  }
  return lists;
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

std::function<solve::Solve()> SolveModel::edited() const {
  if (!solve_ || !take_) {
    return {};
  }
  return [solve = solve_, headings = headings(), skeleton = skeleton_,
          segments = solve::sensor_segments(take_->info.rig, skeleton_)] {
    solve::Solve copy = *solve;
    copy.clip.skeleton = skeleton;
    solve::apply_headings(copy, segments, headings);
    return copy;
  };
}

void SolveModel::change_settings(const solve::SolveSettings& settings, const QString& what, int gesture) {
  context_.undo_stack().push(new ChangeSettingsCommand(*this, settings_, settings, what, gesture));
}

void SolveModel::set_settings(const solve::SolveSettings& settings) {
  settings_ = settings;
  Q_EMIT settings_changed();
  solve_soon_.start();
}

bool SolveModel::change_length(int segment, double length, int gesture) {
  if (segment < 0 || static_cast<std::size_t>(segment) >= skeleton_.segments.size() || !std::isfinite(length) ||
      length < kShortest || length > kLongest) {
    return false;
  }
  const body::Segment& bone = skeleton_.segments[static_cast<std::size_t>(segment)];
  if (std::abs(bone.length - length) < 1e-9) {
    return false;
  }
  context_.undo_stack().push(new ChangeLengthCommand(
      *this, segment, bone.length, length, tr("change length of %1").arg(QString::fromStdString(bone.name)), gesture));
  return true;
}

void SolveModel::set_length(int segment, double length) {
  skeleton_ = body::with_length(skeleton_, segment, length);
  Q_EMIT skeleton_changed();
  Q_EMIT pose_changed();
  note_edit();
}

void SolveModel::note_edit() {
  ++edits_;
  unsaved_ = true;
  save_soon_.start();
}

void SolveModel::save() {
  save_soon_.stop();
  if (!solve_ || !take_ || !unsaved_) {
    return;
  }
  if (saving_) {
    save_soon_.start();  // One after the other, so that the newest stays.
    return;
  }
  unsaved_ = false;
  saving_ = context_.jobs().start(
      tr("Saving the solve"), this,
      [take = take_, edited = edited(), save = services_.save, writer = writer_,
       number = writer_->issue()](const Progress&) {
        return writer->write(number, take->folder.string(), [&] { return save(*take, edited()); });
      },
      [this, take = take_](const Status& status) {
        saving_.clear();
        if (!status) {
          context_.notifications().post_error(tr("The solve could not be saved in the take"), status.error());
          unsaved_ = unsaved_ || take == take_;
        }
      });
}

void SolveModel::evaluate_edits() {
  if (!truth_ || !solve_) {
    return;
  }
  if (evaluating_) {
    evaluating_->cancel();
  }
  evaluating_ = context_.jobs().compute<evaluate::Evaluation>(
      tr("Comparing with the truth"), this,
      [edited = edited(), truth = truth_, start_s = clip_start_s(),
       compare = services_.evaluate](const Progress& progress) -> Result<evaluate::Evaluation> {
        if (!progress.report(0.0, "comparing")) {
          return cancelled();
        }
        return compare(edited().clip, start_s, *truth);
      },
      // Only the newest state counts.
      [this, attempt = attempt_, edits = edits_](const Result<evaluate::Evaluation>& evaluation) {
        if (attempt == attempt_ && edits == edits_ && evaluation) {
          evaluation_ = *evaluation;
          Q_EMIT evaluation_changed();
        }
      });
}

}  // namespace limbwave::ui
