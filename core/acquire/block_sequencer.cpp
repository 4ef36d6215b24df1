#include "acquire/block_sequencer.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

namespace limbwave::acquire {
namespace {

constexpr std::size_t kMostHeld = 16;  // blocks that wait for a missing one

}  // namespace

void BlockSequencer::fill(std::int64_t until) {
  if (until <= next_) {
    return;
  }
  const std::int64_t count = until - next_;
  events_.push_back({SampleIndex{next_}, "dropped", fmt::format("{} samples were lost on the line", count), count});
  pieces_.push_back({count, {}});
  counters_.lost_frames += static_cast<std::uint64_t>(count);
  ++counters_.gaps;
  next_ = until;
}

void BlockSequencer::accept(const BoxBlock& block) {
  const std::int64_t first = block.first + offset_;
  std::int64_t skip = std::max<std::int64_t>(0, next_ - first);
  if (skip >= block.frames) {
    return;
  }
  fill(first);
  if (!started_) {
    started_ = true;
    connected_ = block.connected;
  }
  for (int w = 0; w < wires_; ++w) {
    const std::uint64_t bit = std::uint64_t{1} << static_cast<unsigned>(w);
    if (((connected_ ^ block.connected) & bit) != 0) {
      const bool back = (block.connected & bit) != 0;
      events_.push_back({SampleIndex{next_}, back ? "wire-back" : "wire-pulled",
                         fmt::format("wire {} was {}", w + 1, back ? "plugged in again" : "pulled"), w});
    }
  }
  connected_ = block.connected;
  skip *= wires_;
  if (pieces_.empty()) {
    pieces_.emplace_back();
  }
  const auto bytes = std::as_bytes(std::span(block.samples).subspan(static_cast<std::size_t>(skip)));
  pieces_.back().bytes.insert(pieces_.back().bytes.end(), bytes.begin(), bytes.end());
  next_ = first + block.frames;
}

void BlockSequencer::release() {
  while (!held_.empty() && held_.front().first + offset_ <= next_) {
    accept(held_.front());
    held_.erase(held_.begin());
  }
}

void BlockSequencer::push(BoxBlock block) {
  if (block.wires != wires_) {
    return;
  }
  ++counters_.blocks;
  const std::int64_t first = block.first + offset_;
  const auto same = [&](const BoxBlock& other) { return other.first == block.first; };
  if (first + block.frames <= next_ || std::any_of(held_.begin(), held_.end(), same)) {
    ++counters_.duplicates;
    events_.push_back({SampleIndex{next_}, "duplicated", "a block came twice and was taken once", block.frames});
    return;
  }
  if (first <= next_) {
    const bool late = !held_.empty();
    accept(block);
    if (late) {
      ++counters_.reordered;
      events_.push_back({SampleIndex{next_}, "reordered", "a block came late and was put in its place", block.frames});
    }
    release();
    return;
  }
  const auto place = std::upper_bound(held_.begin(), held_.end(), block.first,
                                      [](std::int64_t at, const BoxBlock& other) { return at < other.first; });
  held_.insert(place, std::move(block));
  if (held_.size() > kMostHeld) {
    give_up();
  }
}

void BlockSequencer::give_up() {
  while (!held_.empty()) {
    fill(held_.front().first + offset_);
    release();
  }
}

void BlockSequencer::restart(SampleIndex at) {
  give_up();
  fill(std::max(at.value, next_));
  offset_ = next_;
}

std::vector<BoxPiece> BlockSequencer::take_pieces() {
  return std::exchange(pieces_, {});
}

std::vector<BoxEvent> BlockSequencer::take_events() {
  return std::exchange(events_, {});
}

}  // namespace limbwave::acquire
