// What the threads of a live capture do with what a box says, beside solving: no sample of it means anything.
#include <gtest/gtest.h>

#include <atomic>
#include <deque>
#include <mutex>
#include <thread>

#include "solve/live_body_session.h"
#include "support/simulated_take.h"

namespace limbwave {
namespace {

using testing_support::require;

constexpr std::int64_t kRound = 8 * 1120;

// A box that says what the test tells it to, silence between.
class ScriptedBox : public acquire::BoxSource {
 public:
  [[nodiscard]] acquire::BoxHello hello() const override { return {}; }
  [[nodiscard]] acquire::StreamFormat format() const override {
    return {SampleRate{140000.0}, 18, acquire::SampleType::kInt16};
  }
  [[nodiscard]] std::string title() const override { return "scripted box"; }
  Status set_schedule(const std::vector<std::uint8_t>& schedule) override {
    schedule_ = schedule;
    return {};
  }
  Status start() override { return {}; }
  void stop() override {}
  acquire::BoxPart pull(double /*timeout_s*/) override {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    const std::scoped_lock lock(mutex_);
    acquire::BoxPart part;
    if (lost_ > 0) {
      acquire::BoxPiece gap;
      gap.lost = std::exchange(lost_, 0);
      part.events.push_back({SampleIndex{position_}, "dropped", "lost", gap.lost});
      position_ += gap.lost;
      part.pieces.push_back(std::move(gap));
    }
    acquire::BoxPiece piece;
    piece.bytes.resize(static_cast<std::size_t>(700 * 18 * 2));
    part.pieces.push_back(std::move(piece));
    for (acquire::BoxEvent& event : events_) {
      event.sample = SampleIndex{position_};
      part.events.push_back(event);
    }
    events_.clear();
    position_ += 700;
    ++pulls;
    return part;
  }
  [[nodiscard]] acquire::BoxCounters counters() const override { return {}; }
  [[nodiscard]] acquire::BoxStatus status() const override { return {}; }
  [[nodiscard]] bool connected() const override { return true; }

  void say(const std::string& kind, std::int64_t count) {
    const std::scoped_lock lock(mutex_);
    events_.push_back({SampleIndex{0}, kind, kind, count});
  }
  void lose(std::int64_t frames) {
    const std::scoped_lock lock(mutex_);
    lost_ = frames;
  }
  std::atomic<int> pulls{0};

 private:
  std::mutex mutex_;
  std::vector<acquire::BoxEvent> events_;
  std::vector<std::uint8_t> schedule_;
  std::int64_t position_ = 0, lost_ = 0;
};

class LiveBodyWorker : public testing::Test {
 protected:
  LiveBodyWorker() {
    settings_.rig = require(body::load_rig("driver-box-body"));
    settings_.skeleton = require(body::load_skeleton(settings_.rig.skeleton));
    auto box = std::make_unique<ScriptedBox>();
    box_ = box.get();
    session_ = std::make_unique<solve::LiveBodySession>(std::move(box), settings_);
    require(session_->start());
  }
  void wait_for_pulls(int more) const {
    const int until = box_->pulls + more;
    while (box_->pulls < until) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }
  take::Take record(const char* name, const std::function<void()>& meanwhile = {}) {
    require(session_->start_recording(folder_.path() / name, "somebody"));
    wait_for_pulls(20);
    if (meanwhile) {
      meanwhile();
      wait_for_pulls(20);
    }
    return require(session_->stop_recording());
  }
  static std::vector<std::pair<std::string, std::int64_t>> wires_in(const take::Take& take) {
    std::vector<std::pair<std::string, std::int64_t>> events;
    for (const take::TakeEvent& event : take.events) {
      if (event.kind.starts_with("wire")) {
        events.emplace_back(event.kind, event.count);
      }
    }
    return events;
  }

  test::TemporaryFolder folder_;
  solve::LiveBodySettings settings_;
  std::unique_ptr<solve::LiveBodySession> session_;
  ScriptedBox* box_ = nullptr;
};

// A take says which wires were out when it began: its own events alone would not tell.
TEST_F(LiveBodyWorker, AWireThatWasOutBeforeTheRecordingIsInItsEvents) {
  using Events = std::vector<std::pair<std::string, std::int64_t>>;
  box_->say("wire-pulled", 4);
  box_->say("wire-pulled", 11);
  box_->say("wire-back", 11);
  box_->say("wire-pulled", 99);  // of no wire that there is
  wait_for_pulls(3);
  take::Take take = record("first.take");
  EXPECT_EQ(wires_in(take), (Events{{"wire-pulled", 4}}));
  EXPECT_EQ(take.events.front().sample.value, 0);
  take = record("second.take", [&] { box_->say("wire-back", 4); });
  EXPECT_EQ(wires_in(take), (Events{{"wire-pulled", 4}, {"wire-back", 4}}));
  EXPECT_EQ(wires_in(record("third.take")), Events());
}

TEST_F(LiveBodyWorker, ATakeBeginsWithARoundAndKeepsTheLengthOfGaps) {
  const take::Take take = record("gap.take", [&] { box_->lose(5 * kRound + 77); });
  std::int64_t lost = 0;
  for (const take::TakeEvent& event : take.events) {
    lost += event.kind == "dropped" ? event.count : 0;
  }
  EXPECT_EQ(lost, 5 * kRound + 77);
  EXPECT_GE(take.info.frames, lost + 700 * 20);
}

TEST_F(LiveBodyWorker, OneRecordingAtATimeAndNoneIsToldToo) {
  EXPECT_FALSE(session_->stop_recording().ok());
  EXPECT_FALSE(session_->mark("too early").has_value());
  require(session_->start_recording(folder_.path() / "one.take", ""));
  EXPECT_FALSE(session_->start_recording(folder_.path() / "two.take", "").ok());
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "two.take"));
  const auto first = session_->mark("a");
  const auto second = session_->mark("b");
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->count, 1);
  EXPECT_EQ(second->count, 2);
  EXPECT_TRUE(session_->stop_recording().ok());
}

// Faces see the newest state however little the filter has to say, and its end.
TEST_F(LiveBodyWorker, SnapshotsGoOnAndSayWhenItIsOver) {
  const std::uint64_t before = session_->snapshot()->version;
  wait_for_pulls(40);
  const auto running = session_->snapshot();
  EXPECT_GT(running->version, before);
  EXPECT_TRUE(running->running);
  EXPECT_EQ(running->title, "scripted box");
  EXPECT_FALSE(running->started) << "silence starts no filter";
  EXPECT_EQ(session_->figure(), nullptr);
  (void)session_->stop();
  EXPECT_FALSE(session_->snapshot()->running);
}

}  // namespace
}  // namespace limbwave
