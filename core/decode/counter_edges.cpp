#include "decode/counter_edges.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "decode/settled_window.h"

namespace limbwave::decode {
namespace {

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

EdgeScales::EdgeScales(const LineInFormat& format, SampleRate rate) {
  const double slot = rate.hz / (format.cycle_rate_hz * format.slots);
  block = std::max<std::int64_t>(1, std::llround(slot / 12.0));
  window = std::max<std::int64_t>(3, std::llround(0.4 * slot));
  level = std::max<std::int64_t>(3, std::llround(0.8 * slot));
}

std::optional<CounterEdge> time_edge(const ChannelView& channel, std::int64_t near, double kappa,
                                     const EdgeScales& scales) {
  const std::int64_t from = near - scales.window;
  const std::int64_t to = near + scales.window + 1;  // one past
  const std::int64_t level_from = std::max(channel.first, from - scales.level);
  const std::int64_t level_to = std::min(channel.last, to + scales.level);
  if (from - level_from < 3 || level_to - to < 3) {
    return std::nullopt;
  }
  double integral = 0.0;
  double previous = 0.0;
  double before = 0.0;
  double inside = 0.0;
  double after = 0.0;
  const float* y = channel.at(level_from);
  for (std::int64_t n = level_from; n < level_to; ++n, ++y) {
    integral += n == level_from ? 0.0 : 0.5 * (previous + *y);
    previous = *y;
    const double x = *y + kappa * integral;
    (n < from ? before : n < to ? inside : after) += x;
  }
  before /= static_cast<double>(from - level_from);
  after /= static_cast<double>(level_to - to);
  const double step = after - before;
  if (step == 0.0) {
    return std::nullopt;
  }
  const double count = static_cast<double>(to - from);
  const double position = static_cast<double>(from) - 0.5 + (after * count - inside) / step;
  if (!(position > static_cast<double>(from) && position < static_cast<double>(to))) {
    return std::nullopt;
  }
  return CounterEdge{position, step > 0.0, step};
}

std::int64_t StepScanner::needs_from() const {
  return origin_ + std::max<std::int64_t>(0, summed_ - 2 * kAhead) * scales_.block - scales_.reach();
}

bool StepScanner::is_largest(std::int64_t block, float height) const {
  const auto magnitude = [&](std::int64_t other) {
    return std::fabs(heights_[static_cast<std::size_t>(other) % kHistory]);
  };
  for (std::int64_t distance = 1; distance <= kNear; ++distance) {
    if (magnitude(block - distance) >= height || magnitude(block + distance) > height) {
      return false;
    }
  }
  return true;
}

void StepScanner::skip_to(std::int64_t sample) {
  const std::int64_t block = (sample - origin_) / scales_.block;
  if (block > summed_) {
    summed_ = block;
    heights_.fill(0.0F);
    fresh_ = true;
  }
}

std::optional<StepScanner::Step> StepScanner::next(const ChannelView& channel, double threshold, bool end) {
  // Blocks past the end repeat the last sum, which makes no steps.
  const std::int64_t available = (channel.last - origin_) / scales_.block;
  const std::int64_t limit = end ? available + kAhead : available;
  const auto least = static_cast<float>(threshold * 2.0 * static_cast<double>(scales_.block));
  const auto per_sample = 1.0 / (2.0 * static_cast<double>(scales_.block));
  while (summed_ < limit) {
    float sum = sums_[4];
    if (summed_ < available) {
      const float* samples = channel.at(origin_ + summed_ * scales_.block);
      sum = 0.0F;
      for (std::int64_t i = 0; i < scales_.block; ++i) {
        sum += samples[i];
      }
    }
    if (fresh_) {
      std::fill(sums_.begin(), sums_.end(), sum);  // nor do blocks before the start
      fresh_ = false;
    }
    sums_ = {sums_[1], sums_[2], sums_[3], sums_[4], sum};
    ++summed_;
    // The newest block whose height is known lies two back, the newest whose neighbours are known kAhead.
    heights_[static_cast<std::size_t>(summed_ - 3 + kOffset) % kHistory] = sums_[3] + sums_[4] - sums_[0] - sums_[1];
    const std::int64_t candidate = summed_ - kAhead;
    const float height = heights_[static_cast<std::size_t>(candidate + kOffset) % kHistory];
    if (std::fabs(height) >= least && candidate >= 0 && is_largest(candidate + kOffset, std::fabs(height))) {
      return Step{origin_ + candidate * scales_.block + scales_.block / 2, height * per_sample};
    }
  }
  return std::nullopt;
}

CounterSearch find_counter(const ChannelView& channel, const LineInFormat& format, SampleRate rate, double kappa) {
  CounterSearch search;
  const EdgeScales scales(format, rate);
  std::vector<StepScanner::Step> steps;
  StepScanner scanner(scales, channel.first);
  while (const auto step = scanner.next(channel, 1e-5, true)) {
    steps.push_back(*step);
  }
  const double nominal_half = 0.5 * rate.hz / format.cycle_rate_hz;
  const double length = static_cast<double>(channel.last - channel.first);
  // Fewer edges than these would not be a counter at a third of the board's rate.
  const auto fewest = static_cast<std::size_t>(std::max(4.0, length / nominal_half / 3.0));
  if (steps.size() < fewest) {
    return search;
  }
  std::vector<double> heights;
  heights.reserve(steps.size());
  for (const auto& step : steps) {
    heights.push_back(std::fabs(step.height));
  }
  std::sort(heights.begin(), heights.end(), std::greater<>());
  const double threshold = 0.5 * heights[fewest - 1];
  // A square wave is all step: a sine of the same rate is not.
  double magnitude = 0.0;
  const double mean = sum_samples(channel.at(channel.first), channel.last - channel.first) / length;
  for (std::int64_t n = channel.first; n < channel.last; ++n) {
    magnitude += std::fabs(*channel.at(n) - mean);
  }
  magnitude /= length;

  for (const auto& step : steps) {
    if (std::fabs(step.height) >= threshold) {
      if (const auto edge = time_edge(channel, step.near, kappa, scales)) {
        search.edges.push_back(*edge);
      }
    }
  }
  if (search.edges.size() < 4) {
    return search;
  }
  std::vector<double> distances;
  std::vector<double> sizes;
  for (std::size_t i = 1; i < search.edges.size(); ++i) {
    distances.push_back(search.edges[i].position - search.edges[i - 1].position);
    sizes.push_back(std::fabs(search.edges[i].step));
  }
  search.half_samples = median(distances);
  search.step = median(sizes);
  std::size_t good = 0;
  for (std::size_t i = 1; i < search.edges.size(); ++i) {
    const bool even = std::fabs(distances[i - 1] - search.half_samples) < 0.03 * search.half_samples;
    good += even && search.edges[i].rising != search.edges[i - 1].rising ? 1 : 0;
  }
  search.regular = search.step > 1.2 * magnitude &&
                   static_cast<double>(good) >= 0.8 * static_cast<double>(distances.size()) &&
                   static_cast<double>(good) * search.half_samples >= 0.3 * length;
  return search;
}

CycleTracker::CycleTracker(const LineInFormat& format, SampleRate rate)
    : shortest_(0.5 * rate.hz / format.cycle_rate_hz / (1.0 + format.cycle_rate_tolerance + 0.02)),
      longest_(0.5 * rate.hz / format.cycle_rate_hz / (1.0 - format.cycle_rate_tolerance - 0.02)) {}

void CycleTracker::restart(double half_samples) {
  half_ = half_samples;
  rejected_ = 0;
  edges_.clear();
}

std::optional<CycleBounds> CycleTracker::push(const CounterEdge& edge) {
  edges_.push_back(edge);
  while (edges_.size() >= 3) {
    if (!edges_[0].rising && edges_[1].rising && !edges_[2].rising) {
      const double first = edges_[1].position - edges_[0].position;
      const double second = edges_[2].position - edges_[1].position;
      const auto close = [](double a, double b) { return std::fabs(a - b) < 0.012 * b + 1.0; };
      const bool expected = close(first, half_) && close(second, half_);
      // After a few rejects the clock itself may have changed; then two equal halves are enough.
      const bool changed = rejected_ >= 3 && close(first, second) && std::min(first, second) > shortest_ &&
                           std::max(first, second) < longest_;
      if (expected || changed) {
        const double mean = 0.5 * (first + second);
        half_ = expected ? half_ + 0.25 * (mean - half_) : mean;
        rejected_ = 0;
        const CycleBounds bounds{edges_[0].position, edges_[1].position, edges_[2].position};
        edges_.pop_front();
        edges_.pop_front();
        return bounds;
      }
      ++rejected_;
    }
    edges_.pop_front();
  }
  return std::nullopt;
}

}  // namespace limbwave::decode
