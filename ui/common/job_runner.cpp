#include "common/job_runner.h"

#include <algorithm>
#include <exception>

namespace limbwave::ui {

Job::Job(QString title, QObject* parent) : QObject(parent), title_(std::move(title)) {
  clock_.start();
}

double Job::elapsed_s() const {
  return static_cast<double>(clock_.elapsed()) / 1000.0;
}

double Job::left_s() const {
  return estimate_left_s(fraction_, elapsed_s());
}

void Job::cancel() {
  if (!stop_->exchange(true)) {
    Q_EMIT changed();
  }
}

double estimate_left_s(double fraction, double elapsed_s) {
  if (fraction < 0.02 || elapsed_s < 0.5 || fraction > 1.0) {
    return -1.0;
  }
  return elapsed_s * (1.0 - fraction) / fraction;
}

JobRunner::JobRunner(QObject* parent) : QObject(parent) {}

JobRunner::~JobRunner() {
  for (Job* job : jobs_) {
    job->stop_->store(true);
  }
  for (Job* job : jobs_) {
    if (job->thread_.joinable()) {
      job->thread_.join();
    }
  }
}

Job* JobRunner::start(const QString& title, QObject* owner, Work work, Done done) {
  auto* job = new Job(title, this);
  jobs_.push_back(job);
  Q_EMIT job_started(job);
  const QPointer<QObject> guard(owner);
  const bool has_owner = owner != nullptr;
  auto finish = [this, job, guard, has_owner, done = std::move(done)](const Status& status) {
    job->thread_.join();
    jobs_.erase(std::remove(jobs_.begin(), jobs_.end(), job), jobs_.end());
    job->fraction_ = 1.0;
    Q_EMIT job->finished(status);
    Q_EMIT job_finished(job);
    job->deleteLater();
    if (done && (!has_owner || guard)) {
      done(status);
    }
  };
  job->thread_ = std::jthread([job, stop = job->stop_, work = std::move(work), finish = std::move(finish)]() mutable {
    // At most 25 reports a second reach the GUI thread.
    QElapsedTimer since;
    bool reported = false;
    const Progress progress([&](double fraction, std::string_view what) {
      if (!reported || since.elapsed() >= 40) {
        reported = true;
        since.restart();
        QString step = QString::fromUtf8(what.data(), static_cast<qsizetype>(what.size()));
        QMetaObject::invokeMethod(job, [job, fraction, step = std::move(step)] {
          job->fraction_ = std::clamp(fraction, 0.0, 1.0);
          job->step_ = step;
          Q_EMIT job->changed();
        });
      }
      return !stop->load();
    });
    Status status;
    try {
      status = work(progress);
    } catch (const std::exception& problem) {
      // Such as a lack of memory in a library; the studio must live on.
      status = Error{std::string("unexpected problem: ") + problem.what(), "", ""};
    } catch (...) {
      status = Error{"unexpected problem", "", ""};
    }
    QMetaObject::invokeMethod(job, [finish = std::move(finish), status] { finish(status); });
  });
  return job;
}

}  // namespace limbwave::ui
