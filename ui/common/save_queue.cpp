#include "common/save_queue.h"

#include <system_error>
#include <utility>

namespace limbwave::ui {
namespace fs = std::filesystem;

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
    Status status = item.work();
    const std::scoped_lock lock(state.queue_mutex);
    state.ended.push_back({std::move(item.what), std::move(status), std::move(item.done)});
  }
}

fs::path SaveQueue::resolve(const State& state, fs::path folder) {
  for (auto found = state.moved.find(folder); found != state.moved.end(); found = state.moved.find(folder)) {
    folder = found->second;
  }
  return folder;
}

void SaveQueue::add(const QString& what, Work work, Done done) {
  {
    const std::scoped_lock lock(state_->queue_mutex);
    state_->waiting.push_back({what, std::move(work), std::move(done)});
  }
  if (!running_) {
    start();
  }  // Else what runs takes this too, or `report` starts anew.
}

void SaveQueue::add(const QString& what, const fs::path& take, TakeWork work) {
  // The state is alive as long as anybody drains it.
  add(what, [take, work = std::move(work), state = state_.get()] { return work(resolve(*state, take)); });
}

void SaveQueue::move(const QString& what, const fs::path& from, const fs::path& to, Done done) {
  add(
      what,
      [from, to, state = state_.get()]() -> Status {
        const fs::path now = resolve(*state, from);
        std::error_code code;
        if (now == to) {
          return {};
        }
        if (fs::exists(to, code)) {
          return Error{"there is a take of this name already", to.string(), "choose another name"};
        }
        fs::rename(now, to, code);
        if (code) {
          return Error{"cannot be renamed (" + code.message() + ")", now.string(),
                       "check that you may write into its folder"};
        }
        state->moved.erase(to);
        state->moved[now] = to;
        return {};
      },
      std::move(done));
}

void SaveQueue::start() {
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
  std::vector<Ended> ended;
  bool more = false;
  {
    const std::scoped_lock lock(state_->queue_mutex);
    ended = std::exchange(state_->ended, {});
    more = !state_->waiting.empty();
  }
  if (more) {
    start();
  }
  for (const Ended& one : ended) {
    if (!one.status) {
      Q_EMIT failed(one.what, one.status.error());
    }
    if (one.done) {
      one.done(one.status);
    }
  }
}

void SaveQueue::finish() {
  drain(*state_);
}

}  // namespace limbwave::ui
