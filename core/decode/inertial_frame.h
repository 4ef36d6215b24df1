/// One frame of an inertial word: 96 bits to 48 of payload.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "acquire/inertial_word_format.h"

namespace limbwave::decode {

struct DecodedFrame {
  std::array<std::uint8_t, 48> payload{};
  int errors = 0;  // corrected
  bool good = true;
};

/// Takes scrambling `pattern` off 96 bits, undoes the interleaving and corrects four Golay words.
DecodedFrame decode_frame(const std::uint8_t* bits, int pattern);

/// `count` bits from `first` on as a number in two's complement.
int take_bits(const std::array<std::uint8_t, 48>& payload, std::size_t first, std::size_t count);

}  // namespace limbwave::decode
