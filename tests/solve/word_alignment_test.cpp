#include "solve/word_alignment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace limbwave::solve {
namespace {

using estimate::InertialReading;

constexpr double kRate = 140.0;

estimate::BodyModel two_boards() {
  estimate::BodyModel model;
  model.boards.resize(2);
  model.gyroscope_range = 5.0;
  model.accelerometer_range = 30.0;
  return model;
}

// A board whose clock is off, that turns and shakes smoothly.
std::vector<InertialReading> speak(int board, double start_s, double ppm, double seconds) {
  std::vector<InertialReading> words;
  for (double t = start_s; t < seconds; t += (1.0 + 1e-6 * ppm) / kRate) {
    words.push_back({t, board, Eigen::Vector3d(std::sin(6.0 * t), std::cos(6.0 * t), 0.1 * t),
                     Eigen::Vector3d(9.8, 3.0 * std::sin(4.0 * t), board)});
  }
  return words;
}

TEST(WordAligner, AllBoardsAreReadAtTheSameInstants) {
  WordAligner aligner(two_boards(), kRate);
  std::vector<InertialReading> words = speak(0, 0.0011, 150.0, 20.0);
  const std::vector<InertialReading> others = speak(1, 0.0047, -150.0, 20.0);
  words.insert(words.end(), others.begin(), others.end());
  const auto aligned = aligner.push(words);
  std::vector<int> times[2];
  for (const InertialReading& reading : aligned) {
    const double k = reading.time_s * kRate;
    ASSERT_NEAR(k, std::round(k), 1e-9);
    times[reading.board].push_back(static_cast<int>(std::lround(k)));
    // A linear piece is off by h²/8 · f'' at most, f'' = 36 and 48 here.
    const double bound = 1.2 / (8.0 * kRate * kRate);
    const double t = reading.time_s;
    EXPECT_NEAR(reading.w_S.x(), std::sin(6.0 * t), 36.0 * bound);
    EXPECT_NEAR(reading.f_S.y(), 3.0 * std::sin(4.0 * t), 48.0 * bound);
    EXPECT_NEAR(reading.w_S.z(), 0.1 * t, 1e-12);
    EXPECT_EQ(reading.f_S.z(), reading.board);
  }
  for (const auto& of : times) {
    ASSERT_GT(of.size(), 2700U);
    for (std::size_t i = 1; i < of.size(); ++i) {
      ASSERT_EQ(of[i], of[i - 1] + 1) << "every instant once";
    }
  }
}

TEST(WordAligner, HowWordsArriveChangesNothing) {
  const std::vector<InertialReading> words = speak(1, 0.002, 90.0, 3.0);
  WordAligner at_once(two_boards(), kRate);
  WordAligner one_by_one(two_boards(), kRate);
  const auto all = at_once.push(words);
  std::vector<InertialReading> pieces;
  for (std::size_t i = 0; i < words.size(); i += 1 + i % 3) {
    const auto part = one_by_one.push(std::span(words).subspan(i, std::min(words.size() - i, 1 + i % 3)));
    pieces.insert(pieces.end(), part.begin(), part.end());
  }
  ASSERT_EQ(pieces.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(pieces[i].time_s, all[i].time_s);
    EXPECT_EQ(pieces[i].w_S, all[i].w_S);
    EXPECT_EQ(pieces[i].f_S, all[i].f_S);
  }
}

// Nothing is made up where a word was lost.
TEST(WordAligner, AcrossALostWordThereIsNone) {
  std::vector<InertialReading> words = speak(0, 0.0011, 0.0, 1.0);
  const double before = words[49].time_s, after = words[51].time_s;
  words.erase(words.begin() + 50);
  WordAligner aligner(two_boards(), kRate);
  int count = 0;
  for (const InertialReading& reading : aligner.push(words)) {
    EXPECT_FALSE(reading.time_s > before && reading.time_s <= after);
    ++count;
  }
  EXPECT_EQ(count, static_cast<int>(words.size()) - 1 - 1);
}

TEST(WordAligner, WhatIsAtTheEndOfItsRangeStaysThere) {
  std::vector<InertialReading> words = speak(0, 0.001, 0.0, 0.1);
  for (InertialReading& word : words) {
    word.w_S = Eigen::Vector3d(1.0, -1.0, 0.5);
  }
  words[5].w_S = Eigen::Vector3d(5.0, -1.0, 0.5);
  WordAligner aligner(two_boards(), kRate);
  int clipped = 0;
  for (const InertialReading& reading : aligner.push(words)) {
    clipped += reading.w_S.x() == 5.0 ? 1 : 0;
    EXPECT_TRUE(reading.w_S.x() == 5.0 || reading.w_S.x() == 1.0) << "no value between";
    EXPECT_EQ(reading.w_S.y(), -1.0);
  }
  EXPECT_EQ(clipped, 2) << "before and behind it";
}

}  // namespace
}  // namespace limbwave::solve
