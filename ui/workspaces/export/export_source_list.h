/// What is exported: one motion, chosen from what is open, and others that go into the same file beside it.
#pragma once

#include <QObject>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "workspaces/export/export_sources.h"
#include "workspaces/solve/solve_model.h"

namespace limbwave::ui {

/// What was chosen, for undo.
struct ExportSourceState {
  std::string chosen;  ///< Key of what is exported; empty: nothing.
  std::vector<ExportSource> animations, others;
  bool operator==(const ExportSourceState&) const = default;
};

class ExportSourceList : public QObject {
  Q_OBJECT
 public:
  ExportSourceList(StudioContext& context, SolveModel& solves, QObject* parent = nullptr);

  /// What can be chosen: the open solve first, then the take's other solves, then animations that were opened.
  [[nodiscard]] const std::vector<ExportSource>& offered() const { return offered_; }
  /// Index of what is exported; -1: there is nothing.
  [[nodiscard]] int chosen() const { return chosen_; }
  /// What is exported; null: there is nothing.
  [[nodiscard]] const ExportSource* source() const;
  /// Those that go into the same file beside it.
  [[nodiscard]] const std::vector<ExportSource>& others() const { return others_; }
  void choose(int index);
  [[nodiscard]] ExportSourceState state() const;
  /// As it was, as far as what it was chosen from is still there.
  void put(const ExportSourceState& state);
  /// Is handed every change that the user asks for, and is to do it; by default it is only done.
  using Edit = std::function<void(const std::function<void()>& change)>;
  void set_editor(Edit edit) { edit_ = std::move(edit); }

  /// Reads an animation in a job: all its movements are offered and the first is chosen, or (`as_actor`) it is one more
  /// actor. What is wrong with a file is posted as a notification.
  void open_animation(const QString& file, bool as_actor = false);
  /// A take that is solved, as one more actor.
  void add_take(const QString& folder);
  void remove_other(int index);
  /// False when none is open.
  bool close_animations();

  /// How a job gets the chosen one and the others, in this order. Not to be called when there is nothing.
  [[nodiscard]] std::vector<ClipRequest> requests() const;
  /// Whether a file is one of those that are read.
  [[nodiscard]] bool is_read_from(const std::filesystem::path& file) const;
  /// While shown, the playhead and the timeline are of what is exported; else of the open solve.
  void set_shown(bool shown);

 Q_SIGNALS:
  void changed();   ///< What is offered, chosen or beside it.
  void replaced();  ///< Something else is exported than before.
  void edited();    ///< The same, but it moves differently: clips that were read before count no more.

 private:
  void follow_document(bool other);
  void refresh();
  void offer(const std::string& wanted);
  void show(int index);
  void name_animation();
  void take_over(const QString& file, const std::vector<SharedClip>& clips, bool as_actor);
  void show_extent();
  [[nodiscard]] ClipRequest request(const ExportSource& source) const;

  StudioContext& context_;
  SolveModel& solves_;
  std::vector<ExportSource> offered_, animations_, others_;
  Edit edit_ = [](const std::function<void()>& change) { change(); };
  int chosen_ = -1;
  bool shown_ = false;
  bool take_first_ = false;  ///< A take was opened: it is chosen as soon as it is solved.
};

}  // namespace limbwave::ui
