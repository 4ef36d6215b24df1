#include "signal/min_max_pyramid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace limbwave::signal {
namespace {

std::vector<float> noise(std::size_t count) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<float> uniform(-1.0F, 1.0F);
  std::vector<float> samples(count);
  std::generate(samples.begin(), samples.end(), [&] { return uniform(generator); });
  return samples;
}

void expect_true_extremes(const std::vector<MinMaxPoint>& points, const std::vector<float>& samples) {
  for (const MinMaxPoint& point : points) {
    const auto begin = samples.begin() + point.first;
    const auto [low, high] = std::minmax_element(begin, begin + point.count);
    ASSERT_EQ(point.minimum, *low) << point.first;
    ASSERT_EQ(point.maximum, *high) << point.first;
  }
}

TEST(MinMaxPyramid, GivesTheTrueExtremesAtEveryZoomAndLength) {
  const std::vector<float> samples = noise(100003);
  for (const std::size_t count : {1UL, 15UL, 16UL, 63UL, 64UL, 65UL, 4096UL, 65537UL, 100003UL}) {
    MinMaxPyramid pyramid(16, 4);
    pyramid.append(std::span(samples).first(count));
    ASSERT_EQ(pyramid.size(), static_cast<std::int64_t>(count));
    const std::vector<float> part(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(count));
    for (const int wanted : {1, 10, 333, 2000}) {
      const auto last = static_cast<std::int64_t>(count);
      const auto points = pyramid.query(last / 3, last, wanted);
      expect_true_extremes(points, part);
      ASSERT_FALSE(points.empty());
      EXPECT_LE(points.front().first, last / 3);
      EXPECT_EQ(points.back().first + points.back().count, last);
      for (std::size_t i = 1; i < points.size(); ++i) {
        ASSERT_EQ(points[i].first, points[i - 1].first + points[i - 1].count);
      }
      EXPECT_LT(points.size(), static_cast<std::size_t>(wanted) * 4 + 2);
    }
  }
}

TEST(MinMaxPyramid, DoesNotDependOnTheBlocks) {
  const std::vector<float> samples = noise(5000);
  MinMaxPyramid whole(16, 4);
  whole.append(samples);
  for (const std::size_t block : {1UL, 17UL, 480UL}) {
    MinMaxPyramid pyramid(16, 4);
    for (std::size_t at = 0; at < samples.size(); at += block) {
      pyramid.append(std::span(samples).subspan(at, std::min(block, samples.size() - at)));
    }
    const auto a = whole.query(0, 5000, 40);
    const auto b = pyramid.query(0, 5000, 40);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].minimum, b[i].minimum);
      EXPECT_EQ(a[i].maximum, b[i].maximum);
    }
  }
}

TEST(MinMaxPyramid, TakesOneChannelOfInterleavedSamples) {
  const std::vector<float> stereo{1, -9, 2, -9, 3, -9};
  MinMaxPyramid pyramid(2, 2);
  pyramid.append(stereo, 2);
  const auto points = pyramid.query(0, 3, 3);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[0].minimum, 1.0F);
  EXPECT_EQ(points[1].maximum, 3.0F);
  EXPECT_EQ(points[1].count, 1);
}

TEST(MinMaxPyramid, LeavesNonFiniteSamplesOut) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  MinMaxPyramid pyramid(2, 2);
  pyramid.append(std::vector<float>{nan, 1.0F, nan, std::numeric_limits<float>::infinity(), 2.0F, 3.0F});
  const auto points = pyramid.query(0, 6, 3);
  ASSERT_EQ(points.size(), 3U);
  EXPECT_EQ(points[0].minimum, 1.0F);
  EXPECT_EQ(points[0].maximum, 1.0F);
  EXPECT_TRUE(std::isnan(points[1].minimum));
  EXPECT_EQ(points[2].maximum, 3.0F);
}

TEST(MinMaxPyramid, ClampsRangesToWhatThereIs) {
  MinMaxPyramid pyramid(4, 2);
  EXPECT_TRUE(pyramid.query(0, 100, 10).empty());
  pyramid.append(noise(10));
  EXPECT_TRUE(pyramid.query(20, 30, 10).empty());
  EXPECT_TRUE(pyramid.query(5, 5, 10).empty());
  EXPECT_TRUE(pyramid.query(0, 10, 0).empty());
  EXPECT_EQ(pyramid.query(-50, 1000, 100).size(), 3U);
}

}  // namespace
}  // namespace limbwave::signal
