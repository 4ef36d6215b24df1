/// Time as three types that cannot be mixed up: a position on a sample clock, a distance on it, and seconds.
#pragma once

#include <compare>
#include <cstdint>
#include <limits>

namespace limbwave {

/// A distance between two samples of one clock.
struct SampleCount {
  std::int64_t value = 0;
  auto operator<=>(const SampleCount&) const = default;
};

/// A position on a sample clock; sample 0 is the first one of the take.
struct SampleIndex {
  std::int64_t value = 0;
  auto operator<=>(const SampleIndex&) const = default;
  SampleIndex& operator+=(SampleCount count) {
    value += count.value;
    return *this;
  }
};

constexpr SampleIndex operator+(SampleIndex index, SampleCount count) {
  return {index.value + count.value};
}
constexpr SampleIndex operator-(SampleIndex index, SampleCount count) {
  return {index.value - count.value};
}
constexpr SampleCount operator-(SampleIndex a, SampleIndex b) {
  return {a.value - b.value};
}
constexpr SampleCount operator+(SampleCount a, SampleCount b) {
  return {a.value + b.value};
}
constexpr SampleCount operator-(SampleCount a, SampleCount b) {
  return {a.value - b.value};
}

/// Seconds since the start of the take, or a duration in seconds. (clang-tidy takes what a defaulted <=> generates,
/// a comparison with 0, for a null pointer.)
struct Seconds {
  double value = 0.0;
  auto operator<=>(const Seconds&) const = default;  // NOLINT(modernize-use-nullptr)
};

constexpr Seconds operator+(Seconds a, Seconds b) {
  return {a.value + b.value};
}
constexpr Seconds operator-(Seconds a, Seconds b) {
  return {a.value - b.value};
}

/// Samples per second of a clock; positive.
struct SampleRate {
  double hz = 0.0;
  auto operator<=>(const SampleRate&) const = default;
  [[nodiscard]] constexpr Seconds seconds(SampleIndex index) const { return {static_cast<double>(index.value) / hz}; }
  [[nodiscard]] constexpr Seconds seconds(SampleCount count) const { return {static_cast<double>(count.value) / hz}; }
  /// The last sample at or before `time`, for times after the start of the take.
  /// A time that a sample falls on but for rounding is that sample's: index(seconds(i)) == i.
  [[nodiscard]] constexpr SampleIndex index(Seconds time) const {
    const double samples = time.value * hz;
    const auto below = static_cast<std::int64_t>(samples);
    const auto next = static_cast<double>(below + 1);
    return {next - samples <= 4.0 * std::numeric_limits<double>::epsilon() * next ? below + 1 : below};
  }
};

}  // namespace limbwave
