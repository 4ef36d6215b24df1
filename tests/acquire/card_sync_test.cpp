#include "acquire/card_sync.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace limbwave::acquire {
namespace {

std::vector<float> line(std::size_t size, double noise, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<float> normal(0.0F, 1.0F);
  std::vector<float> samples(size);
  for (float& sample : samples) {
    sample = static_cast<float>(noise) * normal(random);
  }
  return samples;
}

void add_mark(std::vector<float>& samples, std::size_t at, float level) {
  for (int n = 0; n < kMarkSamples; ++n) {
    samples[at + static_cast<std::size_t>(n)] += level * mark_sample(n);
  }
}

TEST(CardSync, FindsAMarkToTheSampleWhateverItsSizeAndSign) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const float level = (seed % 2 == 0 ? 1.0F : -1.0F) * (seed % 3 == 0 ? 0.002F : 0.5F);
    auto samples = line(5000, 0.1 * std::abs(level), seed);
    const std::size_t at = 100 + 67 * seed;
    add_mark(samples, at, level);
    EXPECT_EQ(find_mark(samples), static_cast<std::int64_t>(at)) << seed;
  }
}

TEST(CardSync, OfSeveralTheFirst) {
  auto samples = line(40000, 0.01, 1);
  for (const std::size_t at : {777U, 777U + 12288U, 777U + 2U * 12288U}) {
    add_mark(samples, at, 0.4F);
  }
  EXPECT_EQ(find_mark(samples), 777);
}

TEST(CardSync, NoiseSilenceAndTonesAreNoMarks) {
  EXPECT_FALSE(find_mark(std::vector<float>(4000)));
  EXPECT_FALSE(find_mark({}));
  for (unsigned seed = 0; seed < 50; ++seed) {
    EXPECT_FALSE(find_mark(line(4000, 0.3, seed))) << seed;
  }
  std::vector<float> hum(4000);
  for (std::size_t n = 0; n < hum.size(); ++n) {
    hum[n] = std::sin(0.002F * static_cast<float>(n));
  }
  EXPECT_FALSE(find_mark(hum));
}

}  // namespace
}  // namespace limbwave::acquire
