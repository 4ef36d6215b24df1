/// The signal of the recording while it grows, else of the open take, which is read in a job.
#pragma once

#include <QElapsedTimer>
#include <QWidget>

#include "common/studio_context.h"
#include "common/widgets.h"
#include "plots/overview_view.h"

namespace limbwave::ui {

class OverviewPanel : public QWidget {
  Q_OBJECT
 public:
  explicit OverviewPanel(StudioContext& context, QWidget* parent = nullptr);
  [[nodiscard]] const OverviewView& view() const { return *view_; }

 Q_SIGNALS:
  /// A marker's name is to be changed.
  void rename_wanted(std::int64_t number);

 private:
  void show_marks();
  void move_mark(std::int64_t number, double time_s);
  void follow_take(bool other);
  void follow_recording();
  void append_new_samples();
  void append_wires(const solve::LiveSnapshot& snapshot);
  void show_overview(std::shared_ptr<const TakeOverview> overview);
  void show_facts();
  /// Says in words what the rows of the wires show.
  void show_troubles(const QString& what, const BoxHistory& box);
  StudioContext& context_;
  ElidedLabel* title_;
  OverviewView* view_;
  Job* job_ = nullptr;
  std::shared_ptr<TakeOverview> growing_;         ///< Of the running recording, else null.
  std::shared_ptr<const TakeOverview> shown_;     ///< Of the open take.
  std::shared_ptr<const TakeOverview> recorded_;  ///< Of a driver box, as it was seen while it was recorded,
  std::filesystem::path recorded_folder_;         ///< and in which take.
  QString facts_;                                 ///< Of the open take.
  double next_sample_ = -1.0;                     ///< Of the stream: the first one that `growing_` has not seen.
  QElapsedTimer moved_;                           ///< Since a marker was moved last.
  std::int64_t moved_number_ = 0;
  int gesture_ = 0;
};

}  // namespace limbwave::ui
