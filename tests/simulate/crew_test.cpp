#include "simulate/crew.h"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

namespace limbwave::simulate {
namespace {

TEST(Crew, DoesEveryPieceOnce) {
  for (const int threads : {1, 2, 5}) {
    Crew crew(threads);
    for (std::size_t count = 0; count < 40; ++count) {
      std::vector<std::atomic<int>> done(count);
      crew.each(count, [&](std::size_t i) { ++done[i]; });
      for (const auto& times : done) {
        EXPECT_EQ(times, 1);
      }
    }
  }
}

}  // namespace
}  // namespace limbwave::simulate
