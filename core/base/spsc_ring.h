/// A ring buffer for exactly one writing and one reading thread, without locks.
#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

namespace limbwave {

/// Single-producer single-consumer ring. The producer may be an audio callback: `write` never blocks or allocates.
template <typename T>
requires std::is_trivially_copyable_v<T>
class SpscRing {
 public:
  /// Room for at least `capacity` elements (rounded up to a power of two).
  explicit SpscRing(std::size_t capacity)
      : buffer_(std::bit_ceil(std::max<std::size_t>(capacity, 2))), mask_(buffer_.size() - 1) {}

  [[nodiscard]] std::size_t capacity() const { return buffer_.size(); }

  /// Elements that can be read now; callable from either side.
  [[nodiscard]] std::size_t available() const {
    return head_.load(std::memory_order_acquire) - tail_.load(std::memory_order_acquire);
  }

  /// Producer: copies all of `items` or, when there is no room for all, nothing. Answers which.
  bool write(std::span<const T> items) {
    const std::size_t head = head_.load(std::memory_order_relaxed);
    const std::size_t tail = tail_.load(std::memory_order_acquire);
    if (buffer_.size() - (head - tail) < items.size()) {
      return false;
    }
    const std::size_t start = head & mask_;
    const std::size_t first = std::min(items.size(), buffer_.size() - start);
    std::copy_n(items.data(), first, buffer_.data() + start);
    std::copy_n(items.data() + first, items.size() - first, buffer_.data());
    head_.store(head + items.size(), std::memory_order_release);
    return true;
  }

  /// Consumer: moves up to `out.size()` elements into `out`; returns how many.
  std::size_t read(std::span<T> out) {
    const std::size_t tail = tail_.load(std::memory_order_relaxed);
    const std::size_t head = head_.load(std::memory_order_acquire);
    const std::size_t count = std::min(out.size(), head - tail);
    const std::size_t start = tail & mask_;
    const std::size_t first = std::min(count, buffer_.size() - start);
    std::copy_n(buffer_.data() + start, first, out.data());
    std::copy_n(buffer_.data(), count - first, out.data() + first);
    tail_.store(tail + count, std::memory_order_release);
    return count;
  }

 private:
  std::vector<T> buffer_;
  std::size_t mask_;
  // On separate cache lines, so that the two threads do not slow each other down.
  alignas(64) std::atomic<std::size_t> head_{0};
  alignas(64) std::atomic<std::size_t> tail_{0};
};

}  // namespace limbwave
