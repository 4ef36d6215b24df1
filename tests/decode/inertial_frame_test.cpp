#include "decode/inertial_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace limbwave::decode {
namespace {

// A payload of zeros has code words of zeros: what is sent is the scrambling alone.
std::vector<std::uint8_t> zeros(int pattern) {
  const std::uint8_t* from = acquire::kScrambling.data() + static_cast<std::ptrdiff_t>(pattern) * acquire::kWordBits;
  return {from, from + acquire::kWordBits};
}

TEST(InertialFrame, BurstsAreSpreadOverFourWords) {
  for (int pattern = 0; pattern < 6; ++pattern) {
    for (const std::size_t first : {std::size_t{0}, std::size_t{41}, std::size_t{84}}) {
      std::vector<std::uint8_t> bits = zeros(pattern);
      for (std::size_t i = first; i < first + 12; ++i) {
        bits[i] ^= 1U;
      }
      const DecodedFrame frame = decode_frame(bits.data(), pattern);
      EXPECT_TRUE(frame.good);
      EXPECT_EQ(frame.errors, 12);
      EXPECT_TRUE(std::all_of(frame.payload.begin(), frame.payload.end(), [](int bit) { return bit == 0; }));
    }
  }
}

TEST(InertialFrame, FourWrongBitsOfOneWordAreNoticed) {
  std::vector<std::uint8_t> bits = zeros(2);
  for (const std::size_t i : {1U, 9U, 45U, 93U}) {  // all of the second word
    bits[i] ^= 1U;
  }
  EXPECT_FALSE(decode_frame(bits.data(), 2).good);
}

TEST(InertialFrame, AnotherScramblingIsNotTakenForThis) {
  const std::vector<std::uint8_t> bits = zeros(1);
  EXPECT_FALSE(decode_frame(bits.data(), 3).good);
}

TEST(InertialFrame, NumbersAreTwosComplement) {
  std::array<std::uint8_t, 48> payload{};
  payload[6] = 1;  // 100000
  EXPECT_EQ(take_bits(payload, 6, 6), -32);
  payload[11] = 1;  // 100001
  EXPECT_EQ(take_bits(payload, 6, 6), -31);
  EXPECT_EQ(take_bits(payload, 7, 5), 1);
  EXPECT_EQ(take_bits(payload, 36, 12), 0);
}

}  // namespace
}  // namespace limbwave::decode
