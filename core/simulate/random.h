/// Random numbers that are the same on every machine and do not depend on each other across purposes.
#pragma once

#include <cmath>
#include <cstdint>
#include <string_view>

#include "base/units.h"

namespace limbwave::simulate {

/// xoshiro256** (Blackman & Vigna 2018), seeded from a seed and the name of what it is for. A stream of its own for
/// every source of error: switching one on changes no draw of another.
class Random {
 public:
  Random(std::uint64_t seed, std::string_view purpose) {
    std::uint64_t state = seed ^ 0x9E3779B97F4A7C15ULL;
    for (const char c : purpose) {
      state = (state ^ static_cast<unsigned char>(c)) * 0x100000001B3ULL;
    }
    for (std::uint64_t& word : state_) {  // splitmix64, as its authors advise
      state += 0x9E3779B97F4A7C15ULL;
      std::uint64_t z = state;
      z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
      z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
      word = z ^ (z >> 31U);
    }
  }

  std::uint64_t bits() {
    const std::uint64_t result = rotate_left(state_[1] * 5, 7) * 9;
    const std::uint64_t shifted = state_[1] << 17U;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= shifted;
    state_[3] = rotate_left(state_[3], 45);
    return result;
  }

  /// 0 <= u < 1.
  double uniform() { return static_cast<double>(bits() >> 11U) * 0x1.0p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Mean 0, standard deviation 1 (Box–Muller).
  double normal() {
    if (has_spare_) {
      has_spare_ = false;
      return spare_;
    }
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    const double angle = 2.0 * kPi * uniform();
    spare_ = radius * std::sin(angle);
    has_spare_ = true;
    return radius * std::cos(angle);
  }

 private:
  static std::uint64_t rotate_left(std::uint64_t x, unsigned bits) { return (x << bits) | (x >> (64U - bits)); }

  std::uint64_t state_[4] = {};
  double spare_ = 0.0;
  bool has_spare_ = false;
};

}  // namespace limbwave::simulate
