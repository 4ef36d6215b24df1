// How the solve of the open take comes about: reading, solving, what becomes of it.
#include <algorithm>
#include <cmath>

#include "workspaces/solve/live_headings.h"
#include "workspaces/solve/solve_model.h"
#include "workspaces/solve/solve_pose.h"

namespace limbwave::ui {

void SolveModel::open_or_solve() {
  // Which solves there are stands on the disk.
  job_ = context_.jobs().compute<std::vector<std::string>>(
      tr("Reading the solve"), this,
      [list = services_.list, take = take_](const Progress&) -> Result<std::vector<std::string>> {
        return list(*take);
      },
      [this, attempt = attempt_](const Result<std::vector<std::string>>& names) {
        if (attempt != attempt_) {
          return;
        }
        job_.clear();
        if (!names) {
          fail(names.error());
          return;
        }
        if (names->empty()) {
          run(false);
          return;
        }
        const bool has_default = std::find(names->begin(), names->end(), settings_.name) != names->end();
        settings_.name = has_default ? settings_.name : names->front();
        run(true);
      });
  set_state(SolveState::kLoading);
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
  SolveRequest request{load, take_, settings_, solve_ ? skeleton_ : body::Skeleton{}, clip_start_s()};
  request.settings.headings = headings();
  const QString title = load ? tr("Reading the solve") : tr("Solving %1").arg(context_.document().name());
  job_ = context_.jobs().compute<SolveOutcome>(
      title, this,
      [services = services_, request = std::move(request)](const Progress& progress) {
        return run_solve(services, request, progress);
      },
      [this, attempt, edits = edits_](Result<SolveOutcome> result) {
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

void SolveModel::finish(SolveOutcome outcome, int edits) {
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

}  // namespace limbwave::ui
