// What happens when nobody takes the samples of a sound card: it takes as long as the ring holds.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "acquire/sound_card.h"
#include "support/pulse_server.h"

namespace limbwave::acquire {
namespace {

TEST(NeglectedPulseCard, CountsWhatItsRingCannotHold) {
  std::string why_not;
  if (!test::PulseServer::available(why_not)) {
    GTEST_SKIP() << why_not;
  }
  test::PulseServer server(192000, "s32le");
  const Result<std::unique_ptr<LiveSource>> opened =
      open_sound_card(test::PulseServer::capture_id(), {SampleRate{192000.0}, 2, SampleType::kInt32});
  ASSERT_TRUE(opened.ok()) << opened.error().text();
  LiveSource* const card = opened->get();
  ASSERT_TRUE(card->start().ok());
  const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (card->counters().dropped_frames == 0 && std::chrono::steady_clock::now() < limit) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));  // nobody pulls
  }
  EXPECT_GT(card->counters().dropped_frames, 0U);
  EXPECT_GT(card->counters().overflows, 0U);
  EXPECT_TRUE(card->alive());
}

}  // namespace
}  // namespace limbwave::acquire
