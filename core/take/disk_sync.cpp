#include "take/disk_sync.h"

#include <fcntl.h>
#include <unistd.h>

#include <condition_variable>
#include <mutex>
#include <thread>

namespace limbwave::take {

struct DiskSync::Impl {
  std::vector<int> files;
  std::chrono::milliseconds interval{};
  std::mutex mutex;
  std::condition_variable changed;
  bool waiting = false;  // something was written that is not on the disk
  bool ending = false;
  std::thread thread;

  void run() {
    std::unique_lock lock(mutex);
    while (!ending) {
      // Waiting before syncing bounds how often it happens, however often something is written.
      changed.wait_for(lock, interval, [this] { return ending; });
      changed.wait(lock, [this] { return ending || waiting; });
      if (ending) {
        return;  // whoever closes the files syncs them
      }
      waiting = false;
      lock.unlock();
      for (const int file : files) {
        (void)::fdatasync(file);  // a disk that fails shows when writing or closing
      }
      lock.lock();
    }
  }
};

DiskSync::DiskSync(const std::vector<std::filesystem::path>& files, std::chrono::milliseconds interval)
    : impl_(std::make_unique<Impl>()) {
  for (const std::filesystem::path& path : files) {
    if (const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC); file >= 0) {
      impl_->files.push_back(file);
    }
  }
  impl_->interval = interval;
  impl_->thread = std::thread([impl = impl_.get()] { impl->run(); });
}

DiskSync::~DiskSync() {
  {
    const std::scoped_lock lock(impl_->mutex);
    impl_->ending = true;
  }
  impl_->changed.notify_one();
  impl_->thread.join();
  for (const int file : impl_->files) {
    ::close(file);
  }
}

void DiskSync::written() {
  {
    const std::scoped_lock lock(impl_->mutex);
    if (impl_->waiting) {
      return;
    }
    impl_->waiting = true;
  }
  impl_->changed.notify_one();
}

}  // namespace limbwave::take
