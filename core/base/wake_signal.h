/// Wakes one waiting thread; the waking side never blocks.
#pragma once

#include <atomic>
#include <chrono>
#include <semaphore>

namespace limbwave {

/// Any number of `notify` before the waiting thread gets to run count as one. What was written before `notify` is seen
/// after `wait_for` has answered true. An audio callback may call `notify`: it is one atomic exchange, and a wake-up
/// call to the system only when the other side has taken the last one.
class WakeSignal {
 public:
  void notify() {
    if (!pending_.exchange(true, std::memory_order_acq_rel)) {
      semaphore_.release();
    }
  }
  /// False when nothing came within `timeout`.
  template <typename Rep, typename Period>
  bool wait_for(std::chrono::duration<Rep, Period> timeout) {
    if (!semaphore_.try_acquire_for(timeout)) {
      return false;
    }
    pending_.exchange(false, std::memory_order_acq_rel);
    return true;
  }

 private:
  std::atomic<bool> pending_{false};
  std::counting_semaphore<2> semaphore_{0};
};

}  // namespace limbwave
