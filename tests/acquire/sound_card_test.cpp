// Sound cards for real: a PulseAudio server with a null sink, and a JACK server with its dummy driver.
#include "acquire/sound_card.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sndfile.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <optional>
#include <thread>

#include "support/audio_files.h"
#include "support/jack_server.h"
#include "support/pulse_server.h"

namespace limbwave::acquire {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;
using test::PulseServer;
using testing::Contains;
using testing::HasSubstr;

// Everything that fails to come within this is missing; nothing is asserted about being faster.
constexpr auto kPatience = std::chrono::seconds(60);

class PulseCard : public testing::Test {
 protected:
  void SetUp() override {
    std::string why_not;
    if (!PulseServer::available(why_not)) {
      GTEST_SKIP() << why_not;
    }
  }

  // Pulls until `done` says so, returning all that came.
  template <typename Done>
  static std::vector<std::byte> pull_until(LiveSource& card, Done done) {
    std::vector<std::byte> all;
    std::vector<std::byte> block(1 << 16);
    const auto limit = steady_clock::now() + kPatience;
    for (bool last = false;; last = done(all)) {
      while (const std::size_t got = card.pull(block)) {
        all.insert(all.end(), block.begin(), block.begin() + static_cast<std::ptrdiff_t>(got));
      }
      if (last) {
        return all;
      }
      if (steady_clock::now() > limit) {
        ADD_FAILURE() << "nothing more comes";
        return all;
      }
      std::this_thread::sleep_for(milliseconds(5));
    }
  }

  static std::unique_ptr<LiveSource> open(const StreamFormat& format) {
    Result<std::unique_ptr<LiveSource>> card = open_sound_card(PulseServer::capture_id(), format);
    if (!card) {
      throw std::runtime_error(card.error().text());
    }
    return *std::move(card);
  }

