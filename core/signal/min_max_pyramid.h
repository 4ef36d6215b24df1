/// Smallest and largest value of every stretch of a signal, at many zoom levels: draws an hour as fast as a second.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace limbwave::signal {

/// What one column of a plot shows: the extremes of `count` samples from `first` on. NaN where no sample was finite.
struct MinMaxPoint {
  std::int64_t first = 0;
  std::int64_t count = 0;
  float minimum = 0.0F;
  float maximum = 0.0F;
};

/// Append-only. Level 0 holds blocks of `base` samples, every further level blocks `factor` times as long; the samples
/// themselves are not kept (one hour at 48 kHz and base 64 takes 25 MB), so `base` is the finest step that can be
/// drawn. Non-finite samples are left out. Not thread-safe.
class MinMaxPyramid {
 public:
  /// `base` >= 1 samples; `factor` >= 2.
  explicit MinMaxPyramid(std::int64_t base = 64, int factor = 4);

  /// Appends samples; the result does not depend on how they are cut into calls. Amortised constant time per sample.
  void append(std::span<const float> samples);
  /// Appends every `stride`-th value, starting with the first: one channel of interleaved samples.
  void append(std::span<const float> interleaved, std::size_t stride);
  void clear();

  /// Samples appended so far.
  [[nodiscard]] std::int64_t size() const { return size_; }
  /// Samples per block of the finest level.
  [[nodiscard]] std::int64_t base() const { return base_; }

  /// The extremes of samples [first, last), clamped to what there is, as at least `points` and fewer than
  /// `points` · factor + 2 blocks, unless the finest level has fewer. The blocks lie on the level's own grid: the first
  /// and the last may reach beyond the range. Empty for an empty range or points <= 0.
  [[nodiscard]] std::vector<MinMaxPoint> query(std::int64_t first, std::int64_t last, int points) const;

 private:
  struct Block {
    float minimum;
    float maximum;
  };
  static Block empty_block();
  static void merge(Block& into, const Block& block);
  void add(float sample);
  void close_block(std::size_t level, Block block);

  std::int64_t base_;
  int factor_;
  std::int64_t size_ = 0;
  std::vector<std::vector<Block>> levels_;  // whole blocks only
  std::vector<Block> open_;                 // per level: the block that still grows
  std::vector<std::int64_t> open_count_;    // per level: samples (level 0) or blocks in it
};

}  // namespace limbwave::signal
