#include "workspaces/job_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "common/format.h"
#include "common/theme.h"
#include "common/widgets.h"

namespace limbwave::ui {

QString job_text(const Job& job) {
  if (job.cancelling()) {
    return JobBar::tr("stopping");
  }
  QString text = job.step();
  const double left = job.left_s();
  if (left >= 0.0 && job.elapsed_s() > 1.0) {
    text += (text.isEmpty() ? QString() : QStringLiteral(", ")) +
            JobBar::tr("%1 left").arg(format_left(std::max(1.0, std::ceil(left))));
  }
  return text;
}

JobBar::JobBar(JobRunner& jobs, QWidget* parent) : QWidget(parent), rows_(new QVBoxLayout(this)) {
  setProperty("strip", true);
  setAttribute(Qt::WA_StyledBackground);
  setObjectName(QStringLiteral("job_bar"));
  rows_->setContentsMargins(2 * kGrid, kGrid / 2, kGrid, kGrid / 2);
  rows_->setSpacing(kGrid / 2);
  hide();
  connect(&jobs, &JobRunner::job_started, this, [this, &jobs](Job* job) {
    const QPointer<Job> guard(job);
    QTimer::singleShot(300, this, [this, guard, &jobs] {
      // A job that has ended lives on until the event loop deletes it.
      const std::vector<Job*> running = jobs.jobs();
      if (guard && std::find(running.begin(), running.end(), guard.data()) != running.end()) {
        show_job(guard);
      }
    });
  });
}

void JobBar::show_job(Job* job) {
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2 * kGrid);
  auto* title = new ElidedLabel(job->title(), row);
  auto* bar = new QProgressBar(row);
  bar->setRange(0, 1000);
  bar->setTextVisible(false);
  bar->setAccessibleName(job->title());
  bar->setMinimumWidth(20 * kGrid);
  auto* text = dim_label({}, row);
  text->setMinimumWidth(20 * kGrid);
  auto* cancel = new QPushButton(tr("Cancel"), row);
  cancel->setAccessibleName(tr("Cancel: %1").arg(job->title()));
  layout->addWidget(title, 2);
  layout->addWidget(bar, 3);
  layout->addWidget(text, 1);
  layout->addWidget(cancel);
  rows_->addWidget(row);
  ++visible_rows_;
  show();
  const auto update_row = [job, bar, text, cancel] {
    // A bar that knows no fraction yet runs to and fro.
    bar->setRange(0, job->fraction() > 0.0 ? 1000 : 0);
    bar->setValue(static_cast<int>(std::lround(job->fraction() * 1000.0)));
    text->setText(job_text(*job));
    cancel->setEnabled(!job->cancelling());
  };
  update_row();
  connect(job, &Job::changed, row, update_row);
  connect(cancel, &QPushButton::clicked, job, &Job::cancel);
  connect(job, &Job::finished, row, [this, row] {
    row->deleteLater();
    setVisible(--visible_rows_ > 0);
  });
}

}  // namespace limbwave::ui
