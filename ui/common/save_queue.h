/// Small writes to the open take, one after another in the order of the edits, beside the window. Nothing that was put
/// in is lost when the studio is closed.
#pragma once

#include <QObject>
#include <QString>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "common/job_runner.h"

namespace limbwave::ui {

class SaveQueue : public QObject {
  Q_OBJECT
 public:
  using Work = std::function<Status()>;
  using TakeWork = std::function<Status(const std::filesystem::path& folder)>;
  using Done = std::function<void(const Status&)>;

  explicit SaveQueue(JobRunner& jobs, QObject* parent = nullptr) : QObject(parent), jobs_(jobs) {}
  /// Does what still waits.
  ~SaveQueue() override { finish(); }

  /// `what` names the thing for people when it fails: "The marker is not saved". `done` is called in the GUI thread.
  void add(const QString& what, Work work, Done done = {});
  /// Work on a take; it is given the folder that the take has by then.
  void add(const QString& what, const std::filesystem::path& take, TakeWork work);
  /// Gives a take another folder. Writes that were put in before go to the old one, later ones to the new one,
  /// whichever of the two they name.
  void move(const QString& what, const std::filesystem::path& from, const std::filesystem::path& to, Done done);
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
    Done done;
  };
  struct Ended {
    QString what;
    Status status;
    Done done;
  };
  struct State {
    std::mutex queue_mutex, work_mutex;
    std::deque<Item> waiting;
    std::vector<Ended> ended;
    std::map<std::filesystem::path, std::filesystem::path> moved;  ///< From, to. Under `work_mutex`.
  };
  static void drain(State& state);
  static std::filesystem::path resolve(const State& state, std::filesystem::path folder);
  void start();
  void report();

  JobRunner& jobs_;
  std::shared_ptr<State> state_ = std::make_shared<State>();
  bool running_ = false;
};

}  // namespace limbwave::ui
