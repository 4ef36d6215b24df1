/// Who may open or close a device now.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>

namespace limbwave::ui {

/// One after the other, in the order of the tickets: many devices cannot be opened before they are closed.
class DeviceDoor {
 public:
  /// In the GUI thread.
  std::uint64_t ticket() { return issued_++; }
  /// Waits until everybody before is through; leaves when it goes out of scope.
  class Turn {
   public:
    Turn(std::shared_ptr<DeviceDoor> door, std::uint64_t ticket) : door_(std::move(door)) {
      std::unique_lock lock(door_->mutex_);
      door_->moved_on_.wait(lock, [&] { return door_->serving_ == ticket; });
    }
    ~Turn() {
      {
        const std::scoped_lock lock(door_->mutex_);
        ++door_->serving_;
      }
      door_->moved_on_.notify_all();
    }
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

   private:
    std::shared_ptr<DeviceDoor> door_;
  };
  std::atomic<std::uint64_t> newest{0};  // of the attempts to open: an older one need not begin any more

 private:
  std::mutex mutex_;
  std::condition_variable moved_on_;
  std::uint64_t issued_ = 0, serving_ = 0;
};

}  // namespace limbwave::ui
