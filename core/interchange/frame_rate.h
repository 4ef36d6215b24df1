/// Frame rates that files give as rounded frame times.
#pragma once

#include <cstddef>
#include <string_view>

namespace limbwave::interchange {

/// The rate in hertz that a frame time of `seconds`, written as `digits`, means: a common rate (film, television,
/// motion capture) when it lies within the rounding of the digits and within 0.3 %, else 1 / seconds. So "0.0083333" is
/// 120 Hz and "0.0333" is 30 Hz, while "0.03" stays 33.3 Hz.
double frame_rate_from_text(double seconds, std::string_view digits);

/// 24/1.001 for "23.976", and so on for the other rates of NTSC television, which people write with two or three
/// decimals; all other rates as they are.
double exact_frame_rate(double fps);

/// Frames per second that are written; and how many numbers a text file may have: what is more is a mistake in the
/// frame rate or the key times, and would fill the memory.
inline constexpr double kHighestFrameRate = 1e5;
inline constexpr std::size_t kMostNumbers = 1'000'000'000;

/// What a key time means in a file that holds it in 32 bits: the frame that has the same 32 bits, so that fast
/// movements stay on their frames; between frames, the 32-bit time itself. Seconds; `fps` > 0.
double single_time(double time_s, double fps);

}  // namespace limbwave::interchange
