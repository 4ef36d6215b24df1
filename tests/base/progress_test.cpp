#include "base/progress.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace limbwave {
namespace {

TEST(Progress, WithoutAnObserverWorkGoesOn) {
  EXPECT_TRUE(Progress().report(0.5));
  EXPECT_TRUE(Progress().part(0.2, 0.4).report(1.0));
}

TEST(Progress, PartsOfPartsLandInTheWhole) {
  std::vector<double> seen;
  std::string step;
  const Progress progress([&](double fraction, std::string_view what) {
    seen.push_back(fraction);
    step = what;
    return true;
  });
  const Progress half = progress.part(0.5, 1.0);
  EXPECT_TRUE(half.report(0.0, "decoding"));
  EXPECT_TRUE(half.part(0.5, 0.75).report(1.0, "solving"));
  EXPECT_EQ(step, "solving");
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_DOUBLE_EQ(seen[0], 0.5);
  EXPECT_DOUBLE_EQ(seen[1], 0.875);
}

TEST(Progress, StopIsPassedOnAndKnownAsSuch) {
  const Progress progress([](double, std::string_view) { return false; });
  EXPECT_FALSE(progress.part(0.1, 0.2).report(0.5));
  EXPECT_TRUE(is_cancelled(cancelled()));
  EXPECT_FALSE(is_cancelled(Error{"cancelled", "FILE", ""}));
  EXPECT_FALSE(is_cancelled(Error{"writing failed", "", ""}));
}

}  // namespace
}  // namespace limbwave
