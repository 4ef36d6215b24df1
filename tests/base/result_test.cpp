#include "base/result.h"

#include <gtest/gtest.h>

#include <memory>

namespace limbwave {
namespace {

TEST(Result, HoldsAValueOrAReason) {
  Result<std::unique_ptr<int>> value(std::make_unique<int>(7));
  ASSERT_TRUE(value.ok());
  const std::unique_ptr<int> moved = *std::move(value);
  EXPECT_EQ(*moved, 7);

  const Result<int> none(Error{"is wrong", "FILE", "mend it"});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().text(), "FILE: is wrong; mend it");
  EXPECT_EQ((Error{"is wrong", "", ""}).text(), "is wrong");
}

TEST(Result, StatusIsSuccessUnlessAnErrorIsGiven) {
  EXPECT_TRUE(Status().ok());
  EXPECT_FALSE(Status(Error{"no", "", ""}).ok());
}

TEST(ResultDeathTest, TakingTheValueOfAnErrorStopsTheProgram) {
  const Result<int> none(Error{"is wrong", "", ""});
  EXPECT_DEATH((void)none.value(), "");
}

}  // namespace
}  // namespace limbwave
