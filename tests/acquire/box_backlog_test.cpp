#include "acquire/box_backlog.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace limbwave::acquire {
namespace {

constexpr std::size_t kFrame = 4;

BoxPart part(std::int64_t lost, std::int64_t frames, std::byte value = std::byte{1}) {
  return {{{lost, std::vector<std::byte>(static_cast<std::size_t>(frames) * kFrame, value)}}, {}};
}

std::int64_t length(const BoxPart& part) {
  std::int64_t frames = 0;
  for (const BoxPiece& piece : part.pieces) {
    frames += piece.lost + static_cast<std::int64_t>(piece.bytes.size() / kFrame);
  }
  return frames;
}

std::int64_t told(const BoxPart& part) {
  std::int64_t lost = 0;
  for (const BoxEvent& event : part.events) {
    lost += event.kind == "dropped" ? event.count : 0;
  }
  return lost;
}

TEST(BoxBacklog, WhatCameInOnePieceIsPulledInOnePiece) {
  BoxBacklog backlog(100 * kFrame, kFrame);
  backlog.push(part(0, 10, std::byte{1}));
  backlog.push(part(0, 5, std::byte{2}));
  const BoxPart got = backlog.pull(0.0);
  ASSERT_EQ(got.pieces.size(), 1U);
  EXPECT_EQ(got.pieces[0].bytes.size(), 15 * kFrame);
  EXPECT_EQ(got.pieces[0].bytes.front(), std::byte{1});
  EXPECT_EQ(got.pieces[0].bytes.back(), std::byte{2});
  EXPECT_TRUE(backlog.pull(0.0).pieces.empty());
}

TEST(BoxBacklog, AConsumerThatIsTooLateGetsOneGapOfTheRightLength) {
  BoxBacklog backlog(100 * kFrame, kFrame);
  for (int i = 0; i < 30; ++i) {
    backlog.push(part(0, 10));
  }
  BoxPart got = backlog.pull(0.0);
  EXPECT_EQ(length(got), 100);
  EXPECT_EQ(told(got), 0) << "how much it is, is not known yet";
  backlog.push(part(0, 10));
  got = backlog.pull(0.0);
  EXPECT_EQ(length(got), 210);
  EXPECT_EQ(told(got), 200);
  ASSERT_EQ(got.events.size(), 1U);
  EXPECT_EQ(got.events[0].sample.value, 100);
  BoxCounters counters;
  backlog.add_to(counters);
  EXPECT_EQ(counters.lost_frames, 200U);
  EXPECT_EQ(counters.gaps, 1U);
}

// A gap of the line within what is left out stays an own one: together they are as long as the stream.
TEST(BoxBacklog, GapsOfTheLineAndOfTheConsumerAddUp) {
  BoxBacklog backlog(50 * kFrame, kFrame);
  backlog.push(part(0, 50));
  backlog.push(part(0, 20));
  backlog.push(part(7, 20));
  backlog.push(part(0, 20));
  BoxPart got = backlog.pull(0.0);
  backlog.push(part(0, 3), true);
  const BoxPart rest = backlog.pull(0.0);
  EXPECT_EQ(length(got) + length(rest), 50 + 20 + 7 + 20 + 20 + 3);
  EXPECT_EQ(told(got) + told(rest), 60) << "the line's own gap was told by who found it";
}

TEST(BoxBacklog, TheEndTellsWhatWasLeftOut) {
  BoxBacklog backlog(10 * kFrame, kFrame);
  backlog.push(part(0, 10));
  backlog.push(part(0, 10));
  backlog.push({}, true);
  const BoxPart got = backlog.pull(0.0);
  EXPECT_EQ(length(got), 20);
  EXPECT_EQ(told(got), 10);
}

TEST(BoxBacklog, PullWaitsForSomethingAndIsWoken) {
  BoxBacklog backlog(100 * kFrame, kFrame);
  std::thread reader([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    backlog.push({{}, {{SampleIndex{0}, "stall", "", 0}}});
  });
  const BoxPart got = backlog.pull(60.0);
  EXPECT_EQ(got.events.size(), 1U);
  reader.join();
}

}  // namespace
}  // namespace limbwave::acquire
