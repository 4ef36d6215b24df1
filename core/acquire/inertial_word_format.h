/// The inertial words on a driver box's wires (signals.md §2): definitions alone, shared by everything that writes or
/// reads them.
///
/// A board sends one frame of 96 bits per reading, bit after bit without a pause or sync bits, as NRZ (1 is positive).
///
///   payload   48 bits, first to last: six 6-bit delta codes (gyroscope x y z, accelerometer x y z), then the 12-bit
///             absolute value of channel n mod 6 as it is after the deltas of this frame n; each first bit highest.
///   coded     four words of 12 payload bits, each followed by 11 check bits and one parity bit (extended Golay code).
///             Check bits are the remainder of (12 bits · x^11) by kGolayGenerator; parity makes the number of ones
///             even.
///   sent      bit i of a frame is bit i / 4 of word i mod 4, XOR kScrambling bit (n mod 6) · 96 + i.
///
/// A delta code is a two's complement number k, -32..31; the value moves by sign(k) · kDeltaSteps[|k|] and is kept
/// within -2048..2047. The board tracks what a receiver holds and sends the code that comes nearest to the new reading,
/// so that rounding errors are carried forward and never add up.
#pragma once

#include <array>
#include <cstdint>

namespace limbwave::acquire {

inline constexpr int kWordChannels = 6;
inline constexpr int kWordBits = 96;         ///< Of a frame as sent.
inline constexpr int kGolayWords = 4;        ///< Of a frame.
inline constexpr int kGolayBits = 24;        ///< Of a word.
inline constexpr int kScramblingFrames = 6;  ///< After so many frames the scrambling repeats.
inline constexpr int kScramblingBits = kScramblingFrames * kWordBits;
/// x^11 + x^10 + x^6 + x^5 + x^4 + x^2 + 1.
inline constexpr std::uint32_t kGolayGenerator = 0xC75;
inline constexpr int kReadingLimit = 2048;  ///< Readings are -2048..2047; full scale of the rig's range.

inline constexpr std::array<int, 33> kDeltaSteps = {0,   1,   2,   3,   4,   5,   6,   8,   10,  12,  15,
                                                    18,  22,  27,  33,  40,  48,  58,  70,  84,  101, 122,
                                                    147, 177, 213, 256, 308, 370, 445, 535, 643, 773, 929};

/// Output of the shift register x^10 + x^7 + 1 that starts with ones, sent bit first.
constexpr std::array<std::uint8_t, kScramblingBits> make_scrambling() {
  std::array<std::uint8_t, kScramblingBits> bits{};
  unsigned state = 0x3FF;
  for (auto& bit : bits) {
    bit = static_cast<std::uint8_t>((state >> 9U) & 1U);
    const unsigned feedback = ((state >> 9U) ^ (state >> 6U)) & 1U;
    state = ((state << 1U) | feedback) & 0x3FFU;
  }
  return bits;
}
inline constexpr std::array<std::uint8_t, kScramblingBits> kScrambling = make_scrambling();

}  // namespace limbwave::acquire
