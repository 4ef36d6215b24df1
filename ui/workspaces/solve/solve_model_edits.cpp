// What users change in a solve, and how it reaches the disk.
#include <cmath>

#include "common/shown_names.h"
#include "solve/compose.h"
#include "workspaces/solve/live_headings.h"
#include "workspaces/solve/solve_commands.h"
#include "workspaces/solve/solve_model.h"

namespace limbwave::ui {

namespace {

constexpr double kShortest = 0.01;  // Metres.
constexpr double kLongest = 2.0;

}  // namespace

std::vector<std::vector<solve::HeadingKey>> SolveModel::headings() const {
  if (!solve_ && take_) {
    return LiveHeadings::of(context_).keys_of(take_->folder);
  }
  std::vector<std::vector<solve::HeadingKey>> lists;
  for (int lane = 0; lane < keys_.lane_count(); ++lane) {
    std::vector<solve::HeadingKey>& list = lists.emplace_back();
    for (const LaneKey& key : keys_.keys(lane)) {
      list.push_back({key.time_s, key.value});
    }
  }
  return lists;
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
  context_.undo_stack().push(new ChangeLengthCommand(*this, segment, bone.length, length,
                                                     tr("change length of %1").arg(shown_name(bone.name)), gesture));
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
    compare_again_ = true;  // One after the other; only the newest state counts.
    evaluating_->cancel();
    return;
  }
  compare_again_ = false;
  evaluating_ = context_.jobs().compute<evaluate::Evaluation>(
      tr("Comparing with the truth"), this,
      [edited = edited(), truth = truth_, start_s = clip_start_s(),
       compare = services_.evaluate](const Progress& progress) -> Result<evaluate::Evaluation> {
        const solve::Solve solve = edited();
        if (!progress.report(0.3, "comparing")) {
          return cancelled();
        }
        return compare(solve.clip, start_s, *truth);
      },
      [this, attempt = attempt_, edits = edits_](const Result<evaluate::Evaluation>& evaluation) {
        evaluating_.clear();
        if (attempt == attempt_ && edits == edits_ && evaluation) {
          evaluation_ = *evaluation;
          Q_EMIT evaluation_changed();
        }
        if (compare_again_) {
          evaluate_edits();
        }
      });
}

}  // namespace limbwave::ui
