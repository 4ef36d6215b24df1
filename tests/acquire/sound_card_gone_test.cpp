// A sound server that goes while it is captured from. A program of its own: JACK's library finds the first server
// alone.
#include <gtest/gtest.h>

#include <chrono>
#include <mutex>
#include <thread>

#include "acquire/portaudio_session.h"
#include "acquire/sound_card.h"
#include "support/jack_server.h"

namespace limbwave::acquire {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr auto kPatience = std::chrono::seconds(60);

// JACK makes whoever stops a stream of a server that hangs wait for minutes; nobody else must.
TEST(JackCard, AServerThatHangsIsSeenAndHoldsNobodyUp) {
  std::string why_not;
  if (!test::JackServer::available(why_not)) {
    GTEST_SKIP() << why_not;
  }
  auto server = std::make_unique<test::JackServer>(48000, 2);
  const StreamFormat wanted{SampleRate{48000.0}, 2, SampleType::kFloat32};
  Result<std::unique_ptr<LiveSource>> card = Error{"not tried yet", "", ""};
  const auto limit = steady_clock::now() + kPatience;
  while (!card && server->running() && steady_clock::now() < limit) {
    card = open_sound_card("portaudio:JACK:system", wanted);
    std::this_thread::sleep_for(milliseconds(100));
  }
  ASSERT_TRUE(card.ok()) << card.error().text() << "\n" << server->log();
  ASSERT_TRUE((*card)->start().ok());
  std::vector<std::byte> block(1 << 16);
  while ((*card)->pull(block) == 0 && steady_clock::now() < limit) {
    std::this_thread::sleep_for(milliseconds(5));
  }
  EXPECT_TRUE((*card)->alive());
  server.reset();
  while ((*card)->alive() && steady_clock::now() < limit) {
    std::this_thread::sleep_for(milliseconds(50));
  }
  EXPECT_FALSE((*card)->alive());
  (*card)->stop();
  {
    const std::unique_lock free(portaudio_lock(), std::try_to_lock);
    EXPECT_TRUE(free.owns_lock()) << "others can use sound meanwhile";
  }
  EXPECT_FALSE((*card)->start().ok()) << "it is gone: another has to be opened";
  card->reset();
  const std::unique_lock free(portaudio_lock(), std::try_to_lock);
  EXPECT_TRUE(free.owns_lock());
}

}  // namespace
}  // namespace limbwave::acquire
