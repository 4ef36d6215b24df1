#include "plots/box_history.h"

#include <gtest/gtest.h>

#include <fstream>

#include "support/simulated_take.h"
#include "take/recorder.h"

namespace limbwave::ui {
namespace {

solve::BoxWire wire(const std::string& board) {
  solve::BoxWire wire;
  wire.board = board;
  wire.level = 0.25;
  wire.locked = true;
  wire.frames = 140;
  wire.words_hz = 140.0;
  wire.ranges_hz = 20.0;
  return wire;
}

TEST(BoxHistory, RemembersTheWorstOfEveryStretch) {
  BoxHistory history;
  std::vector<solve::BoxWire> wires{wire("head"), wire("hand"), wire("foot")};
  EXPECT_TRUE(history.empty());
  history.add(0.0, wires, 0.0);
  wires[1].lost_frames = 2;
  history.add(0.1, wires, 0.0);
  history.add(0.2, wires, 0.0);  // well again, but not forgotten
  wires[2].plugged = false;
  wires[2].lost_frames = 50;  // a wire that is out says nothing; that is no loss on the way
  history.add(0.6, wires, 0.0);
  ASSERT_EQ(history.columns(), 2U);
  EXPECT_EQ(history.cell(0, 0).condition, WireCondition::kWell);
  EXPECT_EQ(history.cell(1, 0).condition, WireCondition::kLost);
  EXPECT_EQ(history.cell(1, 0).lost_words, 2);
  EXPECT_EQ(history.cell(1, 1).condition, WireCondition::kWell);
  EXPECT_EQ(history.cell(2, 1).condition, WireCondition::kPulled);
  EXPECT_EQ(history.cell(2, 1).lost_words, 0);
  const QStringList troubles = history.troubles();
  ASSERT_EQ(troubles.size(), 2);
  EXPECT_TRUE(troubles[0].startsWith(QLatin1String("hand: 2 word")));
  EXPECT_EQ(troubles[1], QStringLiteral("foot: pulled out for 0.5 s"));
}

TEST(BoxHistory, AGapOfTheLineIsLostOnAllWires) {
  BoxHistory history;
  std::vector<solve::BoxWire> wires{wire("head"), wire("hand")};
  history.add(0.0, wires, 0.005);  // before the recording
  history.add(1.0, wires, 0.01);
  for (solve::BoxWire& wire : wires) {
    wire.lost_frames += 1;  // in the gap, told a little later
  }
  history.add(1.2, wires, 0.01);
  history.add(2.0, wires, 0.01);
  EXPECT_EQ(history.cell(0, 0).condition, WireCondition::kWell);
  EXPECT_EQ(history.cell(0, 2).condition, WireCondition::kLost);
  EXPECT_EQ(history.cell(1, 2).condition, WireCondition::kLost);
  EXPECT_EQ(history.cell(1, 4).condition, WireCondition::kWell);
  EXPECT_EQ(history.cell(1, 3).condition, WireCondition::kUnknown) << "nobody looked there";
  EXPECT_EQ(history.troubles(), QStringList(QStringLiteral("0.005 s lost on the line")));
  // A line that was away for long is lost all the time.
  history.add(5.0, wires, 2.51);
  EXPECT_EQ(history.cell(0, 5).condition, WireCondition::kLost);
  EXPECT_EQ(history.cell(0, 9).condition, WireCondition::kLost);
  EXPECT_EQ(history.cell(0, 4).condition, WireCondition::kWell);
  EXPECT_EQ(history.troubles(), QStringList(QStringLiteral("2.5 s lost on the line")));
}

TEST(BoxHistory, TellsSilenceFromNoSourceInSight) {
  BoxHistory history;
  std::vector<solve::BoxWire> wires{wire("head"), wire("hand"), wire("foot")};
  wires[0].ranges_hz = 0.0;
  wires[1].locked = false;
  wires[2].clipped = true;
  history.add(0.0, wires, 0.0);
  EXPECT_EQ(history.cell(0, 0).condition, WireCondition::kUnseen);
  EXPECT_EQ(history.cell(1, 0).condition, WireCondition::kSilent);
  EXPECT_EQ(history.cell(2, 0).condition, WireCondition::kClips);
  EXPECT_EQ(history.troubles().size(), 2) << "a board out of sight is no trouble";
  EXPECT_TRUE(history.words(2, 0.2).contains(QLatin1String("clips"))) << history.words(2, 0.2).toStdString();
  EXPECT_TRUE(history.words(2, 9.0).isEmpty());
}

// Hours take no more than minutes: columns are joined, and what was wrong stays.
TEST(BoxHistory, ALongRecordingStaysSmallAndForgetsNothing) {
  BoxHistory history;
  std::vector<solve::BoxWire> wires{wire("head")};
  for (int i = 0; i < 4 * 3600 * 2; ++i) {
    wires[0].lost_frames += i == 5000 ? 1 : 0;
    history.add(0.5 * i, wires, 0.0);
  }
  EXPECT_LE(history.columns(), BoxHistory::kMost);
  EXPECT_GE(static_cast<double>(history.columns()) * history.column_s(), 4 * 3600.0 - 0.5);
  const auto at = static_cast<std::size_t>(2500.0 / history.column_s());
  EXPECT_EQ(history.cell(0, at).condition, WireCondition::kLost);
  EXPECT_EQ(history.cell(0, at + 1).condition, WireCondition::kWell);
  EXPECT_EQ(history.cell(0, at).lost_words, 1);
}

TEST(BoxHistory, AFinishedTakeShowsItsLevelsGapsAndPulledWires) {
  const test::TemporaryFolder folder;
  simulate::SimulateSettings settings;
  settings.rig = "driver-box-body";
  settings.motion = "walk";
  settings.errors_name = "calibrated";
  settings.seconds = 3.0;
  const std::filesystem::path path = folder.path() / "walk.take";
  testing_support::require(simulate::simulate_take(path, settings, {}));
  {
    std::ofstream events(path / "events.jsonl", std::ios::app);
    events << R"({"sample":140000,"kind":"dropped","text":"lost","count":1400})" << '\n'
           << R"({"sample":210000,"kind":"wire-pulled","text":"wire 3 was pulled out","count":2})" << '\n';
  }
  const take::Take take = testing_support::require(take::open_take(path));
  ASSERT_EQ(take.events.size(), 2U);
  const BoxHistory history = testing_support::require(BoxHistory::of_take(take, {}));
  ASSERT_EQ(history.wires(), 18U);
  EXPECT_NEAR(static_cast<double>(history.columns()) * history.column_s(), 3.0, 0.5);
  EXPECT_EQ(history.name(3).toStdString(), "head");
  EXPECT_GT(history.cell(4, 0).level, 0.01F);
  EXPECT_EQ(history.cell(4, 0).condition, WireCondition::kWell);
  EXPECT_EQ(history.cell(4, 2).condition, WireCondition::kLost);
  EXPECT_EQ(history.cell(2, 4).condition, WireCondition::kPulled);
  EXPECT_EQ(history.cell(3, 4).condition, WireCondition::kWell);
  int asked = 0;
  const Progress stop([&asked](double, std::string_view) { return ++asked < 2; });
  EXPECT_FALSE(BoxHistory::of_take(take, stop).ok());
}

}  // namespace
}  // namespace limbwave::ui
