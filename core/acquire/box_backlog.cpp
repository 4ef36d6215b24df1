#include "acquire/box_backlog.h"

#include <fmt/format.h>

#include <chrono>
#include <utility>

namespace limbwave::acquire {

void BoxBacklog::hand_over(BoxPiece piece) {
  waiting_ += piece.bytes.size();
  if (piece.lost == 0 && !ready_.pieces.empty()) {
    auto& bytes = ready_.pieces.back().bytes;
    bytes.insert(bytes.end(), piece.bytes.begin(), piece.bytes.end());
  } else {
    ready_.pieces.push_back(std::move(piece));
  }
}

void BoxBacklog::close_gap() {
  if (late_ == 0) {
    return;
  }
  ready_.events.push_back({SampleIndex{published_}, "dropped",
                           fmt::format("{} samples were lost because the disk was too slow", late_), late_});
  hand_over({late_, {}});
  published_ += late_;
  late_frames_ += static_cast<std::uint64_t>(late_);
  ++late_gaps_;
  late_ = 0;
}

void BoxBacklog::push(BoxPart part, bool last) {
  const std::lock_guard lock(mutex_);
  ready_.events.insert(ready_.events.end(), part.events.begin(), part.events.end());
  // Not with every frame that is taken: gaps would be many and short.
  if (last || waiting_ <= most_ / 2) {
    close_gap();
  }
  for (BoxPiece& piece : part.pieces) {
    const auto frames = static_cast<std::int64_t>(piece.bytes.size() / frame_bytes_);
    if (late_ > 0 || waiting_ + piece.bytes.size() > most_) {
      if (piece.lost > 0) {  // told as a gap of its own already
        close_gap();
        published_ += piece.lost;
        hand_over({piece.lost, {}});
      }
      late_ += frames;
      continue;
    }
    published_ += piece.lost + frames;
    hand_over(std::move(piece));
  }
  if (last) {
    close_gap();
  }
  if (!ready_.pieces.empty() || !ready_.events.empty()) {
    arrived_.notify_one();
  }
}

BoxPart BoxBacklog::pull(double timeout_s) {
  std::unique_lock lock(mutex_);
  arrived_.wait_for(lock, std::chrono::duration<double>(timeout_s),
                    [&] { return !ready_.pieces.empty() || !ready_.events.empty(); });
  waiting_ = 0;
  return std::exchange(ready_, {});
}

void BoxBacklog::add_to(BoxCounters& counters) const {
  const std::lock_guard lock(mutex_);
  counters.lost_frames += late_frames_;
  counters.gaps += late_gaps_;
}

}  // namespace limbwave::acquire
