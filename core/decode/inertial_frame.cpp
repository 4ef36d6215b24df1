#include "decode/inertial_frame.h"

#include "decode/golay.h"

namespace limbwave::decode {

using acquire::kWordBits;

DecodedFrame decode_frame(const std::uint8_t* bits, int pattern) {
  DecodedFrame frame;
  std::array<std::uint32_t, acquire::kGolayWords> words{};
  const std::uint8_t* scrambling = acquire::kScrambling.data() + static_cast<std::ptrdiff_t>(pattern) * kWordBits;
  for (std::size_t i = 0; i < kWordBits; ++i) {
    auto& word = words[i % acquire::kGolayWords];
    word = (word << 1U) | static_cast<std::uint32_t>(bits[i] ^ scrambling[i]);
  }
  for (std::size_t w = 0; w < words.size(); ++w) {
    const GolayWord word = golay_decode(words[w]);
    frame.good = frame.good && word.errors <= 3;
    frame.errors += word.errors;
    for (std::size_t bit = 0; bit < 12; ++bit) {
      frame.payload[12 * w + bit] = static_cast<std::uint8_t>((word.data >> (11U - bit)) & 1U);
    }
  }
  return frame;
}

int take_bits(const std::array<std::uint8_t, 48>& payload, std::size_t first, std::size_t count) {
  int value = payload[first] != 0 ? -1 : 0;  // two's complement
  for (std::size_t i = first; i < first + count; ++i) {
    value = value * 2 + payload[i];
  }
  return value;
}

}  // namespace limbwave::decode
