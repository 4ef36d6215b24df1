/// Edges of the counter bit: found as steps, then timed to a hundredth of a sample.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "decode/line_in.h"

namespace limbwave::decode {

/// A stretch of one channel: `samples[i]` is sample `first + i` of the take.
struct ChannelView {
  const float* samples = nullptr;
  std::int64_t first = 0;
  std::int64_t last = 0;  ///< One past the newest.
  [[nodiscard]] const float* at(std::int64_t index) const { return samples + (index - first); }
};

struct CounterEdge {
  double position = 0.0;  ///< In samples of the take; sample n spans [n − ½, n + ½).
  bool rising = false;
  double step = 0.0;  ///< Height with sign, fraction of full scale.
};

/// Lengths that the search works with; they depend on rate and board only.
struct EdgeScales {
  EdgeScales(const LineInFormat& format, SampleRate rate);
  std::int64_t block;   ///< Samples that are summed before looking for steps.
  std::int64_t window;  ///< Samples on either side that may belong to the edge.
  std::int64_t level;   ///< Samples beyond, on either side, that give the levels.
  /// Samples that must be known beyond an edge to time it as well as can be.
  [[nodiscard]] std::int64_t reach() const { return window + level + 1; }
};

/// Exact time and height of the step near sample `near`; empty when too close to an end. Levels are flattened by
/// `kappa` (coupling, per sample); the time is where a step of the same area would be: exact for averaging samplers
/// and for every linear-phase filter.
std::optional<CounterEdge> time_edge(const ChannelView& channel, std::int64_t near, double kappa,
                                     const EdgeScales& scales);

/// Finds steps in one direction of time, on a grid fixed to the first sample: does not depend on the blocks pushed.
class StepScanner {
 public:
  StepScanner(const EdgeScales& scales, std::int64_t first) : scales_(scales), origin_(first) {}

  struct Step {
    std::int64_t near = 0;
    double height = 0.0;  ///< Roughly, with sign.
  };
  /// The next step of at least `threshold`; empty when no more can be told from the samples so far. At the `end` of
  /// a stretch the last blocks are looked at too.
  std::optional<Step> next(const ChannelView& channel, double threshold, bool end);
  /// There is nothing to look for before this sample.
  void skip_to(std::int64_t sample);
  /// First sample that the scanner still needs.
  [[nodiscard]] std::int64_t needs_from() const;
  /// Every step found so far lies before this sample, every one to come at or after it.
  [[nodiscard]] std::int64_t position() const { return origin_ + (summed_ - kAhead) * scales_.block; }

 private:
  static constexpr std::int64_t kNear = 4;           // blocks on either side among which a step must be the largest
  static constexpr std::int64_t kAhead = kNear + 3;  // blocks after a step before that is known
  static constexpr std::size_t kHistory = 16;        // power of two
  static constexpr std::int64_t kOffset = 64;        // keeps indices of the history positive
  [[nodiscard]] bool is_largest(std::int64_t block, float height) const;

  EdgeScales scales_;
  std::int64_t origin_;
  std::int64_t summed_ = 0;  // blocks summed so far
  bool fresh_ = true;
  std::array<float, 5> sums_{};            // of the newest blocks
  std::array<float, kHistory> heights_{};  // second half of two blocks minus first, around a block
};

/// The counter as the judge needs it: all edges of a stretch, if they look like a counter's.
struct CounterSearch {
  bool regular = false;       ///< Alternating edges at equal distances.
  double half_samples = 0.0;  ///< Their distance, median.
  double step = 0.0;          ///< Their height, median.
  std::vector<CounterEdge> edges;
};
/// Looks for a square wave of any rate from a third to three times the board's.
CounterSearch find_counter(const ChannelView& channel, const LineInFormat& format, SampleRate rate, double kappa);

/// Where one cycle lies.
struct CycleBounds {
  double start = 0.0;   ///< Falling edge: slot 0.
  double middle = 0.0;  ///< Rising edge: slot slots/2.
  double end = 0.0;     ///< Next falling edge.
};

/// Makes cycles of edges: only three edges at the expected distances make one.
class CycleTracker {
 public:
  CycleTracker(const LineInFormat& format, SampleRate rate);
  /// Forgets waiting edges; half of a cycle is expected to take `half_samples`.
  void restart(double half_samples);
  std::optional<CycleBounds> push(const CounterEdge& edge);
  [[nodiscard]] double half() const { return half_; }

 private:
  double shortest_, longest_;
  double half_ = 0.0;
  int rejected_ = 0;
  std::deque<CounterEdge> edges_;
};

}  // namespace limbwave::decode
