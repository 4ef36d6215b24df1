/// Time as three types that cannot be mixed up: a position on a sample clock, a distance on it, and seconds.
#pragma once

#include <compare>
#include <cstdint>

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

/// Seconds since the start of the take, or a duration in seconds.
struct Seconds {
  double value = 0.0;
  auto operator<=>(const Seconds&) const = default;
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
  [[nodiscard]] constexpr SampleIndex index(Seconds time) const { return {static_cast<std::int64_t>(time.value * hz)}; }
};

}  // namespace limbwave
