/// The extended Golay code (24,12): corrects three wrong bits of 24 and notices four.
#pragma once

#include <cstdint>

namespace limbwave::decode {

struct GolayWord {
  std::uint32_t data = 0;     ///< 12 bits; of no use when not correctable.
  int errors = 0;             ///< Bits that were corrected, 0..3; 4: not correctable.
  std::uint32_t pattern = 0;  ///< The bits that were wrong.
};

/// Decodes a word whose first-sent bit is bit 23 (core/acquire/inertial_word_format.h).
GolayWord golay_decode(std::uint32_t received);

}  // namespace limbwave::decode
