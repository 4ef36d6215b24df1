// How late readings come out of the decoder of a live picture, and that this does not depend on blocks.
#include <gtest/gtest.h>

#include <random>

#include "solve/driver_box.h"
#include "solve/word_alignment.h"
#include "support/simulated_take.h"
#include "take/take_reader.h"

namespace limbwave {
namespace {

using testing_support::require;

struct Decoded {
  std::vector<decode::RangeReading> ranges;
  std::vector<decode::InertialReading> words;
  double range_age_s = 0.0, word_age_s = 0.0;  // greatest, behind the newest sample before the block they came with
};

class LiveDecoding : public testing::Test {
 protected:
  static constexpr double kSeconds = 5.0;
  static void SetUpTestSuite() {
    const test::TemporaryFolder folder;
    simulate::SimulateSettings settings;
    settings.rig = "driver-box-body";
    settings.motion = "walk";
    settings.errors_name = "calibrated";
    settings.seed = 21;
    settings.seconds = kSeconds;
    require(simulate::simulate_take(folder.path() / "walk.take", settings, {}));
    take_ = new take::Take(require(take::open_take(folder.path() / "walk.take")));
    auto reader = require(take::TakeReader::open(*take_));
    samples_ = new std::vector<float>(static_cast<std::size_t>(reader.frames()) * 18U);
    require(reader.read(SampleIndex{0}, *samples_));
  }
  static void TearDownTestSuite() {
    delete take_;
    delete samples_;
  }
  // Wires that are pulled, that only rustle, whose bits are wrong, and stretches that are missing on all.
  static std::vector<float> spoilt() {
    std::vector<float> samples = *samples_;
    std::mt19937 random(5);
    std::normal_distribution<float> noise(0.0F, 0.05F);
    const auto rate = static_cast<std::size_t>(take_->info.format.rate.hz);
    for (std::size_t frame = 0; frame < samples.size() / 18; ++frame) {
      float* wires = samples.data() + 18 * frame;
      if (frame > rate && frame < 2 * rate) {
        wires[3] = 0.0F;
      }
      if (frame > rate / 2) {
        wires[7] = noise(random);
      }
      // Every tenth of a second one word and a half of wire 11 are drowned; on wire 12 three and a half.
      wires[11] += frame % (rate / 10) < rate / 93 ? 20.0F * noise(random) : 0.0F;
      wires[12] += frame % (rate / 10) < rate / 40 ? 20.0F * noise(random) : 0.0F;
    }
    return samples;
  }
  static Decoded decoded(const std::vector<float>& samples, std::size_t block, bool gaps) {
    decode::DriverBoxFormat format =
        solve::driver_box_format(take_->info.rig, take_->info.skeleton, *take_->info.ranging);
    format.rate = take_->info.format.rate;
    decode::DriverBoxDecoder decoder(format, solve::live_decoding());
    Decoded result;
    const std::size_t frames = samples.size() / 18;
    const std::size_t gap_at = frames / 2, gap = 31 * 140;
    for (std::size_t at = 0; at < frames;) {
      const double before_s = static_cast<double>(at) / format.rate.hz;
      if (gaps && at == gap_at) {
        decoder.gap(SampleCount{static_cast<std::int64_t>(gap)});
        at += gap;
      } else {
        const std::size_t end = std::min(frames, gaps && at < gap_at ? std::min(gap_at, at + block) : at + block);
        decoder.push(std::span(samples).subspan(18 * at, 18 * (end - at)));
        at = end;
      }
      for (const decode::RangeReading& range : decoder.take_ranges()) {
        result.range_age_s = std::max(result.range_age_s, before_s - range.emission_time.value);
        result.ranges.push_back(range);
      }
      for (const decode::InertialReading& word : decoder.take_inertial()) {
        result.word_age_s = std::max(result.word_age_s, word.valid ? before_s - word.time.value : 0.0);
        result.words.push_back(word);
      }
    }
    return result;
  }
  static take::Take* take_;
  static std::vector<float>* samples_;
};
take::Take* LiveDecoding::take_ = nullptr;
std::vector<float>* LiveDecoding::samples_ = nullptr;

TEST_F(LiveDecoding, EveryReadingIsThereInTimeForItsPose) {
  const double word_s = 1.0 / take_->info.rig.driver_box->word_rate_hz;
  const double settled = solve::live_settled_s(solve::live_decoding(), 1.0 / word_s, word_s);
  for (const bool spoil : {false, true}) {
    const Decoded result = decoded(spoil ? spoilt() : *samples_, 70, spoil);
    std::printf("%s: ranges %.1f ms late at most, words %.1f ms, allowed %.1f ms\n", spoil ? "spoilt" : "whole",
                1e3 * result.range_age_s, 1e3 * result.word_age_s, 1e3 * settled);
    ASSERT_GT(result.ranges.size(), 1000U);
    EXPECT_LT(result.range_age_s, settled);
    EXPECT_LT(result.word_age_s + word_s, settled);
    EXPECT_GT(result.range_age_s, settled - 0.010 - (spoil ? 0.0 : word_s)) << "nobody waits for nothing";
  }
  EXPECT_LT(settled, 0.026);
}

TEST_F(LiveDecoding, DoesNotDependOnBlocks) {
  const std::vector<float> samples = spoilt();
  const Decoded fine = decoded(samples, 37, true), coarse = decoded(samples, 14000, true);
  std::size_t accepted = 0;
  const std::size_t ranges = std::min(fine.ranges.size(), coarse.ranges.size());
  ASSERT_GT(ranges, 1000U);
  for (std::size_t i = 0; i < ranges; ++i) {
    ASSERT_EQ(fine.ranges[i].verdict, coarse.ranges[i].verdict) << i;
    if (fine.ranges[i].verdict == decode::RangeVerdict::kAccepted) {
      ASSERT_EQ(fine.ranges[i].range, coarse.ranges[i].range) << i;
      ASSERT_EQ(fine.ranges[i].variance, coarse.ranges[i].variance) << i;
      ++accepted;
    }
  }
  EXPECT_GT(accepted, 200U);
}

}  // namespace
}  // namespace limbwave
