/// Long work at the bottom of the workspace: what, how far, how long still, cancel. Shown after 300 ms.
#pragma once

#include <QWidget>
#include <vector>

#include "common/job_runner.h"

class QVBoxLayout;

namespace limbwave::ui {

class JobBar : public QWidget {
  Q_OBJECT
 public:
  explicit JobBar(JobRunner& jobs, QWidget* parent = nullptr);

 private:
  void show_job(Job* job);
  QVBoxLayout* rows_;
  int visible_rows_ = 0;
};

/// "decoding, 12 s left"
QString job_text(const Job& job);

}  // namespace limbwave::ui
