#include "base/time.h"

#include <gtest/gtest.h>

#include <type_traits>

namespace limbwave {
namespace {

// A position is not a distance: what has no meaning does not compile.
template <typename A, typename B>
concept Addable = requires(A a, B b) {
  a + b;
};
static_assert(Addable<SampleIndex, SampleCount>);
static_assert(!Addable<SampleIndex, SampleIndex>);
static_assert(!Addable<SampleIndex, Seconds>);
static_assert(!std::is_convertible_v<SampleIndex, SampleCount>);
static_assert(std::is_same_v<decltype(SampleIndex{} - SampleIndex{}), SampleCount>);

TEST(Time, PositionsAndDistances) {
  SampleIndex at{100};
  at += SampleCount{20};
  EXPECT_EQ(at, SampleIndex{120});
  EXPECT_EQ((at - SampleIndex{100}).value, 20);
  EXPECT_EQ((at - SampleCount{121}).value, -1);
  EXPECT_LT(SampleIndex{1}, SampleIndex{2});
}

TEST(Time, SecondsOfSamplesAndBack) {
  constexpr SampleRate rate{44100.0};
  EXPECT_DOUBLE_EQ(rate.seconds(SampleIndex{44100}).value, 1.0);
  EXPECT_DOUBLE_EQ(rate.seconds(SampleCount{22050}).value, 0.5);
  EXPECT_EQ(rate.index(Seconds{0.99999 / 44100.0}).value, 0);
}

TEST(Time, TheIndexOfASamplesOwnTimeIsThatSample) {
  for (const double hz : {44100.0, 48000.0, 96000.0, 192000.0, 44100.5}) {
    const SampleRate rate{hz};
    for (std::int64_t i = 0; i < 2'000'000; i = i * 3 / 2 + 1) {
      ASSERT_EQ(rate.index(rate.seconds(SampleIndex{i})).value, i) << hz;
    }
  }
}

}  // namespace
}  // namespace limbwave
