/// The signal of the recording while it grows, else of the open take, which is read in a job.
#pragma once

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

 private:
  void follow_take(bool other);
  void follow_recording();
  void append_new_samples();
  StudioContext& context_;
  ElidedLabel* title_;
  OverviewView* view_;
  Job* job_ = nullptr;
  std::shared_ptr<TakeOverview> growing_;  ///< Of the running recording, else null.
  double next_sample_ = -1.0;              ///< Of the stream: the first one that `growing_` has not seen.
  std::vector<OverviewMark> growing_marks_;
};

}  // namespace limbwave::ui
