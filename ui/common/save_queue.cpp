#include "common/save_queue.h"

#include <utility>

namespace limbwave::ui {

void SaveQueue::drain(State& state) {
  // One at a time, whichever thread does it.
  const std::scoped_lock working(state.work_mutex);
  while (true) {
    Item item;
    {
      const std::scoped_lock lock(state.queue_mutex);
      if (state.waiting.empty()) {
        return;
      }
      item = std::move(state.waiting.front());
      state.waiting.pop_front();
    }
    if (const Status status = item.work(); !status) {
      const std::scoped_lock lock(state.queue_mutex);
      state.failures.emplace_back(item.what, status.error());
    }
  }
}

void SaveQueue::add(const QString& what, Work work) {
  {
    const std::scoped_lock lock(state_->queue_mutex);
    state_->waiting.push_back({what, std::move(work)});
  }
  if (running_) {
    return;  // What runs takes this too, or `report` starts anew.
  }
  running_ = true;
  jobs_.start(
      tr("Saving the take"), this,
      [state = state_](const Progress&) {
        drain(*state);
        return Status();
      },
      [this](const Status&) {
        running_ = false;
        report();
      });
}

void SaveQueue::report() {
  std::vector<std::pair<QString, Error>> failures;
  bool more = false;
  {
    const std::scoped_lock lock(state_->queue_mutex);
    failures = std::exchange(state_->failures, {});
    more = !state_->waiting.empty();
  }
  for (const auto& [what, error] : failures) {
    Q_EMIT failed(what, error);
  }
  if (more) {
    add({}, [] { return Status(); });
  }
}

void SaveQueue::finish() {
  drain(*state_);
}

}  // namespace limbwave::ui
