#include "acquire/portaudio_session.h"

#include <gtest/gtest.h>
#include <portaudio.h>

#include <thread>
#include <vector>

namespace limbwave::acquire {
namespace {

bool is_up() {
  const std::lock_guard guard(portaudio_lock());
  return Pa_GetDeviceCount() != paNotInitialized;
}

TEST(PortAudioSession, LastsAsLongAsSomebodyUsesIt) {
  ASSERT_FALSE(is_up());
  {
    auto first = PortAudioSession::start();
    ASSERT_TRUE(first.ok()) << first.error().text();
    EXPECT_TRUE(is_up());
    {
      auto second = PortAudioSession::start();
      ASSERT_TRUE(second.ok());
    }
    EXPECT_TRUE(is_up()) << "the first one still needs it";
  }
  EXPECT_FALSE(is_up());
}

TEST(PortAudioSession, ManyThreadsMayBeginAndEndAtOnce) {
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([] {
      for (int n = 0; n < 3; ++n) {
        auto session = PortAudioSession::start();
        EXPECT_TRUE(session.ok());
        EXPECT_TRUE(is_up());
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  EXPECT_FALSE(is_up());
}

// Whoever holds the lock may ask for a session: lists are made so.
TEST(PortAudioSession, TheLockIsOneThatItsHolderMayTakeAgain) {
  const std::lock_guard guard(portaudio_lock());
  EXPECT_TRUE(PortAudioSession::start().ok());
}

}  // namespace
}  // namespace limbwave::acquire
