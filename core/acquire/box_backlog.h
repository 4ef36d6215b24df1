/// What a box's reader has for a consumer that comes when it can.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <vector>

#include "acquire/box_source.h"

namespace limbwave::acquire {

/// Keeps what is in order until it is pulled, but no more than a limit: what a consumer is too late for becomes one gap
/// as soon as it takes again. One thread pushes, one pulls.
class BoxBacklog {
 public:
  /// At most `most` bytes of samples wait, in frames of `frame_bytes`.
  BoxBacklog(std::size_t most, std::size_t frame_bytes) : most_(most), frame_bytes_(frame_bytes) {}

  /// The next part. `last`: nothing follows, and what was left out is told now.
  void push(BoxPart part, bool last = false);
  /// What has come since the last call; waits up to `timeout_s` for something.
  BoxPart pull(double timeout_s);
  /// What the consumer did not get, as frames and as gaps.
  void add_to(BoxCounters& counters) const;

 private:
  void hand_over(BoxPiece piece);
  void close_gap();

  std::size_t most_, frame_bytes_;
  mutable std::mutex mutex_;
  std::condition_variable arrived_;
  BoxPart ready_;
  std::size_t waiting_ = 0;     // bytes in `ready_`
  std::int64_t published_ = 0;  // frames
  std::int64_t late_ = 0;       // frames that are being left out
  std::uint64_t late_frames_ = 0, late_gaps_ = 0;
};

}  // namespace limbwave::acquire
