/// How a sound card that plays and captures at once knows which captured sample belongs to which played one: a mark on
/// one output, heard on one input through a cable.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace limbwave::acquire {

/// Barker's sequence of thirteen, eight samples a chip: longer than any ringing of a converter, and unmistakable.
inline constexpr int kMarkChip = 8;
inline constexpr std::array<float, 13> kMarkChips = {1, 1, 1, 1, 1, -1, -1, 1, 1, -1, 1, -1, 1};
inline constexpr int kMarkSamples = kMarkChip * static_cast<int>(kMarkChips.size());

/// Sample n of the mark, ±1; 0 beyond its end.
float mark_sample(std::int64_t n);

/// Where in `samples` the first mark begins, of whatever size and sign; to the sample. Empty when there is none: what
/// looks most like it must be at least `clear` times as strong as what looks like it anywhere else.
std::optional<std::int64_t> find_mark(std::span<const float> samples, double clear = 2.0);

}  // namespace limbwave::acquire
