// Playing and capturing at once, with a real JACK server whose outputs are wired to its inputs.
#include "acquire/duplex_stream.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "support/jack_server.h"
#include "support/jack_witness.h"

namespace limbwave::acquire {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using std::chrono::steady_clock;

constexpr int kRate = 48000;
constexpr std::int64_t kRound = 9600;
constexpr auto kPatience = seconds(40);

// Every frame of a round has a value of its own, the same on both channels but for a sign.
float ramp(std::int64_t n) {
  return static_cast<float>(n % kRound + 1) / static_cast<float>(2 * kRound);
}

class DuplexStreamTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string why_not;
    if (!test::JackServer::available(why_not)) {
      GTEST_SKIP() << why_not;
    }
    server_ = std::make_unique<test::JackServer>(kRate, 4, 4, 2048);
    witness_ = std::make_unique<test::JackWitness>(kPatience);
    ASSERT_TRUE(witness_->answers()) << server_->log();
  }
  static DuplexPlan plan() {
    DuplexPlan plan;
    plan.rate_hz = kRate;
    plan.inputs = plan.outputs = 2;
    plan.round = kRound;
    plan.samples.assign(2, std::vector<float>(kRound));
    for (std::int64_t n = 0; n < kRound; ++n) {
      plan.samples[0][static_cast<std::size_t>(n)] = ramp(n);
      plan.samples[1][static_cast<std::size_t>(n)] = -ramp(n);
    }
    return plan;
  }
  // Opened, started, and heard by itself.
  void begin() {
    const auto limit = steady_clock::now() + kPatience;
    Result<std::unique_ptr<DuplexStream>> opened = Error{"not tried yet", "", ""};
    while (!opened && steady_clock::now() < limit) {
      opened = DuplexStream::open("portaudio:JACK:system", plan(), "duplex");
      std::this_thread::sleep_for(milliseconds(50));
    }
    if (!opened && witness_->lost_periods() > 0) {
      GTEST_SKIP() << "the sound server has lost " << witness_->lost_periods() << " periods";
    }
    ASSERT_TRUE(opened.ok()) << opened.error().text() << server_->log();
    stream_ = *std::move(opened);
    ASSERT_TRUE(stream_->start().ok());
    bool wired = false;
    while (!wired && steady_clock::now() < limit) {
      wired = true;
      for (const std::string n : {"0", "1"}) {
        const int done = jack_connect(witness_->client(), ("duplex:out_" + n).c_str(), ("duplex:in_" + n).c_str());
        wired = wired && (done == 0 || done == EEXIST);
      }
      std::this_thread::sleep_for(milliseconds(20));
    }
    ASSERT_TRUE(wired);
  }
  // The next frames that are heard.
  std::vector<float> listen(std::size_t frames) {
    first_ += static_cast<std::int64_t>(length_);
    std::vector<float> all;
    std::vector<float> fresh;
    const auto limit = steady_clock::now() + kPatience;
    while (all.size() < 2 * frames && steady_clock::now() < limit) {
      stream_->wait(0.1);
      stream_->read(fresh);
      all.insert(all.end(), fresh.begin(), fresh.end());
    }
    length_ = all.size() / 2;
    return all;
  }
  // Of every frame that carries the ramp, by how much its place in the round is ahead of its place in all that was
  // heard.
  [[nodiscard]] std::map<std::int64_t, int> shifts(const std::vector<float>& heard) const {
    std::map<std::int64_t, int> found;
    for (std::size_t n = 0; n + 1 < heard.size(); n += 2) {
      if (heard[n] > 0.0F) {
        const auto place = std::llround(static_cast<double>(heard[n]) * 2.0 * kRound) - 1;
        ++found[((place - first_ - static_cast<std::int64_t>(n / 2)) % kRound + kRound) % kRound];
      }
    }
    return found;
  }

  std::unique_ptr<test::JackServer> server_;
  std::unique_ptr<test::JackWitness> witness_;
  std::unique_ptr<DuplexStream> stream_;
  std::int64_t first_ = 0;  // of what was heard last
  std::size_t length_ = 0;
};

