#include "acquire/block_sequencer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>

namespace limbwave::acquire {
namespace {

constexpr int kFrames = 10;

// Sample n of wire w is 3 n + w + 1, never zero, so that every shift shows.
BoxBlock block_at(std::int64_t number, std::uint64_t connected = 3) {
  BoxBlock block;
  block.first = number * kFrames;
  block.frames = kFrames;
  block.wires = 2;
  block.connected = connected;
  for (std::int64_t n = block.first; n < block.first + kFrames; ++n) {
    block.samples.push_back(static_cast<std::int16_t>(3 * n + 1));
    block.samples.push_back(static_cast<std::int16_t>(3 * n + 2));
  }
  return block;
}

std::vector<std::int16_t> spelled_out(const std::vector<BoxPiece>& pieces) {
  std::vector<std::int16_t> samples;
  for (const BoxPiece& piece : pieces) {
    samples.insert(samples.end(), static_cast<std::size_t>(2 * piece.lost), 0);
    const std::size_t old = samples.size();
    samples.resize(old + piece.bytes.size() / 2);
    std::memcpy(samples.data() + old, piece.bytes.data(), piece.bytes.size());
  }
  return samples;
}

struct Outcome {
  std::vector<std::int16_t> samples;
  std::vector<BoxEvent> events;
};

Outcome sequence(const std::vector<std::int64_t>& numbers) {
  BlockSequencer sequencer(2);
  for (const std::int64_t number : numbers) {
    sequencer.push(block_at(number));
  }
  sequencer.give_up();
  return {spelled_out(sequencer.take_pieces()), sequencer.take_events()};
}

// Every sample is in its place, or zero within a gap that an event tells exactly.
void check(const Outcome& outcome, std::int64_t blocks) {
  ASSERT_EQ(outcome.samples.size(), static_cast<std::size_t>(2 * kFrames * blocks));
  std::vector<bool> lost(static_cast<std::size_t>(kFrames * blocks));
  for (const BoxEvent& event : outcome.events) {
    for (std::int64_t i = 0; event.kind == "dropped" && i < event.count; ++i) {
      ASSERT_FALSE(lost.at(static_cast<std::size_t>(event.sample.value + i))) << "told twice";
      lost[static_cast<std::size_t>(event.sample.value + i)] = true;
    }
  }
  for (std::size_t n = 0; n < lost.size(); ++n) {
    const auto expected = lost[n] ? 0 : static_cast<std::int16_t>(3 * n + 1);
    ASSERT_EQ(outcome.samples[2 * n], expected) << n;
  }
}

std::size_t count(const Outcome& outcome, const std::string& kind) {
  return static_cast<std::size_t>(std::count_if(outcome.events.begin(), outcome.events.end(),
                                                [&](const BoxEvent& event) { return event.kind == kind; }));
}

TEST(BlockSequencer, InOrderNothingHappens) {
  const Outcome outcome = sequence({0, 1, 2, 3});
  check(outcome, 4);
  EXPECT_TRUE(outcome.events.empty());
}

TEST(BlockSequencer, LostBlocksAreOneGap) {
  const Outcome outcome = sequence({0, 1, 4, 5});
  check(outcome, 6);
  ASSERT_EQ(outcome.events.size(), 1U);
  EXPECT_EQ(outcome.events[0].sample.value, 20);
  EXPECT_EQ(outcome.events[0].count, 20);
}

TEST(BlockSequencer, TheFirstBlocksMayBeLostToo) {
  const Outcome outcome = sequence({2, 3});
  check(outcome, 4);
  EXPECT_EQ(count(outcome, "dropped"), 1U);
}

TEST(BlockSequencer, ReorderedAndDuplicatedBlocksLoseNothing) {
  const Outcome outcome = sequence({0, 2, 1, 3, 3, 1, 5, 4});
  check(outcome, 6);
  EXPECT_EQ(count(outcome, "dropped"), 0U);
  EXPECT_EQ(count(outcome, "duplicated"), 2U);
  EXPECT_EQ(count(outcome, "reordered"), 2U);
}

TEST(BlockSequencer, ALossDoesNotWaitForEver) {
  std::vector<std::int64_t> numbers{0};
  for (std::int64_t n = 2; n < 40; ++n) {
    numbers.push_back(n);
  }
  BlockSequencer sequencer(2);
  for (const std::int64_t number : numbers) {
    sequencer.push(block_at(number));
  }
  EXPECT_FALSE(sequencer.waiting());
  EXPECT_EQ(sequencer.position().value, 40 * kFrames);
}

TEST(BlockSequencer, WiresPulledAndPluggedAreTold) {
  BlockSequencer sequencer(2);
  sequencer.push(block_at(0));
  sequencer.push(block_at(1, 1));
  sequencer.push(block_at(2, 1));
  sequencer.push(block_at(3, 3));
  const std::vector<BoxEvent> events = sequencer.take_events();
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].kind, "wire-pulled");
  EXPECT_EQ(events[0].sample.value, 10);
  EXPECT_EQ(events[0].count, 1);
  EXPECT_EQ(events[1].kind, "wire-back");
  EXPECT_EQ(events[1].sample.value, 30);
}

TEST(BlockSequencer, ABoxThatRestartsGoesOnWhereItIsTold) {
  BlockSequencer sequencer(2);
  sequencer.push(block_at(0));
  sequencer.restart(SampleIndex{35});
  sequencer.push(block_at(0));
  EXPECT_EQ(sequencer.position().value, 45);
  const auto samples = spelled_out(sequencer.take_pieces());
  EXPECT_EQ(samples[2 * 35], 1);
  EXPECT_EQ(samples[2 * 34], 0);
}

TEST(BlockSequencer, AGapOfDaysCostsNoMemory) {
  BlockSequencer sequencer(2);
  sequencer.push(block_at(0));
  sequencer.push(block_at(std::int64_t{1} << 40U));
  sequencer.give_up();
  const auto pieces = sequencer.take_pieces();
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[1].lost, kFrames * ((std::int64_t{1} << 40U) - 1));
  EXPECT_EQ(pieces[1].bytes.size(), 2U * 2U * kFrames);
}

TEST(BlockSequencer, AnyDisorderIsAccountedFor) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<std::int64_t> numbers;
    for (std::int64_t n = 0; n < 60; ++n) {
      if (random() % 6 != 0 || n == 59) {
        numbers.push_back(n);
      }
      if (random() % 8 == 0) {
        numbers.push_back(n);
      }
    }
    for (std::size_t i = 0; i + 2 < numbers.size(); ++i) {
      if (random() % 5 == 0) {
        std::swap(numbers[i], numbers[i + 1]);
      }
    }
    check(sequence(numbers), 60);
  }
}

}  // namespace
}  // namespace limbwave::acquire
