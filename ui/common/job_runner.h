/// Long work beside the window: every job runs on a thread of its own, reports progress and can be cancelled.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QPointer>
#include <QString>
#include <QTimer>
#include <atomic>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "base/progress.h"
#include "base/result.h"

namespace limbwave::ui {

/// One piece of long work, as a face shows it. Lives in the GUI thread; the runner deletes it after `finished`.
class Job : public QObject {
  Q_OBJECT
 public:
  [[nodiscard]] const QString& title() const { return title_; }
  [[nodiscard]] double fraction() const { return fraction_; }  ///< 0..1
  [[nodiscard]] const QString& step() const { return step_; }  ///< "decoding"
  [[nodiscard]] double elapsed_s() const;
  /// Seconds until the end at the present speed; negative while nothing can be said.
  [[nodiscard]] double left_s() const;
  [[nodiscard]] bool cancelling() const { return stop_->load(); }
  /// Asks the work to stop; it then ends as `cancelled()`.
  void cancel();

 Q_SIGNALS:
  void changed();
  void finished(const limbwave::Status& status);

 private:
  friend class JobRunner;
  Job(QString title, QObject* parent);
  QString title_;
  QString step_;
  double fraction_ = 0.0;
  QElapsedTimer clock_;
  std::shared_ptr<std::atomic<bool>> stop_ = std::make_shared<std::atomic<bool>>(false);
  std::jthread thread_;
};

/// Time left from what is done so far: negative below 2 % or before half a second, when it would be a guess.
double estimate_left_s(double fraction, double elapsed_s);

class JobRunner : public QObject {
  Q_OBJECT
 public:
  using Work = std::function<Status(const Progress&)>;
  using Done = std::function<void(const Status&)>;

  explicit JobRunner(QObject* parent = nullptr);
  ~JobRunner() override;  ///< Cancels what runs and waits for it; `done` is not called any more.

  /// Runs `work` on its own thread; `done` is called in the GUI thread, unless `owner` has been deleted by then.
  /// Work that takes less than 300 ms is never shown.
  Job* start(const QString& title, QObject* owner, Work work, Done done = {});

  /// The same for work that has a value.
  template <typename T>
  Job* compute(const QString& title, QObject* owner, std::function<Result<T>(const Progress&)> work,
               std::function<void(Result<T>)> done) {
    auto value = std::make_shared<std::unique_ptr<Result<T>>>();
    return start(
        title, owner,
        [work = std::move(work), value](const Progress& progress) -> Status {
          *value = std::make_unique<Result<T>>(work(progress));
          return (*value)->ok() ? Status() : Status((*value)->error());
        },
        [done = std::move(done), value](const Status& status) {
          // Work that threw has no value.
          done(*value ? std::move(**value) : Result<T>(status.error()));
        });
  }

  [[nodiscard]] std::vector<Job*> jobs() const { return jobs_; }

 Q_SIGNALS:
  void job_started(limbwave::ui::Job* job);
  void job_finished(limbwave::ui::Job* job);  ///< Last chance to read it.

 private:
  std::vector<Job*> jobs_;
};

}  // namespace limbwave::ui
