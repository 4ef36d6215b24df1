#include "signal/min_max_pyramid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace limbwave::signal {

MinMaxPyramid::MinMaxPyramid(std::int64_t base, int factor) : base_(base), factor_(factor) {
  assert(base >= 1 && factor >= 2);
  clear();
}

void MinMaxPyramid::clear() {
  size_ = 0;
  levels_.assign(1, {});
  open_.assign(1, empty_block());
  open_count_.assign(1, 0);
}

MinMaxPyramid::Block MinMaxPyramid::empty_block() {
  return {std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};
}

void MinMaxPyramid::merge(Block& into, const Block& block) {
  into.minimum = std::min(into.minimum, block.minimum);
  into.maximum = std::max(into.maximum, block.maximum);
}

void MinMaxPyramid::add(float sample) {
  if (std::isfinite(sample)) {
    merge(open_[0], {sample, sample});
  }
  if (++open_count_[0] == base_) {
    close_block(0, open_[0]);
    open_[0] = empty_block();
    open_count_[0] = 0;
  }
}

void MinMaxPyramid::close_block(std::size_t level, Block block) {
  levels_[level].push_back(block);
  const std::size_t above = level + 1;
  if (above == levels_.size()) {
    if (levels_[level].size() < static_cast<std::size_t>(factor_)) {
      return;
    }
    // A new top level takes in all that is below it.
    levels_.emplace_back();
    open_.push_back(empty_block());
    open_count_.push_back(0);
    Block whole = empty_block();
    for (const Block& part : levels_[level]) {
      merge(whole, part);
    }
    levels_[above].push_back(whole);
    return;
  }
  merge(open_[above], block);
  if (++open_count_[above] == factor_) {
    const Block full = open_[above];
    open_[above] = empty_block();
    open_count_[above] = 0;
    close_block(above, full);
  }
}

void MinMaxPyramid::append(std::span<const float> samples) {
  append(samples, 1);
}

void MinMaxPyramid::append(std::span<const float> interleaved, std::size_t stride) {
  assert(stride >= 1);
  for (std::size_t i = 0; i < interleaved.size(); i += stride) {
    add(interleaved[i]);
    ++size_;
  }
}

std::vector<MinMaxPoint> MinMaxPyramid::query(std::int64_t first, std::int64_t last, int points) const {
  first = std::clamp<std::int64_t>(first, 0, size_);
  last = std::clamp<std::int64_t>(last, 0, size_);
  std::vector<MinMaxPoint> result;
  if (first >= last || points <= 0) {
    return result;
  }
  // The coarsest level that still gives every point a block of its own.
  std::size_t level = 0;
  std::int64_t length = base_;
  while (level + 1 < levels_.size() && (last - first) / (length * factor_) >= points) {
    length *= factor_;
    ++level;
  }
  for (std::int64_t index = first / length; index * length < last; ++index) {
    Block block = empty_block();
    if (static_cast<std::size_t>(index) < levels_[level].size()) {
      block = levels_[level][static_cast<std::size_t>(index)];
    } else {
      // The newest stretch: what is open on this level and on all below it.
      for (std::size_t below = 0; below <= level; ++below) {
        merge(block, open_[below]);
      }
    }
    MinMaxPoint point{index * length, std::min(length, size_ - index * length), block.minimum, block.maximum};
    if (block.minimum > block.maximum) {
      point.minimum = point.maximum = std::numeric_limits<float>::quiet_NaN();
    }
    result.push_back(point);
  }
  return result;
}

}  // namespace limbwave::signal
