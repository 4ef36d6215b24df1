// Tones for real: heard at the monitor of a PulseAudio server's null sink.
#include "acquire/tone_player.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <fstream>
#include <future>
#include <numbers>

#include "acquire/sound_card.h"
#include "support/pulse_server.h"
#include "support/temporary_folder.h"

namespace limbwave::acquire {
namespace {

// Amplitude of one frequency in the samples.
double amplitude(const std::vector<float>& samples, double hz, double rate_hz) {
  double re = 0.0, im = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double phase = 2.0 * std::numbers::pi * hz * static_cast<double>(i) / rate_hz;
    re += samples[i] * std::cos(phase);
    im += samples[i] * std::sin(phase);
  }
  return 2.0 * std::hypot(re, im) / static_cast<double>(samples.size());
}

TEST(Tones, BeginAndEndInSilence) {
  const std::vector<float> samples = render_tones({{440.0, 0.1, 0.5}, {0.0, 0.05}, {880.0, 0.1, 0.5}}, 48000.0);
  ASSERT_EQ(samples.size(), 12000U);
  EXPECT_NEAR(samples.front(), 0.0F, 1e-3F);
  EXPECT_NEAR(samples[4799], 0.0F, 1e-3F);
  EXPECT_NEAR(samples.back(), 0.0F, 1e-3F);
  for (std::size_t i = 4800; i < 7200; ++i) {
    EXPECT_EQ(samples[i], 0.0F);
  }
  for (std::size_t i = 1; i < samples.size(); ++i) {
    EXPECT_LT(std::abs(samples[i] - samples[i - 1]), 0.1F) << "a click at " << i;
  }
  EXPECT_TRUE(render_tones({{440.0, -1.0}}, 48000.0).empty());
}

TEST(TonePlayer, IsHeardAtTheOutputWhileTheInputIsOpen) {
  std::string why_not;
  if (!test::PulseServer::available(why_not)) {
    GTEST_SKIP() << why_not;
  }
  const test::PulseServer server(48000, "s16le");
  const StreamFormat format{SampleRate{48000.0}, 2, SampleType::kInt16};
  const std::unique_ptr<LiveSource> card = open_sound_card(test::PulseServer::capture_id(), format).value();
  ASSERT_TRUE(card->start().ok());
  TonePlayer player;
  std::promise<Status> played;
  std::future<Status> heard = played.get_future();
  player.play({{1000.0, 1.0, 0.5}}, [&played](const Status& status) { played.set_value(status); });
  std::vector<float> left;
  std::vector<std::byte> block(1 << 16);
  const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  const auto collect = [&] {
    while (const std::size_t got = card->pull(block)) {
      for (std::size_t at = 0; at + 4 <= got; at += 4) {
        std::int16_t sample = 0;
        std::memcpy(&sample, block.data() + at, 2);
        left.push_back(static_cast<float>(sample) / 32768.0F);
      }
    }
  };
  while (heard.wait_for(std::chrono::milliseconds(5)) != std::future_status::ready) {
    collect();
    ASSERT_LT(std::chrono::steady_clock::now(), limit) << "it never ends";
  }
  const Status status = heard.get();
  ASSERT_TRUE(status.ok()) << status.error().text();
  // What is on its way through the server.
  for (int i = 0; i < 100; ++i) {
    collect();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  card->stop();
  // Half a second from the middle of what is not silence.
  const auto first = std::find_if(left.begin(), left.end(), [](float sample) { return std::abs(sample) > 0.1F; });
  ASSERT_GT(left.end() - first, 30000) << "of " << left.size();
  const std::vector<float> middle(first + 6000, first + 30000);
  EXPECT_NEAR(amplitude(middle, 1000.0, 48000.0), 0.4, 0.05);
  EXPECT_NEAR(amplitude(middle, 2000.0, 48000.0), 0.1, 0.03);
  EXPECT_LT(amplitude(middle, 700.0, 48000.0), 0.02);
}

// What a machine is left with when its sound server has died.
struct DeadServer {
  DeadServer() {
    std::ofstream(folder / "asound.conf") << "</usr/share/alsa/alsa.conf>\npcm.!default { type pulse }\n";
  }
  test::TemporaryFolder folder;
  test::ScopedEnvironment environment{{{"ALSA_CONFIG_PATH", folder / "asound.conf"},
                                       {"PULSE_SERVER", "unix:" + (folder / "nothing").string()},
                                       {"JACK_NO_START_SERVER", "1"}}};
};

TEST(TonePlayer, SaysWhenThereIsNoOutput) {
  std::string why_not;
  if (!test::PulseServer::available(why_not)) {
    GTEST_SKIP() << why_not;
  }
  const DeadServer nothing;
  TonePlayer player;
  std::promise<Status> played;
  player.play({{440.0, 0.05}}, [&played](const Status& status) { played.set_value(status); });
  const Status status = played.get_future().get();
  ASSERT_FALSE(status.ok());
  EXPECT_FALSE(status.error().remedy.empty());
}

TEST(TonePlayer, EndsAtOnceWithTonesWaiting) {
  const DeadServer nothing;
  TonePlayer player;
  for (int i = 0; i < 100; ++i) {
    player.play({{440.0, 10.0}});
  }
}

}  // namespace
}  // namespace limbwave::acquire