  // Plays random samples, captures them, and demands every single one.
  void expect_exact(const StreamFormat& format, const std::string& pulse_format, double seconds) {
    PulseServer server(static_cast<int>(format.rate.hz), pulse_format);
    const test::TemporaryFolder folder;
    const std::vector<std::byte> raw = test::random_samples(format, static_cast<std::size_t>(seconds * format.rate.hz));
    test::write_audio(folder / "x.wav", SF_FORMAT_WAV, format, raw);
    const std::unique_ptr<LiveSource> card = open(format);
    EXPECT_EQ(card->newest_frame_time_s(), 0.0);
    ASSERT_TRUE(card->start().ok());
    (void)pull_until(*card, [](const auto& all) { return !all.empty(); });
    const std::unique_ptr<test::ChildProcess> player = server.play(folder / "x.wav");
    const std::vector<std::byte> captured = pull_until(*card, [&](const auto&) { return !player->running(); });
    card->stop();
    ASSERT_EQ(player->wait(), 0);
    const auto found = std::search(captured.begin(), captured.end(), raw.begin(), raw.begin() + 64);
    ASSERT_NE(found, captured.end()) << "the first samples have not come";
    const auto offset = static_cast<std::size_t>(found - captured.begin());
    EXPECT_EQ(offset % format.bytes_per_frame(), 0U);
    ASSERT_GE(captured.size() - offset, raw.size()) << "the last samples have not come";
    const auto wrong = std::mismatch(raw.begin(), raw.end(), found);
    EXPECT_TRUE(wrong.first == raw.end()) << "differs from byte " << wrong.first - raw.begin() << " on";
    EXPECT_EQ(card->counters().overflows, 0U);
    EXPECT_EQ(card->counters().dropped_frames, 0U);
    EXPECT_TRUE(card->alive());
    EXPECT_GT(card->device_latency_s(), 0.0);
    const double now = std::chrono::duration<double>(steady_clock::now().time_since_epoch()).count();
    EXPECT_GT(card->newest_frame_time_s(), 0.0);
    EXPECT_LE(card->newest_frame_time_s(), now);
  }
};

TEST_F(PulseCard, IsListedWithoutChatter) {
  PulseServer server;
  testing::internal::CaptureStderr();
  const Result<std::vector<DeviceInfo>> devices = list_devices();
  const std::string chatter = testing::internal::GetCapturedStderr();
  EXPECT_EQ(chatter, "");
  ASSERT_TRUE(devices.ok()) << devices.error().text();
  const auto pulse = std::find_if(devices->begin(), devices->end(),
                                  [](const DeviceInfo& device) { return device.id == PulseServer::capture_id(); });
  ASSERT_NE(pulse, devices->end());
  EXPECT_GE(pulse->channels, 2);
  EXPECT_THAT(pulse->rates_hz, Contains(44100.0));
  EXPECT_THAT(pulse->rates_hz, Contains(192000.0));
  EXPECT_THAT(pulse->types, Contains(SampleType::kInt16));
  EXPECT_THAT(pulse->types, Contains(SampleType::kFloat32));
  EXPECT_TRUE(devices->front().is_default);
}

TEST_F(PulseCard, GivesEverySampleExactlyInInt16) {
  expect_exact({SampleRate{48000.0}, 2, SampleType::kInt16}, "s16le", 4.0);
}

TEST_F(PulseCard, GivesEverySampleExactlyInInt24) {
  expect_exact({SampleRate{96000.0}, 2, SampleType::kInt24}, "s24le", 1.0);
}

TEST_F(PulseCard, GivesEverySampleExactlyInInt32) {
  expect_exact({SampleRate{192000.0}, 2, SampleType::kInt32}, "s32le", 1.0);
}

TEST_F(PulseCard, GivesEverySampleExactlyInFloat32) {
  expect_exact({SampleRate{44100.0}, 2, SampleType::kFloat32}, "float32le", 1.0);
}

TEST_F(PulseCard, StopsAndStartsAgain) {
  PulseServer server;
  const std::unique_ptr<LiveSource> card = open({SampleRate{48000.0}, 2, SampleType::kInt16});
  for (int round = 0; round < 3; ++round) {
    ASSERT_TRUE(card->start().ok());
    EXPECT_TRUE(card->start().ok()) << "twice is as good as once";
    EXPECT_GE(pull_until(*card, [](const auto& all) { return all.size() > 10000; }).size(), 10000U);
    card->stop();
    EXPECT_TRUE(card->alive()) << "stopping is not dying";
  }
}

TEST_F(PulseCard, DiesWithItsServerAndStillGivesWhatHasCome) {
  PulseServer server;
  const std::unique_ptr<LiveSource> card = open({SampleRate{48000.0}, 2, SampleType::kInt16});
  ASSERT_TRUE(card->start().ok());
  const auto limit = steady_clock::now() + kPatience;
  while (card->newest_frame_time_s() == 0.0 && steady_clock::now() < limit) {
    std::this_thread::sleep_for(milliseconds(5));
  }
  server.stop();
  while (card->alive() && steady_clock::now() < limit) {
    std::this_thread::sleep_for(milliseconds(20));
  }
  EXPECT_FALSE(card->alive());
  std::vector<std::byte> block(1 << 16);
  EXPECT_GT(card->pull(block), 0U);
  card->stop();
}

TEST_F(PulseCard, RefusesInOneLine) {
  PulseServer server;
  const StreamFormat good{SampleRate{48000.0}, 2, SampleType::kInt16};
  EXPECT_EQ(open_sound_card("portaudio:ALSA:none", good).error().text(),
            "portaudio:ALSA:none: there is no such device; connect it, or choose one that `limbwave devices` lists");
  EXPECT_THAT(open_sound_card(PulseServer::capture_id(), {SampleRate{48000.0}, 100, SampleType::kInt16}).error().text(),
              HasSubstr("channels, not 100"));
  EXPECT_TRUE(open_sound_card("default", good).ok());
}

TEST_F(PulseCard, WithoutAServerSaysSo) {
  PulseServer server;
  server.stop();
  testing::internal::CaptureStderr();
  const Result<std::unique_ptr<LiveSource>> card =
      open_sound_card(PulseServer::capture_id(), {SampleRate{48000.0}, 2, SampleType::kInt16});
  const std::string chatter = testing::internal::GetCapturedStderr();
  ASSERT_FALSE(card.ok());
  EXPECT_THAT(card.error().text(), HasSubstr("portaudio:ALSA:pulse: "));
  EXPECT_EQ(chatter, "");
}

TEST(JackCard, GivesTwentyChannelsAt192kHz) {
  std::string why_not;
  if (!test::JackServer::available(why_not)) {
    GTEST_SKIP() << why_not;
  }
  test::JackServer server(192000, 20);
  const StreamFormat wanted{SampleRate{192000.0}, 20, SampleType::kFloat32};
  Result<std::unique_ptr<LiveSource>> card = Error{"not tried yet", "", ""};
  const auto limit = steady_clock::now() + kPatience;
  while (!card && server.running() && steady_clock::now() < limit) {
    card = open_sound_card("portaudio:JACK:system", wanted);
    std::this_thread::sleep_for(milliseconds(100));
  }
  ASSERT_TRUE(card.ok()) << card.error().text() << "\n" << server.log();
  EXPECT_THAT(open_sound_card("portaudio:JACK:system", {SampleRate{192000.0}, 2, SampleType::kInt16}).error().text(),
              HasSubstr("does not give int16 samples; it offers float32"));
  EXPECT_THAT(open_sound_card("portaudio:JACK:system", {SampleRate{44100.0}, 2, SampleType::kFloat32}).error().text(),
              HasSubstr("does not run at 44100 Hz; it offers 192000"));
  ASSERT_TRUE((*card)->start().ok());
  std::vector<std::byte> block(1 << 20);
  std::size_t frames = 0;
  while (frames < 96000 && steady_clock::now() < limit) {
    const std::size_t got = (*card)->pull(block);
    EXPECT_EQ(got % wanted.bytes_per_frame(), 0U);
    frames += got / wanted.bytes_per_frame();
    std::this_thread::sleep_for(milliseconds(5));
  }
  EXPECT_GE(frames, 96000U);
  EXPECT_TRUE((*card)->alive());
  (*card)->stop();
}

}  // namespace
}  // namespace limbwave::acquire