TEST_F(DuplexStreamTest, InputsHearTheOutputsFrameByFrame) {
  ASSERT_NO_FATAL_FAILURE(begin());
  if (IsSkipped()) {
    return;
  }
  const std::vector<float> heard = listen(4 * kRound);
  ASSERT_GE(heard.size(), static_cast<std::size_t>(8 * kRound));
  for (std::size_t n = 0; n + 1 < heard.size(); n += 2) {
    ASSERT_EQ(heard[n], -heard[n + 1]) << "channels of one frame belong together, frame " << n / 2;
  }
  const std::map<std::int64_t, int> found = shifts(heard);
  if (witness_->lost_periods() == 0 && stream_->overflows() == 0) {
    EXPECT_EQ(found.size(), 1U) << "the delay is one and the same";
  }
  EXPECT_TRUE(stream_->alive());
  EXPECT_GT(stream_->reported_delay(), 0.0);
}

TEST_F(DuplexStreamTest, OutputsThatSkipAreHeardSoMuchEarlier) {
  ASSERT_NO_FATAL_FAILURE(begin());
  if (IsSkipped()) {
    return;
  }
  const std::map<std::int64_t, int> before = shifts(listen(2 * kRound));
  stream_->skip_output(1000);
  (void)listen(2 * kRound);  // what is on its way is as it was
  const std::map<std::int64_t, int> after = shifts(listen(2 * kRound));
  if (witness_->lost_periods() > 0 || stream_->overflows() > 0) {
    GTEST_SKIP() << "the sound server has lost " << witness_->lost_periods() << " periods";
  }
  ASSERT_EQ(before.size(), 1U);
  ASSERT_EQ(after.size(), 1U);
  EXPECT_EQ((after.begin()->first - before.begin()->first + kRound) % kRound, 1000);
}

TEST_F(DuplexStreamTest, AReaderThatIsTooLateIsToldWhereAndHowMuch) {
  const auto limit = steady_clock::now() + kPatience;
  DuplexPlan small = plan();
  small.backlog_s = 0.2;
  Result<std::unique_ptr<DuplexStream>> opened = Error{"not tried yet", "", ""};
  while (!opened && steady_clock::now() < limit) {
    opened = DuplexStream::open("portaudio:JACK:system", small, "duplex");
    std::this_thread::sleep_for(milliseconds(50));
  }
  if (!opened && witness_->lost_periods() > 0) {
    GTEST_SKIP() << "the sound server has lost " << witness_->lost_periods() << " periods";
  }
  ASSERT_TRUE(opened.ok());
  stream_ = *std::move(opened);
  ASSERT_TRUE(stream_->start().ok());
  while (stream_->overflows() == 0 && steady_clock::now() < limit) {
    std::this_thread::sleep_for(milliseconds(20));
  }
  ASSERT_GT(stream_->overflows(), 0U);
  const std::vector<float> heard = listen(static_cast<std::size_t>(kRate));
  DuplexStream::Loss loss;
  ASSERT_TRUE(stream_->next_loss(loss));
  EXPECT_GT(loss.frames, 0);
  EXPECT_GT(loss.at, 0);
  EXPECT_LE(loss.at, static_cast<std::int64_t>(heard.size() / 2));
}

TEST_F(DuplexStreamTest, AServerThatIsGoneIsSeen) {
  ASSERT_NO_FATAL_FAILURE(begin());
  if (IsSkipped()) {
    return;
  }
  EXPECT_TRUE(stream_->alive());
  witness_.reset();
  server_.reset();
  const auto limit = steady_clock::now() + kPatience;
  while (stream_->alive() && steady_clock::now() < limit) {
    std::this_thread::sleep_for(milliseconds(50));
  }
  EXPECT_FALSE(stream_->alive());
  // And nobody has to wait for the dead.
  DuplexStream::retire(std::move(stream_));
  const std::unique_lock free(portaudio_lock(), std::try_to_lock);
  EXPECT_TRUE(free.owns_lock());
}

TEST(DuplexStream, ADeviceThatIsNotThereIsNamed) {
  const auto opened = DuplexStream::open("portaudio:ALSA:nothing of that name", {}, "");
  ASSERT_FALSE(opened.ok());
  EXPECT_THAT(opened.error().text(), testing::HasSubstr("nothing of that name"));
}

}  // namespace
}  // namespace limbwave::acquire
