/// Small writes to the open take, one after another in the order of the edits, beside the window. Nothing that was put
/// in is lost when the studio is closed.
#pragma once

#include <QObject>
#include <QString>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>

#include "common/job_runner.h"

namespace limbwave::ui {

class SaveQueue : public QObject {
  Q_OBJECT
 public:
  using Work = std::function<Status()>;

  explicit SaveQueue(JobRunner& jobs, QObject* parent = nullptr) : QObject(parent), jobs_(jobs) {}
  /// Does what still waits.
  ~SaveQueue() override { finish(); }

  /// `what` names the thing for people when it fails: "The marker is not saved".
  void add(const QString& what, Work work);
  /// Nothing waits and nothing runs.
  [[nodiscard]] bool idle() const { return !running_; }
  /// Does everything that waits now; returns when it is done.
  void finish();

 Q_SIGNALS:
  void failed(const QString& what, const limbwave::Error& error);

 private:
  struct Item {
    QString what;
    Work work;
  };
  struct State {
    std::mutex queue_mutex, work_mutex;
    std::deque<Item> waiting;
    std::vector<std::pair<QString, Error>> failures;
  };
  static void drain(State& state);
  void report();

  JobRunner& jobs_;
  std::shared_ptr<State> state_ = std::make_shared<State>();
  bool running_ = false;
};

}  // namespace limbwave::ui
