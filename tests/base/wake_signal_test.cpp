#include "base/wake_signal.h"

#include <gtest/gtest.h>

#include <thread>

namespace limbwave {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

TEST(WakeSignal, ManyCallsCountAsOne) {
  WakeSignal signal;
  EXPECT_FALSE(signal.wait_for(milliseconds(1)));
  for (int i = 0; i < 10; ++i) {
    signal.notify();
  }
  EXPECT_TRUE(signal.wait_for(seconds(10)));
  EXPECT_FALSE(signal.wait_for(milliseconds(1)));
  signal.notify();
  EXPECT_TRUE(signal.wait_for(seconds(10)));
}

TEST(WakeSignal, NothingWrittenBeforeACallIsMissed) {
  WakeSignal signal;
  constexpr int kLast = 20000;
  std::atomic<int> written{0};
  std::thread writer([&] {
    for (int i = 1; i <= kLast; ++i) {
      written.store(i, std::memory_order_relaxed);
      signal.notify();
    }
  });
  int seen = 0;
  while (seen < kLast) {
    ASSERT_TRUE(signal.wait_for(seconds(30))) << "asleep with " << kLast - seen << " to come";
    seen = written.load(std::memory_order_relaxed);
  }
  writer.join();
}

}  // namespace
}  // namespace limbwave
