#include "solve/box_wires.h"

#include <gtest/gtest.h>

#include "solve/driver_box.h"
#include "support/simulated_take.h"

namespace limbwave::solve {
namespace {

using testing_support::require;

class BoxWiresTest : public testing::Test {
 protected:
  BoxWiresTest()
      : rig_(require(body::load_rig("driver-box-body"))),
        skeleton_(require(body::load_skeleton(rig_.skeleton))),
        decoder_(driver_box_format(rig_, skeleton_, {})),
        wires_(rig_, SampleRate{rig_.driver_box->rate_hz}) {}
  // So long of silence, with one sample of wire 2.
  void push(double seconds, float sample) {
    std::vector<float> samples(static_cast<std::size_t>(seconds * rig_.driver_box->rate_hz) * 18);
    samples[1] = sample;
    wires_.push(samples);
  }
  [[nodiscard]] BoxWire second() const { return wires_.state(decoder_).at(1); }

  body::Rig rig_;
  body::Skeleton skeleton_;
  decode::DriverBoxDecoder decoder_;
  BoxWires wires_;
};

TEST_F(BoxWiresTest, EveryWireHasTheNameOfItsBoard) {
  const auto state = wires_.state(decoder_);
  ASSERT_EQ(state.size(), rig_.microphones.size());
  for (std::size_t w = 0; w < state.size(); ++w) {
    EXPECT_EQ(state[w].board, rig_.microphones[w].name);
    EXPECT_TRUE(state[w].plugged);
    EXPECT_FALSE(state[w].locked);
    EXPECT_EQ(state[w].level, 0.0);
  }
}

TEST_F(BoxWiresTest, TheLevelIsTheGreatestSampleOfTheLastMoments) {
  push(0.11, -0.25F);
  EXPECT_FLOAT_EQ(static_cast<float>(second().level), 0.25F);
  EXPECT_FALSE(second().clipped);
  push(0.11, 1.0F);
  EXPECT_TRUE(second().clipped);
  push(0.11, 0.0F);
  push(0.11, 0.0F);
  EXPECT_EQ(second().level, 0.0) << "it is forgotten again";
  EXPECT_EQ(wires_.state(decoder_).at(0).level, 0.0);
}

TEST_F(BoxWiresTest, APulledWireIsToldUntilItIsBack) {
  const acquire::BoxEvent pulled{SampleIndex{10}, "wire-pulled", "", 1};
  const acquire::BoxEvent back{SampleIndex{20}, "wire-back", "", 1};
  const acquire::BoxEvent nowhere{SampleIndex{20}, "wire-pulled", "", 99};
  const acquire::BoxEvent other{SampleIndex{20}, "dropped", "", 1};
  wires_.note(std::vector{pulled, nowhere, other});
  EXPECT_FALSE(second().plugged);
  EXPECT_TRUE(wires_.state(decoder_).at(2).plugged);
  wires_.note(std::vector{back});
  EXPECT_TRUE(second().plugged);
}

TEST_F(BoxWiresTest, RatesAreOfTheLastHalfSecondAndOfWhatCounts) {
  std::vector<decode::InertialReading> words(70);
  for (decode::InertialReading& word : words) {
    word.board = 1;
    word.valid = true;
  }
  words[0].valid = false;
  std::vector<decode::RangeReading> ranges(5);
  for (decode::RangeReading& range : ranges) {
    range.receiver = 1;
    range.verdict = decode::RangeVerdict::kAccepted;
  }
  wires_.note(ranges, words);
  push(0.5, 0.0F);
  EXPECT_NEAR(second().words_hz, 138.0, 0.1);
  EXPECT_NEAR(second().ranges_hz, 10.0, 0.1);
  wires_.gap(70000);
  EXPECT_EQ(second().words_hz, 0.0) << "nothing is heard in a gap";
}

}  // namespace
}  // namespace limbwave::solve
