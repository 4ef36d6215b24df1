/// What status strip and level check say, from made-up states of the line.
#include <gtest/gtest.h>

#include "workspaces/capture/level_advice.h"
#include "workspaces/layout_store.h"
#include "workspaces/status_facts.h"

namespace limbwave::ui {
namespace {

solve::LiveSnapshot good_snapshot() {
  solve::LiveSnapshot shot;
  shot.stream_time_s = 20.0;
  shot.line.decided = shot.line.locked = true;
  shot.line.cycle_rate_hz = 60.0;
  shot.line.left_peak = 0.4;
  shot.line.right_peak = 0.7;
  for (int i = 0; i < 5; ++i) {
    shot.health.push_back({solve::HealthState::kGood, "good", "good"});
  }
  return shot;
}

StatusFact fact(const StatusInput& input, const QString& id) {
  for (const StatusFact& one : status_facts(input)) {
    if (one.id == id) {
      return one;
    }
  }
  ADD_FAILURE() << "no fact " << id.toStdString();
  return {};
}

TEST(StatusFacts, QuietWithoutADevice) {
  for (const StatusFact& one : status_facts({})) {
    EXPECT_EQ(one.tone, Tone::kUnknown) << one.id.toStdString();
    EXPECT_FALSE(one.text.isEmpty());
  }
}

TEST(StatusFacts, AllWell) {
  const solve::LiveSnapshot shot = good_snapshot();
  StatusInput input{.state = LiveState::kRunning,
                    .recording = true,
                    .snapshot = &shot,
                    .disk_left_s = 82800.0,
                    .latency = {},
                    .problem = {},
                    .remedy = {}};
  auto& total = input.latency.stages[static_cast<std::size_t>(solve::LatencyStage::kTotal)];
  EXPECT_EQ(fact(input, "latency").tone, Tone::kUnknown);
  input.latency.poses = 600;
  total = {0.042, 0.055, 0.09};
  for (const StatusFact& one : status_facts(input)) {
    EXPECT_EQ(one.tone, Tone::kGood) << one.id.toStdString();
  }
  EXPECT_EQ(fact(input, "sensors").text, "sensors 5/5");
  EXPECT_EQ(fact(input, "latency").text, "latency 42 ms");
  EXPECT_TRUE(fact(input, "latency").detail.contains("55 ms")) << fact(input, "latency").detail.toStdString();
  total.p95_s = 0.081;
  EXPECT_EQ(fact(input, "latency").tone, Tone::kWarning);
}

TEST(StatusFacts, RedIsForLosingData) {
  solve::LiveSnapshot shot = good_snapshot();
  shot.line.locked = false;
  shot.health[2] = {solve::HealthState::kBad, "no-signal", "reads nothing; check that the sensor is plugged in"};
  StatusInput input{.state = LiveState::kRunning, .snapshot = &shot, .disk_left_s = 100.0, .problem = {}, .remedy = {}};
  for (const char* id : {"disk", "sync", "sensors"}) {
    EXPECT_EQ(fact(input, id).tone, Tone::kWarning) << id;
  }
  input.recording = true;
  for (const char* id : {"disk", "sync", "sensors"}) {
    EXPECT_EQ(fact(input, id).tone, Tone::kDanger) << id;
  }
  shot.counters.overflows = 3;
  EXPECT_EQ(fact(input, "record").tone, Tone::kDanger);
}

TEST(StatusFacts, LeadsToTheWorstSensor) {
  solve::LiveSnapshot shot = good_snapshot();
  shot.health[1].state = solve::HealthState::kWarning;
  shot.health[1].code = "saturated";
  shot.health[1].text = "clips";
  shot.health[3].state = solve::HealthState::kBad;
  shot.health[3].code = "no-signal";
  shot.health[3].text = "reads nothing";
  const StatusInput input{.state = LiveState::kRunning,
                          .recording = true,
                          .snapshot = &shot,
                          .disk_left_s = 82800.0,
                          .problem = {},
                          .remedy = {}};
  const StatusFact sensors = fact(input, "sensors");
  EXPECT_EQ(sensors.topic, "sensor:3");
  EXPECT_EQ(sensors.text, "sensors 4/5");
  EXPECT_TRUE(sensors.detail.contains("reads nothing"));
}

TEST(LevelAdvice, SaysWhatToDo) {
  EXPECT_EQ(level_advice(nullptr).front().tone, Tone::kUnknown);
  solve::LiveSnapshot shot = good_snapshot();
  EXPECT_EQ(level_advice(&shot).front().tone, Tone::kGood);
  shot.line.left_peak = 0.01;
  EXPECT_EQ(level_advice(&shot).front().title, "Too low");
  shot.line.left_peak = 0.99;
  EXPECT_EQ(level_advice(&shot).front().title, "Too high");
  shot.line.swapped = true;
  shot.line.right_peak = 0.4;
  EXPECT_EQ(level_advice(&shot).front().tone, Tone::kGood) << "swapped: the data are on the right";
  shot.line.swapped = false;
  shot.line.locked = false;
  EXPECT_EQ(level_advice(&shot).front().title, "This does not sound like the board");
  shot.line.left_peak = shot.line.right_peak = 0.0;
  EXPECT_EQ(level_advice(&shot).front().title, "Nothing comes in");
  shot.source_alive = false;
  EXPECT_EQ(level_advice(&shot).front().title, "The device has stopped sending");
}

TEST(LevelAdvice, TellsTheDecodersFindingsWhileTheyAreFresh) {
  solve::LiveSnapshot shot = good_snapshot();
  shot.diagnostics = {{Severity::kWarning, "line-in.clipping", "the left channel clips", "turn it down", "", 5.0},
                      {Severity::kInfo, "line-in.inverted", "the left channel is inverted", "", "", 19.5},
                      {Severity::kWarning, "line-in.hum", "hum", "use another cable", "", 18.0},
                      {Severity::kError, "line-in.mono", "both channels are the same", "use a stereo cable", "", 19.0},
                      {Severity::kWarning, "line-in.hum", "strong hum", "use another cable", "", 19.0}};
  EXPECT_EQ(level_advice(&shot).front().tone, Tone::kWarning) << "red is for losing data";
  shot.recording = true;
  const std::vector<Advice> advice = level_advice(&shot);
  ASSERT_EQ(advice.size(), 2U);
  EXPECT_EQ(advice[0].title, "Both channels are the same");
  EXPECT_EQ(advice[0].remedy, "Use a stereo cable.");
  EXPECT_EQ(advice[0].tone, Tone::kDanger);
  EXPECT_EQ(advice[1].title, "Strong hum");
}

TEST(LayoutStore, OnlyWhatWasSealedIsOpened) {
  const QByteArray state("dock state");
  const QByteArray sealed = seal_layout(state);
  EXPECT_EQ(unseal_layout(sealed), state);
  EXPECT_FALSE(unseal_layout({}).has_value());
  EXPECT_FALSE(unseal_layout(state).has_value());
  EXPECT_FALSE(unseal_layout(sealed.left(20)).has_value());
  for (qsizetype i = 0; i < sealed.size(); ++i) {
    QByteArray broken = sealed;
    broken[i] = static_cast<char>(broken[i] ^ 0x40);
    EXPECT_FALSE(unseal_layout(broken).has_value()) << i;
  }
  EXPECT_FALSE(unseal_layout(sealed + QByteArray(1 << 20, 'x')).has_value());
}

}  // namespace
}  // namespace limbwave::ui
