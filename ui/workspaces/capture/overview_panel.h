/// The signal of the open take below the live signals; reads it in a job.
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
  StudioContext& context_;
  ElidedLabel* title_;
  OverviewView* view_;
  Job* job_ = nullptr;
};

}  // namespace limbwave::ui
