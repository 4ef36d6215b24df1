#include "acquire/card_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "acquire/card_sync.h"

namespace limbwave::acquire {
namespace {

bool is_silent(const std::vector<float>& samples, std::int64_t first, std::int64_t last) {
  return std::all_of(samples.begin() + first, samples.begin() + last, [](float s) { return s == 0.0F; });
}

TEST(CardPlan, EverySourcePlaysItsPulseInItsSlotsAlone) {
  const CardBoxSettings settings;
  const std::vector<std::uint8_t> schedule{2, kSilentSlot, 0};
  const DuplexPlan plan = card_plan(settings, schedule, false);
  EXPECT_EQ(plan.inputs, 18);
  EXPECT_EQ(plan.outputs, 8);
  EXPECT_EQ(plan.round, 3 * 1536);
  ASSERT_EQ(plan.samples.size(), 8U);
  EXPECT_FLOAT_EQ(plan.samples[2][0], settings.level);
  EXPECT_TRUE(is_silent(plan.samples[2], 48, plan.round)) << "ten cycles of 40 kHz are 48 samples";
  EXPECT_TRUE(is_silent(plan.samples[0], 0, 2 * 1536));
  EXPECT_FLOAT_EQ(plan.samples[0][2 * 1536], settings.level);
  for (const std::size_t silent : {1U, 3U, 4U, 5U, 6U, 7U}) {
    EXPECT_TRUE(is_silent(plan.samples[silent], 0, plan.round)) << silent;
  }
  // 40 kHz: 4.8 samples a cycle.
  EXPECT_NEAR(plan.samples[2][24], settings.level, 1e-6);
  EXPECT_NEAR(plan.samples[2][12], settings.level * std::cos(5.0 * M_PI), 1e-5);
}

TEST(CardPlan, TheMarkIsOnAnOutputOfItsOwnOnceARound) {
  const CardBoxSettings settings;
  const DuplexPlan plan = card_plan(settings, {0, 1, 2, 3, 4, 5, 6, 7}, true);
  EXPECT_EQ(plan.inputs, 19);
  EXPECT_EQ(plan.outputs, 9);
  const auto at = find_mark(plan.samples.back());
  ASSERT_TRUE(at.has_value());
  EXPECT_EQ(*at, 0);
  EXPECT_TRUE(is_silent(plan.samples.back(), kMarkSamples, plan.round));
}

// A slot that is shorter than a pulse cuts it rather than playing into the next.
TEST(CardPlan, APulseEndsWithItsSlot) {
  CardBoxSettings settings;
  settings.slot_samples = 20;
  const DuplexPlan plan = card_plan(settings, {0, 1}, false);
  EXPECT_TRUE(is_silent(plan.samples[0], 20, 40));
  EXPECT_TRUE(is_silent(plan.samples[1], 0, 20));
}

}  // namespace
}  // namespace limbwave::acquire
