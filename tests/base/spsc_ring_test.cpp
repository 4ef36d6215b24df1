#include "base/spsc_ring.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <thread>
#include <vector>

namespace limbwave {
namespace {

TEST(SpscRing, TakesAllOrNothing) {
  SpscRing<int> ring(5);
  EXPECT_EQ(ring.capacity(), 8U);
  const std::vector<int> six{1, 2, 3, 4, 5, 6};
  EXPECT_TRUE(ring.write(six));
  EXPECT_FALSE(ring.write(std::vector<int>{7, 8, 9}));
  EXPECT_EQ(ring.available(), 6U);
  EXPECT_TRUE(ring.write(std::vector<int>{7, 8}));
  EXPECT_FALSE(ring.write(std::vector<int>{9}));
  std::vector<int> out(10);
  EXPECT_EQ(ring.read(out), 8U);
  out.resize(8);
  EXPECT_EQ(out, (std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(ring.available(), 0U);
  EXPECT_EQ(ring.read(out), 0U);
}

TEST(SpscRing, WrapsAroundAtEveryOffset) {
  SpscRing<int> ring(8);
  int written = 0;
  int read = 0;
  for (int round = 0; round < 100; ++round) {
    std::vector<int> in(static_cast<std::size_t>(1 + round % 8));
    std::iota(in.begin(), in.end(), written);
    ASSERT_TRUE(ring.write(in));
    written += static_cast<int>(in.size());
    std::vector<int> out(in.size());
    ASSERT_EQ(ring.read(out), in.size());
    for (const int value : out) {
      ASSERT_EQ(value, read++);
    }
  }
}

TEST(SpscRing, RefusesMoreThanItCouldEverHold) {
  SpscRing<char> ring(4);
  EXPECT_FALSE(ring.write(std::vector<char>(5)));
  EXPECT_TRUE(ring.write(std::vector<char>{}));
  EXPECT_EQ(ring.available(), 0U);
}

// Every element arrives once and in order; under ThreadSanitizer this also shows that the two sides do not race.
TEST(SpscRing, TwoThreadsPassMillionsOfElements) {
  constexpr std::uint64_t kCount = 3'000'000;
  SpscRing<std::uint64_t> ring(1000);
  std::thread producer([&] {
    std::vector<std::uint64_t> block;
    std::uint64_t next = 0;
    while (next < kCount) {
      block.resize(std::min<std::uint64_t>(1 + next % 333, kCount - next));
      std::iota(block.begin(), block.end(), next);
      if (ring.write(block)) {
        next += block.size();
      } else {
        std::this_thread::yield();
      }
    }
  });
  std::vector<std::uint64_t> block(257);
  std::uint64_t expected = 0;
  std::uint64_t wrong = 0;
  while (expected < kCount) {
    const std::size_t got = ring.read(std::span(block).first(1 + expected % block.size()));
    for (std::size_t i = 0; i < got; ++i) {
      wrong += block[i] == expected++ ? 0 : 1;
    }
    if (got == 0) {
      std::this_thread::yield();
    }
  }
  producer.join();
  EXPECT_EQ(wrong, 0U);
  EXPECT_EQ(ring.available(), 0U);
}

}  // namespace
}  // namespace limbwave
