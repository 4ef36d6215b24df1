/// The solve of the open take: how it comes about, what was edited in it, and how good it is. Solve, Export and the
/// timeline share it.
#pragma once

#include <QObject>
#include <QPointer>
#include <QTimer>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/studio_context.h"
#include "timeline/key_commands.h"
#include "workspaces/solve/solve_run.h"
#include "workspaces/solve/solve_services.h"
#include "workspaces/solve/solve_writer.h"

namespace limbwave::ui {

enum class SolveState { kNoTake, kLoading, kSolving, kSolved, kFailed };

class SolveModel : public QObject {
  Q_OBJECT
 public:
  /// The context's own, made when first asked for.
  static SolveModel& of(StudioContext& context);
  SolveModel(StudioContext& context, SolveServices services);

  [[nodiscard]] SolveState state() const { return state_; }
  /// A sound card's take; others are solved by the body filter.
  [[nodiscard]] bool by_inclination() const { return !take_ || take_->info.kind == "line-in"; }
  /// The solve as it was computed or loaded: without later edits of headings and lengths. Null before.
  [[nodiscard]] const std::shared_ptr<const solve::Solve>& solve() const { return solve_; }
  [[nodiscard]] const solve::SolveSettings& settings() const { return settings_; }
  [[nodiscard]] const Error& error() const { return error_; }
  /// The running job, null when none runs.
  [[nodiscard]] Job* job() const { return job_; }
  /// Lengths as edited.
  [[nodiscard]] const body::Skeleton& skeleton() const { return skeleton_; }
  [[nodiscard]] KeyModel& keys() { return keys_; }
  [[nodiscard]] KeyEditor& key_editor() { return key_editor_; }
  /// Of every sensor of the rig; null before there is a solve.
  [[nodiscard]] const SensorCurves& curves() const { return curves_; }
  [[nodiscard]] const std::optional<evaluate::Evaluation>& evaluation() const { return evaluation_; }
  [[nodiscard]] bool has_truth() const { return truth_ != nullptr; }
  [[nodiscard]] bool has_sensor(int segment) const;

  /// The workspace shows the live figure: what is said about bones is about that one, not about the take.
  [[nodiscard]] bool shows_live() const { return shows_live_; }
  void set_shows_live(bool live);
  /// Of the figure that is shown: the take's with its edits, or the live one's.
  [[nodiscard]] const body::Skeleton& shown_skeleton() const;
  [[nodiscard]] bool shown_sensor(int segment) const;
  /// What is shown, live or of the take, is known by gravity alone.
  [[nodiscard]] bool shows_inclination() const;
  /// The segment that the rig's sensor sits on; -1: none.
  [[nodiscard]] int segment_of_sensor(int sensor) const;

  /// Where the clip's time 0 lies in the take, seconds.
  [[nodiscard]] double clip_start_s() const;
  [[nodiscard]] const SolveServices& services() const { return services_; }
  /// The take's solves on disk, as they were when it was opened.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

  /// Poses with all edits; empty before there is a solve.
  void pose_at(double time_s, std::vector<body::SegmentPose>& poses) const;
  /// Poses of the truth; empty when the take has none.
  [[nodiscard]] std::vector<body::SegmentPose> truth_at(double time_s) const;
  /// Makes the solve with all edits in it, as it is saved and exported. To be called in a job: an hour takes a while.
  /// Null before there is a solve.
  [[nodiscard]] std::function<solve::Solve()> edited() const;

  /// Solves again with the present settings.
  void start();
  void cancel();
  /// Undoable; solves again.
  void change_settings(const solve::SolveSettings& settings, const QString& what, int gesture = kNoGesture);
  /// Undoable; shown at once. Metres; refused outside 1 cm .. 2 m.
  bool change_length(int segment, double length, int gesture = kNoGesture);
  /// Writes edits to the take now, in a job; they are also written by themselves a moment after the last one.
  void save();

  // For the undo commands.
  void set_settings(const solve::SolveSettings& settings);
  void set_length(int segment, double length);

 Q_SIGNALS:
  void state_changed();
  /// Another solve: everything about it may be different.
  void solve_changed();
  /// Same solve, other pose: headings or lengths were edited.
  void pose_changed();
  void skeleton_changed();
  void settings_changed();
  void evaluation_changed();
  void shows_live_changed();

 private:
  void follow_document(bool other);
  void open_or_solve();
  void run(bool load);
  void finish(SolveOutcome outcome, int edits);
  void fail(const Error& error);
  void set_state(SolveState state);
  void load_keys();
  void set_extent(double duration_s, double frame_s);
  void note_edit();
  void evaluate_edits();
  /// Of the keys; before the first solve those that were set while the take was recorded.
  [[nodiscard]] std::vector<std::vector<solve::HeadingKey>> headings() const;
  [[nodiscard]] double heading_change(int segment, double time_s) const;

  StudioContext& context_;
  SolveServices services_;
  SolveState state_ = SolveState::kNoTake;
  std::shared_ptr<const take::Take> take_;
  std::shared_ptr<const solve::Solve> solve_;
  solve::SolveSettings settings_;
  body::Skeleton skeleton_;
  std::vector<bool> has_sensor_;
  std::vector<bool> live_sensors_;  ///< Of the live figure's segments.
  SensorCurves curves_;
  std::shared_ptr<const evaluate::Truth> truth_;
  std::optional<evaluate::Evaluation> evaluation_;
  Error error_;
  KeyModel keys_;
  KeyEditor key_editor_;
  QPointer<Job> job_;
  QPointer<Job> saving_;
  QPointer<Job> evaluating_;
  std::shared_ptr<SolveWriter> writer_ = std::make_shared<SolveWriter>();
  int edits_ = 0;  ///< Counts edits of keys and lengths.
  std::vector<std::string> names_;
  int attempt_ = 0;  ///< Counts runs, so that one that was overtaken is dropped.
  bool loading_keys_ = false, unsaved_ = false, shows_live_ = false;
  bool compare_again_ = false;  ///< Edited while it was being compared with the truth.
  QTimer solve_soon_, save_soon_;
};

}  // namespace limbwave::ui
