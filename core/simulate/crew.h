/// Threads that share out work of equal pieces.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace limbwave::simulate {

/// Threads that wait for work. The caller's thread works too.
class Crew {
 public:
  /// `threads` counts the caller's; at least 1.
  explicit Crew(int threads);
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  /// `work(i)` for every i below `count`, in any order; returns when all is done. `work` does not throw.
  void each(std::size_t count, const std::function<void(std::size_t)>& work);

 private:
  void help();
  bool one();

  std::mutex mutex_;
  std::condition_variable begun_, done_;
  const std::function<void(std::size_t)>* work_ = nullptr;
  std::size_t next_ = 0, count_ = 0, left_ = 0;
  bool stopping_ = false;
  std::vector<std::thread> threads_;  // last: they use the others
};

}  // namespace limbwave::simulate
