#include "simulate/crew.h"

namespace limbwave::simulate {

Crew::Crew(int threads) {
  for (int i = 1; i < threads; ++i) {
    threads_.emplace_back([this] { help(); });
  }
}

Crew::~Crew() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  begun_.notify_all();
  for (std::thread& thread : threads_) {
    thread.join();
  }
}

// One piece, where there is one.
bool Crew::one() {
  std::size_t piece = 0;
  const std::function<void(std::size_t)>* work = nullptr;
  {
    const std::lock_guard lock(mutex_);
    if (next_ >= count_) {
      return false;
    }
    piece = next_++;
    work = work_;
  }
  (*work)(piece);
  const std::lock_guard lock(mutex_);
  if (--left_ == 0) {
    done_.notify_all();
  }
  return true;
}

void Crew::help() {
  while (true) {
    {
      std::unique_lock lock(mutex_);
      begun_.wait(lock, [&] { return stopping_ || next_ < count_; });
      if (stopping_) {
        return;
      }
    }
    while (one()) {
    }
  }
}

void Crew::each(std::size_t count, const std::function<void(std::size_t)>& work) {
  if (threads_.empty()) {
    for (std::size_t i = 0; i < count; ++i) {
      work(i);
    }
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    work_ = &work;
    next_ = 0;
    count_ = left_ = count;
  }
  begun_.notify_all();
  while (one()) {
  }
  std::unique_lock lock(mutex_);
  done_.wait(lock, [&] { return left_ == 0; });
}

}  // namespace limbwave::simulate
