/// Four floats side by side, for the few loops that touch every sample. Always four and never fused, so that sums are
/// the same on every processor. Uses the vector types of GCC and Clang (Highway has no target for plain SSE2).
#pragma once

#include <cstdint>
#include <cstring>

namespace limbwave::signal {

using Lanes = float __attribute__((vector_size(16)));
inline constexpr int kLanes = 4;

inline Lanes load_lanes(const float* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof(lanes));
  return lanes;
}

inline void store_lanes(Lanes lanes, float* to) {
  std::memcpy(to, &lanes, sizeof(lanes));
}

inline Lanes all_lanes(float value) {
  return Lanes{value, value, value, value};
}

inline Lanes magnitude(Lanes lanes) {
  using Bits = std::int32_t __attribute__((vector_size(16)));
  return reinterpret_cast<Lanes>(reinterpret_cast<Bits>(lanes) & 0x7fffffff);
}

/// Per lane, `a` where it is larger, else `b`; `b` where `a` is NaN.
inline Lanes larger(Lanes a, Lanes b) {
  return a > b ? a : b;
}

/// The sum in double precision, in a fixed order.
inline double sum_of(Lanes lanes) {
  return (static_cast<double>(lanes[0]) + static_cast<double>(lanes[1])) +
         (static_cast<double>(lanes[2]) + static_cast<double>(lanes[3]));
}

inline float largest_of(Lanes lanes) {
  const float a = lanes[0] > lanes[1] ? lanes[0] : lanes[1];
  const float b = lanes[2] > lanes[3] ? lanes[2] : lanes[3];
  return a > b ? a : b;
}

}  // namespace limbwave::signal
