// Two inputs out of many: bit by bit, whatever the block sizes.
#include "acquire/channel_pair.h"

#include <gtest/gtest.h>

#include <cstring>

namespace limbwave::acquire {
namespace {

/// Sample c of frame n is 100 n + c; gives at most `most` frames at a time.
class CountingSource : public LiveSource {
 public:
  CountingSource(StreamFormat format, std::int32_t frames, std::size_t most)
      : format_(format), frames_(frames), most_(most) {}
  [[nodiscard]] StreamFormat format() const override { return format_; }
  [[nodiscard]] std::string title() const override { return "counting"; }
  Status start() override { return {}; }
  void stop() override {}
  std::size_t pull(std::span<std::byte> out) override {
    const std::size_t sample = bytes_per_sample(format_.type);
    std::size_t done = 0;
    for (std::size_t n = 0; n < most_ && next_ < frames_ && done + format_.bytes_per_frame() <= out.size(); ++n) {
      for (int c = 0; c < format_.channels; ++c) {
        const std::int32_t value = 100 * next_ + c;
        std::memcpy(out.data() + done, &value, sample);
        done += sample;
      }
      ++next_;
    }
    return done;
  }
  [[nodiscard]] SourceCounters counters() const override { return {3, 7, 5}; }
  [[nodiscard]] bool alive() const override { return next_ < frames_; }
  [[nodiscard]] double device_latency_s() const override { return 0.02; }
  [[nodiscard]] double newest_frame_time_s() const override { return 5.0; }

 private:
  StreamFormat format_;
  std::int32_t frames_, next_ = 0;
  std::size_t most_;
};

std::vector<std::int32_t> drain(LiveSource& source, std::size_t bytes_at_a_time) {
  const std::size_t sample = bytes_per_sample(source.format().type);
  std::vector<std::int32_t> values;
  std::vector<std::byte> block(bytes_at_a_time);
  while (const std::size_t got = source.pull(block)) {
    EXPECT_EQ(got % (2 * sample), 0U) << "whole frames only";
    for (std::size_t i = 0; i < got; i += sample) {
      std::int32_t value = 0;
      std::memcpy(&value, block.data() + i, sample);
      values.push_back(value);
    }
  }
  return values;
}

TEST(ChannelPair, GivesTheChosenInputsInOrder) {
  for (const SampleType type : {SampleType::kInt16, SampleType::kInt24, SampleType::kInt32}) {
    for (const std::size_t bytes : {std::size_t{13}, std::size_t{64}, std::size_t{100000}}) {
      auto source = std::make_unique<CountingSource>(StreamFormat{SampleRate{96000.0}, 8, type}, 300, 29);
      const auto pair = pick_channels(std::move(source), 5, 2);
      ASSERT_TRUE(pair.ok());
      EXPECT_EQ((*pair)->format().channels, 2);
      EXPECT_EQ((*pair)->format().type, type);
      EXPECT_EQ((*pair)->format().rate.hz, 96000.0);
      EXPECT_EQ((*pair)->counters().dropped_frames, 7U);
      const std::vector<std::int32_t> values = drain(**pair, bytes);
      ASSERT_EQ(values.size(), 600U);
      for (std::int32_t n = 0; n < 300; ++n) {
        ASSERT_EQ(values[2 * static_cast<std::size_t>(n)], 100 * n + 5);
        ASSERT_EQ(values[2 * static_cast<std::size_t>(n) + 1], 100 * n + 2);
      }
      EXPECT_FALSE((*pair)->alive());
    }
  }
}

TEST(ChannelPair, StereoAsItIsStaysTheSameSource) {
  auto source = std::make_unique<CountingSource>(StreamFormat{SampleRate{48000.0}, 2, SampleType::kInt16}, 3, 9);
  const LiveSource* const before = source.get();
  const auto pair = pick_channels(std::move(source), 0, 1);
  ASSERT_TRUE(pair.ok());
  EXPECT_EQ(pair->get(), before);
}

TEST(ChannelPair, InputsThatAreNotThereAreRefused) {
  for (const auto& [left, right] : {std::pair{0, 4}, std::pair{-1, 0}, std::pair{9, 1}}) {
    auto source = std::make_unique<CountingSource>(StreamFormat{SampleRate{48000.0}, 4, SampleType::kInt16}, 3, 9);
    const auto pair = pick_channels(std::move(source), left, right);
    ASSERT_FALSE(pair.ok());
    EXPECT_NE(pair.error().text().find("only 4"), std::string::npos);
  }
}

}  // namespace
}  // namespace limbwave::acquire
