#include "decode/golay.h"

#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "acquire/inertial_word_format.h"

namespace limbwave::decode {
namespace {

// The code from its definition alone: the remainder by bits of a polynomial, and a parity bit.
std::uint32_t codeword(std::uint32_t data) {
  std::uint32_t word = data << 11U;
  for (std::uint32_t at = 0x400000; at >= 0x800; at >>= 1U) {
    if ((word & at) != 0) {
      word ^= acquire::kGolayGenerator * (at >> 11U);
    }
  }
  word |= data << 11U;
  return (word << 1U) | (static_cast<std::uint32_t>(std::popcount(word)) & 1U);
}

TEST(Golay, DistanceIsEight) {
  int lightest = 24;
  for (std::uint32_t data = 1; data < 4096; ++data) {
    lightest = std::min(lightest, std::popcount(codeword(data)));
  }
  EXPECT_EQ(lightest, 8);
}

TEST(Golay, CorrectsAllPatternsUpToThreeBits) {
  for (const std::uint32_t data : {0U, 1U, 0x800U, 0xFFFU, 0x5A3U}) {
    const std::uint32_t sent = codeword(data);
    for (unsigned i = 0; i < 24; ++i) {
      for (unsigned j = 0; j <= i; ++j) {
        for (unsigned k = 0; k <= j; ++k) {
          const std::uint32_t wrong = (1U << i) | (1U << j) | (1U << k);
          const GolayWord word = golay_decode(sent ^ wrong);
          ASSERT_EQ(word.data, data);
          ASSERT_EQ(word.pattern, wrong);
          ASSERT_EQ(word.errors, std::popcount(wrong));
        }
      }
    }
    EXPECT_EQ(golay_decode(sent).errors, 0);
  }
}

TEST(Golay, NoticesFourWrongBits) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 20000; ++trial) {
    std::uint32_t wrong = 0;
    while (std::popcount(wrong) < 4) {
      wrong |= 1U << (random() % 24U);
    }
    EXPECT_EQ(golay_decode(codeword(random() & 0xFFFU) ^ wrong).errors, 4);
  }
}

// At a wrong place of the scrambling nothing looks like words, whatever is sent.
TEST(Golay, ScramblingTellsWhereAFrameBegins) {
  std::mt19937 random(7);
  int least = 16;
  for (int shift = 1; shift < acquire::kScramblingBits; ++shift) {
    for (int trial = 0; trial < 3; ++trial) {
      std::array<std::uint32_t, acquire::kGolayWords> words{};
      for (int i = 0; i < 2 * acquire::kWordBits; ++i) {
        // All words zero: the line carries the scrambling alone, the worst case.
        const auto sent = acquire::kScrambling[static_cast<std::size_t>((i + shift) % acquire::kScramblingBits)];
        const auto assumed = acquire::kScrambling[static_cast<std::size_t>(i)];
        if (i < acquire::kWordBits) {
          auto& word = words[static_cast<std::size_t>(i % acquire::kGolayWords)];
          word = (word << 1U) | static_cast<std::uint32_t>(sent ^ assumed);
        }
      }
      int errors = 0;
      for (const std::uint32_t word : words) {
        errors += golay_decode(word).errors;
      }
      least = std::min(least, errors);
    }
  }
  EXPECT_GE(least, 4);
}

}  // namespace
}  // namespace limbwave::decode
